#include "renderer/view/scatter_field.h"

#include <algorithm>

#include "renderer/shaders/shared/scatter.h"

namespace pileus::view {

Result<ScatterField> ScatterField::create(transport::Solution solution, const vec3& lightScale) {
  ScatterField out;
  const ivec3 cells = glm::max(solution.lattice.cells, ivec3(1));
  const ivec3 size(cells.x, cells.y, 3 * cells.z);
  PILEUS_TRY(out.moments_, gl::Texture::create(GL_TEXTURE_3D, GL_RGBA32F, size, "scattered light"));
  if (solution.moments.empty())
    out.moments_.clear();
  else
    glTextureSubImage3D(out.moments_.id(), 0, 0, 0, 0, size.x, size.y, size.z, GL_RGBA, GL_FLOAT,
                        solution.moments.data());
  out.moments_.filter(GL_LINEAR);
  out.moments_.wrap(GL_CLAMP_TO_EDGE);
  solution.moments = {};
  out.solution_ = std::move(solution);
  out.lightScale_ = lightScale;
  return out;
}

void ScatterField::bind(gl::Program& program, const dvec3& origin) const {
  const transport::Lattice& lattice = solution_.lattice;
  glBindTextureUnit(UNIT_SCATTER, moments_.id());
  program.set("scatterMin", vec3(lattice.min - origin));
  program.set("scatterPerMetre", vec3(1.0 / (lattice.cell * dvec3(glm::max(lattice.cells, ivec3(1))))));
  program.set("scatterCell", float(lattice.cell));
  program.set("lightScale", lightScale_);
}

}  // namespace pileus::view
