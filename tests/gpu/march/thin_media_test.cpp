// Media that are thin against their distance: alpha by the chord in double precision, pixel by pixel.
#include <fmt/format.h>

#include <cmath>

#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"

namespace pileus {
namespace {

constexpr double kDistance = 1000;  // metres
constexpr double kFov = 0.5;        // degrees
constexpr double kAllowed = 2e-3;   // of alpha

/// Optical depth 1 through the middle of a sheet as wide as a tenth of its distance.
volume::Instance sheet(double thickness, bool grid, double offset = 0, double depth = 1) {
  if (!grid)
    return test::box({0, offset, 0}, {0.1 * kDistance, thickness, 0.1 * kDistance}, depth / thickness);
  static const volume::GridPtr full = test::gridOf(16, [](ivec3) { return 1.0f; });
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = full;
  i.worldFromLocal = glm::scale(glm::translate(dmat4(1.0), dvec3(0, offset, 0)),
                                dvec3(0.1 * kDistance / 16, thickness / 16, 0.1 * kDistance / 16)) *
                     glm::translate(dmat4(1.0), dvec3(-7.5));
  i.medium.extinction = depth / thickness;
  return i;
}

/// Each pixel against the exact chord.
void comparePixels(test::Rows& rows, const std::string& what, const volume::InstanceList& volumes,
                   const dvec3& eye, const dvec3& target, double stepScale) {
  view::RenderOptions o;
  o.size = ivec2(7);
  o.samples = 1;
  o.stepScale = stepScale;
  o.camera = {eye, target, {0.2, 1, 0.1}, kFov};
  const image::Image image = test::render(o, volumes, {});
  double worst = 0, have = 0, want = 0;
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 7; ++x) {
      const dvec3 d = scene::rayDirection(o.camera, 1, (dvec2(x, y) + 0.5) / 7.0);
      const double right =
          -std::expm1(-shadow::opticalDepth(volumes, eye, eye + 3 * glm::length(target - eye) * d));
      const double seen = double(image.layers[0].pixels[std::size_t(y * 7 + x) * 4 + 3]);
      if (!(std::abs(seen - right) <= worst)) worst = std::abs(seen - right), have = seen, want = right;
    }
  if (worst == 0) have = want = 1;
  rows.check(what, have, want, 0, kAllowed);
}

/// Views a sheet from several sides, never along it.
void compareViews(test::Rows& rows, const std::string& what, const volume::InstanceList& volumes,
                  const std::vector<double>& steps) {
  for (const double off : {0.0, 17.0, 45.0, 70.0})
    for (const double around : {10.0, 130.0, 251.0}) {
      const double a = glm::radians(off), b = glm::radians(around);
      const dvec3 towards(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
      for (const double step : steps)
        comparePixels(rows, fmt::format("{}, {} degrees off, {} around, step {}", what, off, around, step),
                      volumes, kDistance * towards, dvec3(0.013, 0, -0.021), step);
      if (off == 0) break;
    }
}

TEST(ThinMedia, OneAnalyticSheet) {
  test::renderer();
  test::Rows rows("one analytic sheet");
  for (const double part : {1 / 500.0, 1 / 5000.0, 1 / 50000.0, 1e-5, 1e-6})
    compareViews(rows, fmt::format("thickness {:.1g} of the distance", part),
                 {sheet(part * kDistance, false)}, {0.05, 1, 4});
}

TEST(ThinMedia, OneSheetOfVoxels) {
  test::renderer();
  test::Rows rows("one sheet of voxels");
  for (const double part : {1 / 500.0, 1 / 5000.0, 1 / 50000.0, 1e-5, 1e-6})
    compareViews(rows, fmt::format("thickness {:.1g} of the distance", part), {sheet(part * kDistance, true)},
                 {0.05, 0.5, 1, 4});
}

TEST(ThinMedia, OverlappingSheets) {
  test::renderer();
  test::Rows rows("overlapping sheets");
  for (const double part : {1 / 500.0, 1e-3, 1e-4})
    for (const bool grid : {false, true}) {
      const double h = part * kDistance;
      compareViews(
          rows,
          fmt::format("two, thickness {:.1g} of the distance, {}", part, grid ? "grid and box" : "boxes"),
          {sheet(h, grid, 0, 0.5), sheet(h, false, 0.37 * h, 0.5)}, {0.05, 1, 4});
    }
}

/// Small in all directions.
TEST(ThinMedia, SmallCubesFarAway) {
  test::renderer();
  test::Rows rows("small cubes far away");
  for (const double part : {1 / 500.0, 1 / 5000.0, 1 / 50000.0})
    for (const bool grid : {false, true})
      for (const double step : {0.05, 1.0, 4.0})
        for (const dvec3& towards : {dvec3(1, 0, 0), dvec3(0.5, 0.3, 0.8), dvec3(-0.2, 0.9, 0.4)}) {
          const double edge = part * kDistance;
          volume::Instance cube = grid ? sheet(edge, true) : test::box({0, 0, 0}, dvec3(edge), 1 / edge);
          if (grid)
            cube.worldFromLocal =
                glm::scale(dmat4(1.0), dvec3(edge / 16)) * glm::translate(dmat4(1.0), dvec3(-7.5));
          const dvec3 eye = kDistance * glm::normalize(towards);
          view::RenderScene scene;
          scene.volumes = {cube};
          const double right = -std::expm1(-shadow::opticalDepth(scene.volumes, eye, -eye));
          const dvec4 seen = test::onTheAxis(scene, eye, dvec3(0), 1, step, 1e-4);
          rows.check(fmt::format("edge {:.1g} of the distance, grid {}, step {}, from ({}, {}, {})", part,
                                 grid, step, towards.x, towards.y, towards.z),
                     seen.w, right, 0, kAllowed);
        }
}

}  // namespace
}  // namespace pileus
