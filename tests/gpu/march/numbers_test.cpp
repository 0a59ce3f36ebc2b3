// The march's own functions where rounding decides: the phase function of sharp media, the mip at a power of
// two.
#include <fmt/format.h>

#include <cmath>

#include "renderer/residency/volume_set.h"
#include "renderer/shaders/shared/bindings.h"
#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

template <class In>
std::vector<float> computed(gl::Program& program, const std::vector<In>& in) {
  gl::Buffer input, output;
  EXPECT_TRUE(input.assign(std::span<const In>(in)));
  EXPECT_TRUE(output.reserve(in.size() * sizeof(float)));
  input.bindStorage(BIND_TEST_IN);
  output.bindStorage(BIND_TEST_OUT);
  program.set("count", int(in.size()));
  glDispatchCompute(GLuint((in.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<float> out(in.size());
  glGetNamedBufferSubData(output.id(), 0, GLsizeiptr(out.size() * sizeof(float)), out.data());
  return out;
}

TEST(MarchNumbers, ThePhaseFunctionOfSharpMedia) {
  auto program = test::renderer().shaders().program({"test/phase.comp.glsl"}, {});
  ASSERT_TRUE(program) << program.error().message;
  (*program)->use();
  test::Rows rows("phase function");
  std::vector<vec2> at;
  for (const float g : {0.0f, 0.3f, 0.9f, 0.99f, 0.999f, 0.9999f, -0.3f, -0.9f, -0.99f, -0.999f, -0.9999f})
    for (const double off : {0.0, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 2.0, 3.0, kPi}) {
      at.emplace_back(float(std::cos(off)), g);
      at.emplace_back(-float(std::cos(off)), g);
    }
  const auto values = computed(**program, at);
  for (std::size_t i = 0; i < at.size(); ++i)
    rows.check(fmt::format("g {}, cosine {}", at[i].y, at[i].x), double(values[i]),
               scene::phaseValue(scene::henyeyGreenstein(double(at[i].y)), double(at[i].x)), 2e-3, 1e-7);
}

/// A thin box lit from behind, seen a little off the sun.
TEST(MarchNumbers, SharpMediaInAPicture) {
  test::Rows rows("sharp media");
  for (const double g : {0.9, 0.99, 0.999, 0.9999, -0.999})
    for (const double off : {0.0, 0.02, 0.1, 1.0, 10.0}) {
      volume::Instance box = test::box({0, 0, 0}, {1, 1, 1}, 0.3);
      box.medium.phase = scene::henyeyGreenstein(g);
      const double a = glm::radians(off);
      const scene::Light sun = test::sunFrom({std::sin(a), 0, g > 0 ? -std::cos(a) : std::cos(a)});
      shadow::ShadowSpec march;
      march.kind = shadow::ShadowSpec::Kind::RayMarch;
      view::RenderScene scene;
      scene.volumes = {box};
      scene.lights = {test::shadowed(sun, march, {box})};
      const double right =
          test::exactAlong({box}, {test::exactly({box}, sun)}, {0, 0, 9}, {0, 0, -1}).radiance.x;
      // The sharpest lobe is hardly wider than directions in floats are apart.
      rows.check(fmt::format("g {}, {} degrees off", g, off),
                 test::onTheAxis(scene, {0, 0, 9}, dvec3(0), 1, 1, 1e-4).x, right, g > 0.9995 ? 0.05 : 0.02);
    }
}

TEST(MarchNumbers, TheMipAtAPowerOfTwo) {
  view::Renderer& r = test::renderer();
  test::Rows rows("mip levels");
  const auto grid = test::gridOf(256, [](ivec3 p) { return (p.x ^ p.y ^ p.z) & 64 ? 1.0f : 0.0f; });
  const int levels = int(grid->levels.size());
  ASSERT_GT(levels, 3);
  for (const double voxel : {1.0, 0.3, 5.0, 1 / 3.0, 1e-3, 12.7}) {
    volume::Instance i;
    i.shape = volume::Shape::Grid;
    i.grid = grid;
    i.worldFromLocal = glm::scale(dmat4(1.0), dvec3(voxel));
    i.medium.extinction = 1e-6 / voxel;  // thin: nothing but the footprint counts
    residency::VolumeSet set;
    while (set.prepare(r.bricks(), {i}, 1e12)->fraction < 1) {
    }
    auto program = r.shaders().program({"test/levels.comp.glsl"}, {{"SHAPES", set.shapes()}});
    ASSERT_TRUE(program) << program.error().message;
    (*program)->use();
    residency::SceneTable scene;
    set.bind(r.bricks(), scene, **program);
    ASSERT_TRUE(scene.bind(**program));
    std::vector<float> footprints;
    std::vector<int> right;
    const float detail = float(volume::detailSize(i));
    for (int k = -2; k < levels + 2; ++k) {
      const int level = std::clamp(k, 0, levels - 1);
      footprints.push_back(std::ldexp(detail, k)), right.push_back(level);
      footprints.push_back(std::ldexp(detail * 1.0001f, k)), right.push_back(level);
      footprints.push_back(std::ldexp(detail * 1.9999f, k)), right.push_back(level);
    }
    const auto have = computed(**program, footprints);
    for (std::size_t k = 0; k < have.size(); ++k)
      rows.check(fmt::format("voxel {}, footprint {} voxels", voxel, double(footprints[k] / detail)),
                 double(have[k]), right[k], 0, 0.1);
  }
}

}  // namespace
}  // namespace pileus
