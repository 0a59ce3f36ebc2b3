#include "renderer/view/scatter_field.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/shaders/shared/scatter.h"

namespace pileus::view {

Result<ScatterField> ScatterField::create(std::vector<transport::Solution> solutions) {
  ScatterField out;
  ivec3 size(1, 1, 0);
  for (const transport::Solution& s : solutions) {
    const ivec3 cells = s.lattice.cells;
    size = ivec3(glm::max(ivec2(size), ivec2(cells)), size.z + 3 * cells.z);
  }
  size.z = std::max(size.z, 1);
  PILEUS_TRY(out.moments_, gl::Texture::create(GL_TEXTURE_3D, GL_RGBA32F, size, "scattered light"));
  out.moments_.clear();
  int layer = 0;
  for (transport::Solution& s : solutions) {
    const ivec3 cells = s.lattice.cells;
    if (!s.moments.empty())
      glTextureSubImage3D(out.moments_.id(), 0, 0, 0, layer, cells.x, cells.y, 3 * cells.z, GL_RGBA, GL_FLOAT,
                          s.moments.data());
    layer += 3 * cells.z;
    s.moments = {};
  }
  out.moments_.filter(GL_LINEAR);
  out.moments_.wrap(GL_CLAMP_TO_EDGE);
  out.solutions_ = std::move(solutions);
  return out;
}

void ScatterField::bind(gl::Program& program, const dvec3& origin) const {
  glBindTextureUnit(UNIT_SCATTER, moments_.id());
  int layer = 0;
  for (std::size_t i = 0; i < SCATTER_LATTICES; ++i) {
    const transport::Lattice lattice = i < solutions_.size() ? solutions_[i].lattice : transport::Lattice{};
    const ivec3 cells = glm::max(lattice.cells, ivec3(1));
    program.set(fmt::format("scatterMin[{}]", i).c_str(),
                vec4(vec3(lattice.min - origin), float(lattice.cell)));
    program.set(fmt::format("scatterCells[{}]", i).c_str(), ivec4(cells, layer));
    if (i < solutions_.size()) layer += 3 * cells.z;
  }
  program.set("scatterCellDepth", float(transport::kCellDepth));
  program.set("scatterCount", std::max(int(solutions_.size()), 1));
}

}  // namespace pileus::view
