#include "renderer/truth/shadow_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/base/profile.h"
#include "renderer/residency/volume_set.h"
#include "renderer/shadow/light_frustum.h"
#include "renderer/shadow/reference.h"

namespace pileus::truth {
namespace {

constexpr int kRound = 2048;      ///< points tried between two looks at the clock
constexpr int kMisses = 1 << 18;  ///< rays in a row that may meet nothing

/// A light ray and the parts [x, y] of it, in metres from `from`, that may hold a medium: disjoint and
/// rising.
struct Ray {
  dvec3 from{0}, direction{0};
  double length = 0;
  std::vector<dvec2> parts;
  double covered = 0;  ///< metres in all parts
};

/// Random light rays: a ray is drawn from three uniform numbers.
class RaySource {
 public:
  RaySource(const scene::Light& light, const volume::InstanceList& volumes)
      : light_(light), volumes_(volumes) {
    for (const volume::Instance& i : volumes_) localFromWorld_.push_back(glm::inverse(i.worldFromLocal));
    if (light.kind == scene::LightKind::Sun) {
      frustum_ = shadow::fitLight(light, volumes, 1024);
      return;
    }
    // The narrower of two cones: about the ball around the media, and the spot's own.
    const Box3 bounds = volume::worldBounds(volumes);
    const double radius = 0.5 * glm::length(bounds.size()),
                 distance = glm::length(bounds.center() - light.position);
    reach_ = radius + distance;
    if (distance > radius)
      axis_ = (bounds.center() - light.position) / distance,
      cosine_ = std::sqrt(1 - radius * radius / (distance * distance));
    if (light.kind != scene::LightKind::Spot) return;
    spotCosine_ = std::cos(glm::radians(light.cone / 2));
    if (spotCosine_ > cosine_) axis_ = -light.towards, cosine_ = spotCosine_;
  }

