// A cloud is as bright and as opaque at any size of the picture and from any distance.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "renderer/volume/cloud/procedural.h"
#include "tests/support/exact_scattering.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

/// A cumulus of some 600 m with voxels of 5 m, sigma_t up to 0.06/m.
const volume::Instance& cumulus() {
  static const volume::Instance cloud = [] {
    volume::CloudParams p;
    p.genus = volume::Genus::Classic;
    p.seed = 5;
    p.center = dvec3(0);
    p.size = dvec3(640, 420, 640);
    p.coverage = 0.45;
    p.density = 0.06;
    p.resolution = 128;
    JobControl control;
    volume::Instance i;
    i.shape = volume::Shape::Grid;
    i.grid = volume::bakeCloud(p, control).value();
    i.worldFromLocal = i.grid->worldFromIndex;
    i.medium.extinction = 1;
    i.medium.albedo = vec3(1);
    return i;
  }();
  return cloud;
}

/// A column of smoke, denser and more ragged: what a plume near a chimney has.
const volume::Instance& plume() {
  static const volume::Instance smoke = [] {
    volume::VoxelSource source;
    source.name = "plume";
    source.worldFromIndex = glm::scale(glm::translate(dmat4(1.0), dvec3(-120, 0, -120)), dvec3(5));
    source.activeMin = ivec3(0);
    source.activeMax = ivec3(47, 127, 47);
    source.fill = [](ivec3 lo, float* out) {
      const auto noise = [](const vec3& p) {
        return std::sin(p.x * 1.7f + 1.3f * std::sin(p.z)) * std::sin(p.y * 1.1f + std::sin(1.9f * p.x)) *
               std::sin(p.z * 1.3f + std::sin(0.7f * p.y));
      };
      for (int z = 0; z < volume::kStoredSize; ++z)
        for (int y = 0; y < volume::kStoredSize; ++y)
          for (int x = 0; x < volume::kStoredSize; ++x) {
            const vec3 p = vec3(lo + ivec3(x, y, z));
            const float h = p.y / 127;
            const vec3 axis(23.5f + 9 * h * std::sin(0.05f * p.y), p.y,
                            23.5f + 6 * h * std::cos(0.07f * p.y));
            const float r = glm::length(p - axis) / (3 + 15 * h);
            const float d = 1 - r + 0.9f * noise(p * 0.55f) + 0.5f * noise(p * 1.3f);
            *out++ = std::clamp(d, 0.0f, 1.0f) * (1.2f - h);
          }
      return volume::Fill::Voxels;
    };
    JobControl control;
    volume::Instance i;
    i.shape = volume::Shape::Grid;
    i.grid = volume::buildBricks(source, control).value().grid;
    i.worldFromLocal = i.grid->worldFromIndex;
    i.medium.extinction = 0.25;
    return i;
  }();
  return smoke;
}

struct Size {
  ivec2 size;
  int samples;
};
constexpr Size kSizes[] = {{{80, 45}, 256}, {{160, 90}, 64}, {{640, 360}, 4}, {{1280, 720}, 1}};

struct View {
  view::RenderOptions options;
  Box3 seen;  ///< of picture coordinates
};

View viewFrom(const volume::Instance& cloud, double distance) {
  View v;
  const Box3 bounds = volume::worldBounds(cloud);
  const dvec3 middle = bounds.center();
  v.options.camera = {middle + distance * glm::normalize(dvec3(0.5, 0.12, 0.85)), middle, {0, 1, 0}, 40};
  const glm::dmat3 basis = scene::basis(v.options.camera);
  const double tan = std::tan(glm::radians(20.0));
  for (int i = 0; i < 8; ++i) {
    const dvec3 q = glm::transpose(basis) * (bounds.corner(i) - v.options.camera.eye);
    v.seen.extend(dvec3(0.5 + 0.5 * q.x / (-q.z * tan * 16 / 9), 0.5 - 0.5 * q.y / (-q.z * tan), 0));
  }
  // Whole pixels of the smallest picture.
  v.options.region.min = glm::clamp(glm::floor(dvec2(v.seen.min) * dvec2(80, 45)) / dvec2(80, 45), 0.0, 1.0);
  v.options.region.max = glm::clamp(glm::ceil(dvec2(v.seen.max) * dvec2(80, 45)) / dvec2(80, 45), 0.0, 1.0);
  return v;
}

dvec4 mean(const volume::Instance& cloud, const shadow::ShadowedLight& light, View v, ivec2 size, int samples,
           double step) {
  v.options.size = size;
  v.options.samples = samples;
  v.options.stepScale = step;
  return test::meanOf(test::render(v.options, {cloud}, {light}));
}

