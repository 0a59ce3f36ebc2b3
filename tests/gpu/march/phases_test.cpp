// Pictures of media whose phase function is not one lobe of Henyey and Greenstein, against quadrature.
#include <fmt/format.h>

#include <cmath>

#include "tests/support/exact_scattering.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

struct Named {
  const char* name;
  scene::Phase phase;
};

const Named kPhases[] = {{"two lobes", scene::doubleHenyeyGreenstein(0.8, -0.4, 0.3)},
                         {"rayleigh", scene::rayleigh()},
                         {"draine", scene::draine(0.5, 30)},
                         {"haze", scene::droplets(0.5)},
                         {"mist", scene::droplets(3)},
                         {"fog", scene::droplets(10)}};

dvec4 seenAlong(const volume::InstanceList& volumes, const scene::Light& sun) {
  shadow::ShadowSpec march;
  march.kind = shadow::ShadowSpec::Kind::RayMarch;
  view::RenderScene scene;
  scene.volumes = volumes;
  scene.lights = {test::shadowed(sun, march, volumes)};
  return test::onTheAxis(scene, {0, 0, 9}, dvec3(0), 1, 1, 1e-4);
}

double rightAlong(const volume::InstanceList& volumes, const scene::Light& sun) {
  return test::exactAlong(volumes, {test::exactly(volumes, sun)}, {0, 0, 9}, {0, 0, -1}).radiance.x;
}

TEST(Phases, ABoxSeenAtAnyAngleToTheSun) {
  test::renderer();
  test::Rows rows("phase functions in pictures");
  for (const Named& n : kPhases)
    for (const double off : {0.0, 0.3, 3.0, 30.0, 90.0, 150.0, 180.0}) {
      volume::Instance box = test::box({0, 0, 0}, {1, 1, 1}, 0.7);
      box.medium.phase = n.phase;
      const double a = glm::radians(off);
      const scene::Light sun = test::sunFrom({std::sin(a), 0, -std::cos(a)});
      rows.check(fmt::format("{}, scattered by {} degrees", n.name, off), seenAlong({box}, sun).x,
                 rightAlong({box}, sun), 5e-3);
    }
}

/// One medium's lobes leave the other's alone, with registers for both and without.
TEST(Phases, EachOverlappingMediumHasItsOwn) {
  test::renderer();
  test::Rows rows("phase functions that overlap");
  for (const int more : {1, 7}) {
    volume::InstanceList volumes;
    for (int i = 0; i <= more; ++i) {
      volumes.push_back(test::box({0, 0, 0.01 * i}, {1, 1, 1}, 0.1 + 0.01 * i));
      volumes.back().medium.phase =
          i == 0 ? scene::henyeyGreenstein(0.6) : kPhases[std::size_t(i) % std::size(kPhases)].phase;
    }
    for (const double off : {1.0, 60.0, 170.0}) {
      const double a = glm::radians(off);
      const scene::Light sun = test::sunFrom({std::sin(a), 0, -std::cos(a)});
      rows.check(fmt::format("{} boxes, scattered by {} degrees", more + 1, off), seenAlong(volumes, sun).x,
                 rightAlong(volumes, sun), 5e-3);
    }
  }
}

}  // namespace
}  // namespace pileus
