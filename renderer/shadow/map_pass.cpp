#include "renderer/shadow/map_pass.h"

#include <algorithm>
#include <optional>

#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {
namespace {

/// Bounds of a box on one face in texels of that face, not clamped; nothing where the face cannot see it.
std::optional<std::pair<dvec2, dvec2>> faceBounds(const Box3& local, const dmat4& lightFromLocal,
                                                  const LightFrustum& f, int face, int resolution) {
  dvec2 lo(1e9), hi(-1e9);
  bool behind = false, front = false;
  const double scale = f.kind == scene::LightKind::Point ? 1 - 2.0 / resolution : 1;
  for (int c = 0; c < 8; ++c) {
    const dvec3 q(lightFromLocal * dvec4(local.corner(c), 1.0));
    if (!f.perspective()) {
      lo = glm::min(lo, dvec2(q)), hi = glm::max(hi, dvec2(q));
      front = true;
      continue;
    }
    const int axis = face >> 1;
    const bool point = f.kind == scene::LightKind::Point;
    const double depth = point ? (face & 1 ? -q[axis] : q[axis]) : q.z;
    const dvec2 across = point ? dvec2(q[(axis + 1) % 3], q[(axis + 2) % 3]) : dvec2(q);
    front |= depth > 0;
    if (depth <= 1e-6 * glm::length(q) + 1e-12) {
      behind = true;
      continue;
    }
    const dvec2 uv = 0.5 + 0.5 * scale * across / (depth * f.tanHalf);
    lo = glm::min(lo, uv), hi = glm::max(hi, uv);
  }
  if (!front) return std::nullopt;
  if (behind) return std::pair(dvec2(0), dvec2(resolution));
  return std::pair(lo * double(resolution), hi * double(resolution));
}

}  // namespace

std::vector<residency::PixelBounds> mapBounds(const volume::InstanceList& instances, const LightFrustum& f,
                                              int resolution, int faceStride) {
  const dmat4 lightFromWorld = glm::inverse(f.worldFromLight);
  std::vector<residency::PixelBounds> out;
  for (int face = 0; face < f.faces(); ++face)
    for (const volume::Instance& i : instances) {
      const auto bounds =
          faceBounds(volume::localBounds(i), lightFromWorld * i.worldFromLocal, f, face, resolution);
      if (!bounds) {
        out.push_back({});
        continue;
      }
      // Only what lies on this face: rows of the next one are not its own.
      const ivec2 lo(glm::floor(glm::clamp(bounds->first - 1.0, dvec2(0), dvec2(resolution))));
      const ivec2 hi(glm::ceil(glm::clamp(bounds->second + 1.0, dvec2(0), dvec2(resolution))));
      out.push_back({lo + ivec2(0, face * faceStride), hi + ivec2(0, face * faceStride)});
    }
  return out;
}

double mostSteps(const volume::InstanceList& volumes) {
  double most = 1;
  for (const volume::Instance& i : volumes) {
    const dvec3 size = volume::localBounds(i).size();
    double way = 0;
    for (int axis = 0; axis < 3; ++axis) way += glm::length(dvec3(i.worldFromLocal[axis])) * size[axis];
    most =
        std::max(most, i.shape == volume::Shape::Grid ? std::min(way / volume::detailSize(i), 8192.0) : 64.0);
  }
  return most;
}

MapPass::MapPass(const volume::InstanceList& volumes, const LightFrustum& frustum, int resolution,
                 int softwareTiles)
    : volumes_(residency::canonical(volumes)),
      frustum_(frustum),
      resolution_(resolution),
      softwareTiles_(softwareTiles) {}

Result<double> MapPass::prepare(const Gpu& gpu, double ms) {
  PILEUS_TRY(const residency::Residency residency, run_.prepare(gpu.bricks, volumes_, ms, origin()));
  if (residency.fraction < 1) return residency.fraction;
  if (!ready_) {
    run_.list(tallSize(), mapBounds(run_.volumes(), frustum_, resolution_, faceStride()),
              std::max(int(volumes_.size()), 1));
    run_.cursor = gl::RegionCursor(tallSize(), gpu.device, softwareTiles_);
    ready_ = true;
  }
  return 1.0;
}

Result<void> MapPass::bindLight(const ShadowMap& map) {
  const gpu::LightRecord record = makeRecord(map.light, &map, origin());
  PILEUS_CHECK(record_.reserve(MAX_LIGHTS * sizeof record));
  PILEUS_CHECK(record_.assign(&record, sizeof record));
  record_.bindUniform(BIND_LIGHTS);
  return {};
}

Result<void> MapPass::bind(const Gpu& gpu, gl::Program& program) {
  PILEUS_CHECK(run_.bind(gpu.bricks, program));
  gpu.store.bind();
  program.set("regionOrigin", run_.cursor.origin());
  program.set("regionEnd", run_.cursor.end());
  program.set("faceStride", frustum_.faces() == 1 ? 1 << 20 : faceStride());
  program.set("mapEdge", resolution_);
  // A texel's width: constant for a sun, growing from the light otherwise.
  program.set("footprint", frustum_.perspective() ? 0.0f : float(frustum_.texelSize(resolution_)));
  program.set("footprintAngle", frustum_.perspective() ? float(2 * frustum_.tanHalf / resolution_) : 0.0f);
  return {};
}

Result<void> MapPass::dispatch(const Gpu& gpu, gl::Program& program) {
  PILEUS_CHECK(bind(gpu, program));
  PILEUS_CHECK(run_.dispatch(program));
  return {};
}

}  // namespace pileus::shadow
