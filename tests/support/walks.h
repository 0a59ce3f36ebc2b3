#pragma once
// Random walks by the path tracer's flights and phase functions (shaders/test/walk.comp.glsl).
#include <cmath>

#include "renderer/residency/majorants.h"
#include "renderer/residency/region_run.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/view/light_set.h"
#include "tests/support/gpu.h"

namespace pileus::test {

/// What is walked in: where it ends, or what is measured.
enum class Body { Everything, UnitCube, UnitBall };

/// A mean over walks and its standard error.
struct Walked {
  double mean = 0, error = 0;
  double collisions = 0;  ///< a walk, on average
};

/// Through a body: the length of a walk [m]. Of everything: the squared distance [m^2] at which what the
/// origin sends out is absorbed.
inline Walked walked(const volume::InstanceList& volumes, Body body, int edge, int rounds) {
  const shadow::Gpu gpu = renderer().gpu();
  const view::LightSet lights({}, volumes, {});
  residency::RegionRun run;
  while (run.prepare(gpu.bricks, lights.volumes(), 1e12, dvec3(0)).value().fraction < 1) {
  }
  std::vector<std::vector<int>> lists(1);
  for (std::size_t i = 0; i < lights.volumes().size(); ++i) lists[0].push_back(int(i));
  run.list(lists);
  residency::Majorants majorants;
  EXPECT_TRUE(majorants.make(lights.volumes(), gpu.bricks, gpu.device));
  const auto program = gpu.shaders.program({"test/walk.comp.glsl"}, run.defines());
  if (!program) {
    ADD_FAILURE() << program.error().message;
    std::abort();
  }
  EXPECT_TRUE(run.bind(gpu.bricks, **program));
  majorants.bind();
  const auto walks = std::size_t(edge) * std::size_t(edge);
  gl::Buffer output;
  EXPECT_TRUE(output.reserve(walks * sizeof(vec4)));
  output.bindStorage(BIND_TEST_OUT);
  (*program)->set("body", int(body));
  std::vector<vec4> out(walks);
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0, collisions = 0;
  std::size_t unfinished = 0;
  for (int round = 0; round < rounds; ++round) {
    (*program)->set("firstWalk", round);
    EXPECT_TRUE(run.dispatch(**program, ivec2(0), ivec2(edge)));
    glGetNamedBufferSubData(output.id(), 0, GLsizeiptr(walks * sizeof(vec4)), out.data());
    for (const vec4& o : out) {
      const double weight = body == Body::Everything ? double(o.x) : 1.0,
                   value = double(body == Body::Everything ? o.y : o.x);
      x += weight, y += value, xx += weight * weight, xy += weight * value, yy += value * value;
      collisions += double(o.z);
      unfinished += o.w < 0.5f;
    }
  }
  EXPECT_EQ(unfinished, 0u);
  const double n = double(rounds) * double(walks);
  Walked w;
  w.mean = y / x;
  w.collisions = collisions / n;
  // Of a ratio; where all weights are 1 that of a mean.
  w.error = std::sqrt(std::max(yy - 2 * w.mean * xy + w.mean * w.mean * xx, 0.0)) / x;
  return w;
}

}  // namespace pileus::test