  Ray draw(std::mt19937_64& rng) const {
    std::uniform_real_distribution<double> uniform(0, 1);
    const double a = uniform(rng), b = uniform(rng);
    Ray ray;
    if (light_.kind == scene::LightKind::Sun) {
      const shadow::MapSegment s = shadow::mapSegment(frustum_, 0, dvec2(a, b), 1024);
      ray.from = s.from;
      ray.length = glm::length(s.to - s.from);
      ray.direction = (s.to - s.from) / ray.length;
    } else {
      const double z = 1 - a * (1 - cosine_), r = std::sqrt(std::max(0.0, 1 - z * z));
      const dvec3 side =
          glm::normalize(glm::cross(axis_, std::abs(axis_.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
      ray.from = light_.position;
      ray.length = reach_;
      ray.direction =
          z * axis_ + r * (std::cos(2 * kPi * b) * side + std::sin(2 * kPi * b) * glm::cross(axis_, side));
      if (glm::dot(ray.direction, -light_.towards) < spotCosine_) return ray;
    }
    cover(ray);
    return ray;
  }

 private:
  void cover(Ray& ray) const {
    std::vector<dvec2> hits;
    for (std::size_t i = 0; i < volumes_.size(); ++i) {
      const dvec3 o(localFromWorld_[i] * dvec4(ray.from, 1.0)),
          d(localFromWorld_[i] * dvec4(ray.direction, 0.0));
      const Box3 box = volume::localBounds(volumes_[i]);
      const auto hit = volumes_[i].shape == volume::Shape::Ball ? intersectBall(o, d)
                                                                : intersectBox(o, d, box.min, box.max);
      if (!hit) continue;
      const dvec2 inside(std::max(hit->x, 0.0), std::min(hit->y, ray.length));
      if (inside.x < inside.y) hits.push_back(inside);
    }
    std::sort(hits.begin(), hits.end(), [](const dvec2& l, const dvec2& r) { return l.x < r.x; });
    for (const dvec2& h : hits) {
      if (!ray.parts.empty() && h.x <= ray.parts.back().y)
        ray.parts.back().y = std::max(ray.parts.back().y, h.y);
      else
        ray.parts.push_back(h);
    }
    for (const dvec2& p : ray.parts) ray.covered += p.y - p.x;
  }

  const scene::Light& light_;
  const volume::InstanceList& volumes_;
  std::vector<dmat4> localFromWorld_;
  shadow::LightFrustum frustum_;
  dvec3 axis_{0, 1, 0};
  double cosine_ = -1, spotCosine_ = -2, reach_ = 0;
};

/// The accepted ones of the points at `distances` (metres along the covered parts, rising).
ShadowSamples judge(const Ray& ray, const std::vector<double>& distances, const volume::InstanceList& volumes,
                    const dvec3& origin) {
  ShadowSamples out;
  std::vector<double> at;
  for (const double distance : distances) {
    double t = distance;
    std::size_t part = 0;
    while (part + 1 < ray.parts.size() && t > ray.parts[part].y - ray.parts[part].x)
      t -= ray.parts[part].y - ray.parts[part].x, ++part;
    t += ray.parts[part].x;
    const vec3 p(ray.from - origin + ray.direction * t);
    if (std::none_of(volumes.begin(), volumes.end(),
                     [&](const auto& v) { return volume::sigmaAt(v, origin + dvec3(p)) > 0; }))
      continue;
    out.positions.push_back(vec4(p, 0));
    at.push_back(std::min(t / ray.length, 1.0));
  }
  if (at.empty()) return out;
  out.transmittance =
      shadow::cumulativeOpticalDepth(volumes, ray.from, ray.from + ray.direction * ray.length, at);
  for (double& t : out.transmittance) t = std::exp(-t);
  return out;
}

}  // namespace

Result<ShadowSamples> sampleShadow(const scene::Light& light, const volume::InstanceList& all,
                                   const SampleOptions& options, JobControl& control) {
  const Stopwatch clock;
  const volume::InstanceList volumes = residency::canonical(all);
  const RaySource source(light, volumes);
  std::mt19937_64 rng(options.seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  ShadowSamples samples;
  if (!volumes.empty()) samples.origin = volume::worldBounds(volumes).center();
  int barren = 0;
  while (samples.positions.size() < std::size_t(options.count)) {
    std::vector<Ray> rays;
    double covered = 0;
    for (int misses = 0; int(rays.size()) * options.perRay < kRound;) {
      if (control.cancelled()) return fail(Code::Cancelled, "cancelled");
      Ray ray = volumes.empty() ? Ray{} : source.draw(rng);
      if (ray.covered > 0) {
        covered += ray.covered;
        rays.push_back(std::move(ray));
      } else if (volumes.empty() || ++misses == kMisses) {
        return fail(Code::Input, "no ray of the light meets a medium");
      }
    }
    // One point in each of kRound equal pieces of the covered length.
    std::vector<std::vector<double>> distances(rays.size());
    double before = 0;
    std::size_t ray = 0;
    for (int i = 0; i < kRound; ++i) {
      const double at = (i + uniform(rng)) / kRound * covered;
      while (ray + 1 < rays.size() && at > before + rays[ray].covered) before += rays[ray++].covered;
      distances[ray].push_back(std::min(at - before, rays[ray].covered));
    }
    std::vector<ShadowSamples> found(rays.size());
    tbb::parallel_for(std::size_t(0), rays.size(), [&](std::size_t i) {
      found[i] = judge(rays[i], distances[i], volumes, samples.origin);
    });
    const std::size_t had = samples.positions.size();
    for (const ShadowSamples& s : found) {
      samples.positions.insert(samples.positions.end(), s.positions.begin(), s.positions.end());
      samples.transmittance.insert(samples.transmittance.end(), s.transmittance.begin(),
                                   s.transmittance.end());
    }
    control.progress(double(samples.positions.size()) / options.count);
    barren = samples.positions.size() > had ? 0 : barren + 1;
    if (barren == 64) return fail(Code::Input, "no ray of the light meets a medium that is not empty");
    if (clock.ms() > options.limitMs && samples.positions.size() >= kRound) break;
  }
  if (samples.positions.size() > std::size_t(options.count)) {
    samples.positions.resize(std::size_t(options.count));
    samples.transmittance.resize(std::size_t(options.count));
  }
  return samples;
}

}  // namespace pileus::truth
