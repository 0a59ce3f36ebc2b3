#include "renderer/view/visible_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pileus::view {
namespace {

constexpr int kSteps = 1024;

struct Range {
  dvec2 t{0};
  const volume::Instance* instance = nullptr;
};

std::vector<Range> crossed(const volume::InstanceList& volumes, const dvec3& eye, const dvec3& d) {
  std::vector<Range> out;
  for (const volume::Instance& i : volumes) {
    const Box3 bounds = volume::localBounds(i);
    if (bounds.empty() || std::abs(glm::determinant(glm::dmat3(i.worldFromLocal))) < 1e-30) continue;
    const dmat4 local = glm::inverse(i.worldFromLocal);
    const dvec3 lo(local * dvec4(eye, 1)), ld(local * dvec4(d, 0));
    const auto hit =
        i.shape == volume::Shape::Ball ? intersectBall(lo, ld) : intersectBox(lo, ld, bounds.min, bounds.max);
    if (hit && hit->y > 0) out.push_back({dvec2(std::max(hit->x, 0.0), hit->y), &i});
  }
  return out;
}

}  // namespace

std::optional<dvec3> visiblePoint(const RenderScene& scene, dvec2 uv) {
  const scene::Camera& camera = scene.options.camera;
  const dvec3 d = scene::rayDirection(camera, double(scene.options.size.x) / scene.options.size.y, uv);
  double end = std::numeric_limits<double>::infinity();
  for (const scene::Solid& s : scene.solids)
    if (const auto hit = scene::intersect(s, camera.eye, d)) end = std::min(end, hit->t);
  const std::vector<Range> ranges = crossed(scene.volumes, camera.eye, d);
  double lo = std::numeric_limits<double>::infinity(), hi = 0;
  for (const Range& r : ranges) lo = std::min(lo, r.t.x), hi = std::max(hi, r.t.y);
  hi = std::min(hi, end);

  std::vector<double> scattered;
  double T = 1;
  const double ds = (hi - lo) / kSteps;
  if (lo < hi)
    for (int k = 0; k < kSteps && T > 1e-4; ++k) {
      const double t = lo + (k + 0.5) * ds;
      double sigma = 0;
      for (const Range& r : ranges)
        if (t >= r.t.x && t <= r.t.y) sigma += volume::sigmaAt(*r.instance, camera.eye + t * d);
      const double step = std::exp(-sigma * ds);
      scattered.push_back(T * (1 - step));
      T *= step;
    }
  if (std::isfinite(end) && T >= 0.5) return camera.eye + end * d;
  if (1 - T < 1e-6) return std::nullopt;
  double sum = 0;
  for (std::size_t k = 0; k < scattered.size(); ++k)
    if ((sum += scattered[k]) >= 0.5 * (1 - T)) return camera.eye + (lo + (double(k) + 0.5) * ds) * d;
  return std::nullopt;
}

std::optional<dvec2> pictureUv(const RenderOptions& o, const dvec3& point) {
  const dvec3 p = glm::transpose(scene::basis(o.camera)) * (point - o.camera.eye);
  if (!(-p.z > 0)) return std::nullopt;
  const double th = std::tan(glm::radians(o.camera.fov) / 2), tw = th * o.size.x / o.size.y;
  return dvec2(0.5 + 0.5 * p.x / (-p.z * tw), 0.5 - 0.5 * p.y / (-p.z * th));
}

}  // namespace pileus::view
