#pragma once
// Shadow representations by short names, built to the end, and the media they are tested on.
#include <cmath>
#include <functional>
#include <random>

#include "editor/cli/map_measures.h"
#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/volume/brick_builder.h"
#include "renderer/volume/vdb_import.h"
#include "tests/support/gpu.h"

namespace pileus::test {

inline const dvec3 kUp(0, 1, 0);
inline double T(double tau) { return std::exp(-tau); }

inline std::shared_ptr<const shadow::ShadowMap> build(const shadow::ShadowSpec& spec,
                                                      const volume::InstanceList& volumes,
                                                      const scene::Light& light) {
  renderer();
  auto map = shadow::buildShadow(renderer().gpu(), spec, light, volumes);
  EXPECT_TRUE(map) << (map ? "" : map.error().message);
  return map ? *map : nullptr;
}

inline shadow::ShadowSpec fourier(int coefficients, int resolution = 128, bool range = false) {
  shadow::ShadowSpec s;
  s.kind = shadow::ShadowSpec::Kind::FourierOpacity;
  s.coefficients = coefficients;
  s.range = range;
  s.resolution = resolution;
  s.storage = shadow::Storage::Float;
  return s;
}
inline shadow::ShadowSpec transmittance(int coefficients, shadow::Basis basis, int resolution = 128) {
  shadow::ShadowSpec s = fourier(coefficients, resolution);
  s.kind = shadow::ShadowSpec::Kind::TransmittanceFunction;
  s.basis = basis;
  return s;
}
inline shadow::ShadowSpec deep(double bound, int resolution = 128) {
  return cli::deepSpec(bound, resolution);
}
inline shadow::ShadowSpec improved(int intervals, int coefficients, int resolution, bool extras = true,
                                   shadow::Storage storage = shadow::Storage::Float) {
  return cli::intervalSpec(intervals, coefficients, resolution, extras, storage);
}

/// A grid of `sigma(depth)` along -y, the same across, depth 0 at y = 0.5, one metre deep.
inline volume::Instance profile(int voxels, const std::function<double(double)>& sigma) {
  volume::VoxelSource source;
  source.name = "profile";
  source.worldFromIndex =
      glm::scale(glm::translate(dmat4(1), dvec3(0, 0.5 - 0.5 / voxels, 0)), dvec3(1.0, -1.0 / voxels, 1.0));
  source.activeMin = ivec3(-8, 0, -8);
  source.activeMax = ivec3(8, voxels - 1, 8);
  source.fill = [&](ivec3 lo, float* out) {
    for (int z = 0; z < volume::kStoredSize; ++z)
      for (int y = 0; y < volume::kStoredSize; ++y)
        for (int x = 0; x < volume::kStoredSize; ++x) {
          const int j = lo.y + y;
          *out++ = j >= 0 && j < voxels ? float(sigma((j + 0.5) / voxels)) : 0.0f;
        }
    return volume::Fill::Voxels;
  };
  JobControl control;
  auto built = volume::buildBricks(source, control);
  EXPECT_TRUE(built);
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = built->grid;
  i.worldFromLocal = i.grid->worldFromIndex;
  return i;
}

/// One light ray in the middle of a narrow frustum that spans exactly depth 0..1: u = x for the Euclidean
/// metric.
inline shadow::LightFrustum narrow() {
  shadow::LightFrustum f;
  f.worldFromLight =
      dmat4(dvec4(0.2, 0, 0, 0), dvec4(0, 0, 0.2, 0), dvec4(0, -1, 0, 0), dvec4(-0.1, 0.5, -0.1, 1));
  return f;
}

inline std::shared_ptr<const shadow::ShadowMap> buildIn(const shadow::ShadowSpec& spec,
                                                        const volume::InstanceList& volumes,
                                                        const shadow::LightFrustum& f) {
  renderer();
  shadow::ShadowPass pass(spec, sunFrom(kUp), volumes, {}, &f);
  for (double done = 0; done < 1;) {
    const auto r = pass.step(renderer().gpu(), 1e12);
    EXPECT_TRUE(r) << (r ? "" : r.error().message);
    if (!r) return nullptr;
    done = *r;
  }
  return pass.map();
}

inline std::vector<vec3> downTheRay(int count) {
  std::vector<vec3> at;
  for (int i = 0; i < count; ++i) at.push_back(vec3(0.0f, 0.5f - (float(i) + 0.5f) / float(count), 0.0f));
  return at;
}

inline double worstAgainstReference(const shadow::ShadowMap& map, const volume::InstanceList& volumes,
                                    const std::vector<vec3>& at) {
  const auto tau = lookupTau(map, map.light, at);
  double worst = 0;
  for (std::size_t i = 0; i < at.size(); ++i)
    worst = std::max(worst, std::abs(T(double(tau[i])) -
                                     T(shadow::opticalDepthToLight(volumes, map.light, dvec3(at[i])))));
  return worst;
}

inline volume::Instance smoke1() {
  JobControl control;
  volume::ImportLimits limits;
  limits.executable = PILEUS_BINARY;
  auto imported = volume::importVdb(*dataFolder() / "vdb" / "smoke1.vdb", "", control, limits);
  EXPECT_TRUE(imported) << (imported ? "" : imported.error().message);
  volume::Instance smoke;
  smoke.shape = volume::Shape::Grid;
  smoke.grid = imported->grid;
  smoke.worldFromLocal = imported->grid->worldFromIndex;
  smoke.medium.extinction = 0.5;
  return smoke;
}

inline std::vector<vec3> pointsInside(const volume::InstanceList& volumes, int count, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> u(0, 1);
  const Box3 bounds = volume::worldBounds(volumes);
  std::vector<vec3> at;
  for (int tries = 0; int(at.size()) < count && tries < 1000 * count; ++tries) {
    const dvec3 p = bounds.min + bounds.size() * dvec3(u(rng), u(rng), u(rng));
    double sigma = 0;
    for (const auto& v : volumes) sigma += volume::sigmaAt(v, p);
    if (sigma > 0) at.push_back(vec3(p));
  }
  return at;
}

}  // namespace pileus::test