/// The same by quadrature over rays spread evenly over what is seen.
dvec4 exactMean(const volume::Instance& cloud, const scene::Light& light, const View& v, int across) {
  const dvec2 min = glm::clamp(dvec2(v.seen.min), 0.0, 1.0),
              extent = glm::clamp(dvec2(v.seen.max), 0.0, 1.0) - min;
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> u(0, 1);
  const test::ExactLight exact = test::exactly({cloud}, light);
  dvec4 sum(0);
  const int down = std::max(1, int(across * extent.y * 9 / (extent.x * 16)));
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x) {
      const dvec2 uv = min + extent * (dvec2(x, y) + dvec2(u(rng), u(rng))) / dvec2(across, down);
      const dvec3 d = scene::rayDirection(v.options.camera, 16.0 / 9, uv);
      if (shadow::opticalDepth({cloud}, v.options.camera.eye, v.options.camera.eye + 3e4 * d) <= 0) continue;
      const test::Exact e = test::exactAlong({cloud}, {exact}, v.options.camera.eye, d, 2);
      sum += dvec4(e.radiance, e.alpha);
    }
  return sum * (extent.x * extent.y / (across * down));
}

scene::Light sun() { return test::sunFrom({-0.3, 0.5, 0.75}, 10); }

void compareSizes(const char* table, const volume::Instance& cloud) {
  test::renderer();
  test::Rows rows(table);
  const auto light = test::shadowed(sun(), test::improved(4, 8, 256), {cloud});
  for (const double km : {1.0, 5.0, 20.0}) {
    const View v = viewFrom(cloud, 1000 * km);
    // Where few pixels are met more rays are needed for the same certainty.
    const int more = km > 10 ? 16 : km > 3 ? 4 : 1;
    const dvec4 right = mean(cloud, light, v, {1280, 720}, more, 0.5);
    for (const double step : {1.0, 4.0})
      for (const Size& s : kSizes) {
        if (km < 3 && step > 1 && s.size.x > 640) continue;
        const dvec4 m = mean(cloud, light, v, s.size, s.samples * more, step);
        const double allowed = step > 1 ? 0.03 : 0.01;
        const std::string what = fmt::format("{} km, {} x {}, {} samples, step {}", km, s.size.x, s.size.y,
                                             s.samples * more, step);
        rows.check(what + ", radiance", m.x, right.x, allowed);
        rows.check(what + ", alpha", m.w, right.w, allowed);
      }
  }
}

TEST(PictureSize, CumulusFromOneToTwentyKilometres) { compareSizes("cumulus", cumulus()); }
TEST(PictureSize, PlumeFromOneToTwentyKilometres) { compareSizes("plume", plume()); }

TEST(PictureSize, AgainstQuadratureUnderMarchedShadows) {
  test::renderer();
  test::Rows rows("cloud against quadrature");
  for (const bool smoke : {false, true})
    for (const double km : {1.5, 5.0, 20.0}) {
      const volume::Instance& cloud = smoke ? plume() : cumulus();
      const View v = viewFrom(cloud, 1000 * km);
      const dvec4 right = exactMean(cloud, sun(), v, 64);
      ShadowSpec spec;
      spec.kind = ShadowSpec::Kind::RayMarch;
      const auto light = test::shadowed(sun(), spec, {cloud});
      const int samples = km > 10 ? 64 : km > 3 ? 16 : 4;
      const dvec4 m = mean(cloud, light, v, {80, 45}, samples, 1);
      // The rays of the quadrature are few: some per cent of it, most where the cloud is a few pixels.
      rows.check(fmt::format("{} at {} km, radiance", smoke ? "plume" : "cumulus", km), m.x, right.x, 0.05);
      rows.check(fmt::format("{} at {} km, alpha", smoke ? "plume" : "cumulus", km), m.w, right.w, 0.035);
    }
}

TEST(PictureSize, DraftsAreAsBright) {
  test::renderer();
  test::Rows rows("drafts");
  for (const bool smoke : {false, true})
    for (const double km : {1.0, 5.0}) {
      const volume::Instance& cloud = smoke ? plume() : cumulus();
      const View v = viewFrom(cloud, 1000 * km);
      const dvec4 right =
          mean(cloud, test::shadowed(sun(), test::improved(4, 8, 512), {cloud}), v, {640, 360}, 4, 1);
      // As the nodes do it on a CPU: maps of 128 texels, 25,000 pixels, one and a half steps. Several
      // samples, so that it is not the noise of one that is looked at.
      const dvec4 m =
          mean(cloud, test::shadowed(sun(), test::improved(4, 8, 128), {cloud}), v, {211, 119}, 8, 1.5);
      rows.check(fmt::format("{} at {} km, radiance", smoke ? "plume" : "cumulus", km), m.x, right.x, 0.03);
      rows.check(fmt::format("{} at {} km, alpha", smoke ? "plume" : "cumulus", km), m.w, right.w, 0.03);
    }
}

}  // namespace
}  // namespace pileus
