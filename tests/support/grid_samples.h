#pragma once
// Densities of a volume as the shaders see them.
#include <vector>

#include "renderer/residency/volume_set.h"
#include "renderer/shaders/shared/bindings.h"
#include "tests/support/gpu.h"

namespace pileus::test {

/// The shader's own sampler at positions relative to the grid's lattice; w: the level.
inline std::vector<float> sampledOnGpu(const volume::Instance& instance, const std::vector<vec4>& positions) {
  residency::VolumeSet set;
  view::Renderer& r = renderer();
  while (set.prepare(r.bricks(), {instance}, 1e12)->fraction < 1) {
  }
  auto program = r.shaders().program({"test/sample_grid.comp.glsl"}, {{"SHAPES", set.shapes()}});
  EXPECT_TRUE(program);
  gl::Buffer in, out;
  EXPECT_TRUE(in.assign(std::span<const vec4>(positions)));
  EXPECT_TRUE(out.reserve(positions.size() * sizeof(float)));
  (*program)->use();
  residency::SceneTable table;
  set.bind(r.bricks(), table, **program);
  EXPECT_TRUE(table.bind(**program));
  in.bindStorage(BIND_TEST_IN);
  out.bindStorage(BIND_TEST_OUT);
  (*program)->set("count", int(positions.size()));
  glDispatchCompute(GLuint((positions.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<float> values(positions.size());
  glGetNamedBufferSubData(out.id(), 0, GLsizeiptr(values.size() * sizeof(float)), values.data());
  return values;
}

}  // namespace pileus::test
