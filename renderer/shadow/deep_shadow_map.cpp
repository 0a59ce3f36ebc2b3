#include "renderer/shadow/deep_shadow_map.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/new_map.h"

namespace pileus::shadow {
namespace {

constexpr int kMostDoublings = 14;  ///< from 5e-5 to more than 0.5

/// Twin of boundAfter in deep_map.comp.glsl.
double boundAfter(double errorBound, int doublings) {
  return doublings == 0 ? errorBound : std::ldexp(std::max(errorBound, 5e-5), doublings);
}

}  // namespace

DeepShadowPass::DeepShadowPass(const ShadowSpec& spec, const scene::Light& light,
                               const volume::InstanceList& volumes, const scene::SolidList& solids,
                               const LightFrustum& frustum)
    : pass_(volumes, frustum, spec.resolution),
      map_(newMap(ShadowMap::Kind::Deep, spec, light, pass_.volumes(), solids, frustum)) {}

Result<void> DeepShadowPass::run(const Gpu& gpu, bool fill) {
  const int filter = std::clamp(map_->spec.filter, 1, 4);
  if (!march_) march_.emplace(pass_, 1, filter * filter + 8);
  gl::Defines defines = march_->defines();
  defines.insert(defines.end(), {{"FILL", fill}, {"FILTER", filter}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"shadow/deep_map.comp.glsl"}, defines));
  program->use();
  program->set("errorBound", float(map_->spec.errorBound));
  program->set("nodeBudget", map_->spec.nodeBudget);
  if (fill) {
    map_->deep->bindImage(IMAGE_TARGET);
    program->set("blockFirst", int(map_->deep->first()));
  }
  glBindImageTexture(IMAGE_TARGET + 1, counts_.id(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_RGBA32UI);
  for (int doublings = 0; doublings <= kMostDoublings; ++doublings) {
    program->set("doublings", doublings);
    PILEUS_CHECK(march_->run(gpu, pass_, *program));
    if (fill || !overBudget()) break;
  }
  return {};
}

/// Does any texel of the region just counted need more vertices than it may keep?
bool DeepShadowPass::overBudget() const {
  const ivec2 origin = pass_.regionOrigin(), end = pass_.regionEnd();
  const int edge = pass_.resolution();
  std::vector<uvec4> counts;
  for (int face = 0; face < map_->frustum.faces(); ++face) {
    const int top = face * pass_.faceStride();
    const int lo = std::max(origin.y - top, 0), hi = std::min(end.y - top, edge);
    if (lo >= hi) continue;
    const ivec2 size(end.x - origin.x, hi - lo);
    counts.resize(std::size_t(size.x) * std::size_t(size.y));
    glGetTextureSubImage(counts_.id(), 0, origin.x, lo, face, size.x, size.y, 1, GL_RGBA_INTEGER,
                         GL_UNSIGNED_INT, GLsizei(counts.size() * sizeof(uvec4)), counts.data());
    if (std::any_of(counts.begin(), counts.end(),
                    [&](const uvec4& c) { return int(c.x) > map_->spec.nodeBudget; }))
      return true;
  }
  return false;
}

/// Gives each texel its place behind the headers.
Result<void> DeepShadowPass::place(const Gpu& gpu) {
  const int edge = pass_.resolution(), faces = map_->frustum.faces();
  const std::size_t faceTexels = std::size_t(edge) * std::size_t(edge);
  std::vector<uvec4> counts(faceTexels);
  std::vector<uvec2> headers(faceTexels * std::size_t(faces));
  statistics_ = {};
  statistics_.texels = headers.size();
  std::size_t next = headers.size(), header = 0;
  for (int face = 0; face < faces; ++face) {
    glGetTextureSubImage(counts_.id(), 0, 0, 0, face, edge, edge, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                         GLsizei(faceTexels * sizeof(uvec4)), counts.data());
    for (uvec4& c : counts) {
      c.w = std::uint32_t(next);
      headers[header++] = uvec2(c.w, c.x);
      next += c.x;
      statistics_.vertices += c.x;
      statistics_.rawVertices += c.y;
      if (c.z > 0) ++statistics_.overBudget;
      if (c.x > 0)
        statistics_.worstBound =
            std::max(statistics_.worstBound, boundAfter(map_->spec.errorBound, int(c.z)));
    }
    glTextureSubImage3D(counts_.id(), 0, 0, 0, face, edge, edge, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                        counts.data());
  }
  PILEUS_TRY(map_->deep, gpu.store.allocateDeep(next));
  map_->deep->write(0, headers);
  return {};
}

Result<double> DeepShadowPass::step(const Gpu& gpu, double ms) {
  const Stopwatch clock;
  PILEUS_TRY(const double resident, pass_.prepare(gpu, ms));
  if (resident < 1) return 0.2 * resident;
  if (!counts_) {
    const ivec3 size(ivec2(pass_.resolution()), map_->frustum.faces());
    PILEUS_TRY(counts_, gl::Texture::create(GL_TEXTURE_2D_ARRAY, GL_RGBA32UI, size, "deep map counts"));
    const uvec4 zero(0);
    glClearTexImage(counts_.id(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, &zero);
  }
  PILEUS_CHECK(pass_.bindLight(*map_));
  const bool fill = map_->deep != nullptr;
  do {
    PILEUS_CHECK(run(gpu, fill));
    pass_.next();
  } while (!pass_.done() && clock.ms() < ms);
  if (!fill) {
    if (!pass_.done()) return 0.2 + 0.4 * pass_.fraction();
    PILEUS_CHECK(place(gpu));
    pass_.restart();
    return 0.6;
  }
  return 0.6 + 0.4 * pass_.fraction();
}

}  // namespace pileus::shadow
