#pragma once
// Single scattering along one camera ray by quadrature in double precision on the CPU: nothing of the
// renderer but volume::sigmaAt, scene::incidence and shadow::reference, which have tests of their own.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "renderer/shadow/reference.h"
#include "tests/support/lit.h"

namespace pileus::test {

/// Transmittance between a light and each of some points.
using Transmittance = std::function<std::vector<double>(const std::vector<dvec3>&)>;

struct ExactLight {
  scene::Light light;
  Transmittance transmittance;
};

inline ExactLight exactly(const volume::InstanceList& volumes, const scene::Light& light) {
  return {light, [=](const std::vector<dvec3>& at) {
            std::vector<double> out;
            for (const dvec3& p : at)
              out.push_back(std::exp(-shadow::opticalDepthToLight(volumes, light, p)));
            return out;
          }};
}

/// As the shader's own lookup has it.
inline ExactLight asLookedUp(const shadow::ShadowedLight& lit) {
  return {lit.light, [=](const std::vector<dvec3>& at) {
            std::vector<vec3> points;
            for (const dvec3& p : at) points.emplace_back(p);
            std::vector<double> out;
            for (const float tau : lookupTau(*lit.shadow, lit.light, points))
              out.push_back(std::exp(-double(tau)));
            return out;
          }};
}

struct Exact {
  dvec3 radiance{0};
  double alpha = 0;
};

/// The places between which `exactAlong` integrates, rising: dense at the ends of each volume and, both ways,
/// about the point nearest to each local light.
inline std::vector<double> quadraturePlaces(const volume::InstanceList& volumes,
                                            const std::vector<ExactLight>& lights, const dvec3& eye,
                                            const dvec3& d, int perDecade) {
  std::vector<double> ends, at;
  double last = 0;
  for (const volume::Instance& v : volumes) {
    const dmat4 local = glm::inverse(v.worldFromLocal);
    const dvec3 o(local * dvec4(eye, 1)), ld(local * dvec4(d, 0));
    const Box3 bounds = volume::localBounds(v);
    const auto hit =
        v.shape == volume::Shape::Ball ? intersectBall(o, ld) : intersectBox(o, ld, bounds.min, bounds.max);
    if (!hit || hit->y <= 0) continue;
    ends.push_back(std::max(hit->x, 0.0));
    ends.push_back(hit->y);
    last = std::max(last, hit->y);
    if (v.shape == volume::Shape::Grid) {  // twice a voxel
      const double voxel = 0.5 * volume::detailSize(v);
      for (double t = std::max(hit->x, 0.0); t < hit->y; t += voxel) at.push_back(t);
    }
  }
  if (ends.empty()) return {};
  for (const ExactLight& l : lights) {
    const double nearest = glm::dot(l.light.position - eye, d);
    if (l.light.kind != scene::LightKind::Sun && nearest > 0 && nearest < last) ends.push_back(nearest);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double a = ends[i], length = ends[i + 1] - a;
    if (!(length > 0)) continue;
    at.push_back(a);
    for (int k = 0; k < 9 * perDecade; ++k) {
      const double part = 0.5 * length * std::pow(10.0, -k / double(perDecade));
      at.push_back(a + part), at.push_back(ends[i + 1] - part);
    }
    at.push_back(ends[i + 1]);
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

/// L and alpha of the ray from the eye along the unit direction d.
inline Exact exactAlong(const volume::InstanceList& volumes, const std::vector<ExactLight>& lights,
                        const dvec3& eye, const dvec3& d, int perDecade = 100) {
  Exact sum;
  const std::vector<double> at = quadraturePlaces(volumes, lights, eye, d, perDecade);
  if (at.size() < 2) return sum;
  const double last = at.back();
  std::vector<double> parts;
  for (const double t : at) parts.push_back(t / last);
  const std::vector<double> tau = shadow::cumulativeOpticalDepth(volumes, eye, eye + last * d, parts);
  sum.alpha = -std::expm1(-tau.back());
  std::vector<dvec3> points;
  std::vector<double> taken;
  for (std::size_t i = 0; i + 1 < at.size() && tau[i] < 40; ++i) {
    const double part = std::exp(-tau[i]) * -std::expm1(tau[i] - tau[i + 1]);
    if (!(part > 0)) continue;
    points.push_back(eye + 0.5 * (at[i] + at[i + 1]) * d);
    taken.push_back(part);
  }
  for (const ExactLight& l : lights) {
    const std::vector<double> T = l.transmittance(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const scene::Incidence e = scene::incidence(l.light, points[i]);
      const double cosine = glm::dot(e.towards, d);
      dvec3 scattered(0);
      double extinction = 0;
      for (const volume::Instance& v : volumes) {
        const double sigma = volume::sigmaAt(v, points[i]);
        extinction += sigma;
        scattered += sigma * scene::phaseValue(v.medium.phase, cosine) * dvec3(v.medium.albedo);
      }
      if (extinction > 0)
        sum.radiance += taken[i] * T[i] * e.falloff * dvec3(l.light.emitted) * scattered / extinction;
    }
  }
  return sum;
}

/// What the ray through the middle of a picture sees; `fov` of the whole picture in degrees.
inline dvec4 onTheAxis(view::RenderScene scene, const dvec3& eye, const dvec3& target, int samples,
                       double stepScale, double fov = 0.1) {
  scene.options.size = ivec2(3);
  scene.options.samples = samples;
  scene.options.stepScale = stepScale;
  const dvec3 up = std::abs(glm::normalize(target - eye).y) > 0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
  scene.options.camera = {eye, target, up, fov};
  const image::Image image = render(scene);
  const float* p = &image.layers[0].pixels[(1 * 3 + 1) * 4];
  return {p[0], p[1], p[2], p[3]};
}

/// Mean over a whole picture, RGBA.
inline dvec4 meanOf(const image::Image& image) {
  dvec4 sum(0);
  const std::vector<float>& p = image.layers[0].pixels;
  for (std::size_t i = 0; i < p.size(); i += 4) sum += dvec4(p[i], p[i + 1], p[i + 2], p[i + 3]);
  return sum * (4.0 / double(p.size()));
}

/// Collects cases of one table: prints each that is wrong (all with PILEUS_ROWS set) and how many were.
class Rows {
 public:
  explicit Rows(std::string table) : table_(std::move(table)) {}
  ~Rows() {
    std::printf("%-44s %4d of %4d cases wrong; largest error %.3g of %.3g allowed (%s)\n", table_.c_str(),
                wrong_, cases_, worst_, allowed_, worstCase_.c_str());
  }
  /// `value` against `right`, within `relative` of it or `absolute`, whichever is more.
  void check(const std::string& what, double value, double right, double relative, double absolute = 0) {
    const double allowed = std::max(relative * std::abs(right), absolute);
    const double error = std::abs(value - right);
    const bool good = error <= allowed;  // false for NaN
    ++cases_;
    wrong_ += good ? 0 : 1;
    if (!(error * allowed_ <= worst_ * allowed) || worstCase_.empty())
      worst_ = error, allowed_ = allowed, worstCase_ = what;
    if (!good || std::getenv("PILEUS_ROWS"))
      std::printf("%s | %s | %.6g | %.6g | %+.2f %%%s\n", table_.c_str(), what.c_str(), value, right,
                  100 * (value / right - 1), good ? "" : " | wrong");
    if (!good && ++shown_ <= 5) ADD_FAILURE() << table_ << ", " << what << ": " << value << " for " << right;
    if (!good && shown_ > 5) ::testing::Test::RecordProperty("more", wrong_);
  }

 private:
  std::string table_, worstCase_;
  int cases_ = 0, wrong_ = 0, shown_ = 0;
  double worst_ = 0, allowed_ = 1;
};

}  // namespace pileus::test
