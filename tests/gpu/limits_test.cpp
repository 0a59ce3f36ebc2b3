// On a driver that offers what OpenGL 4.5 guarantees and no more: the same pictures, and what needs more is
// refused by name.
#include "renderer/residency/scene_table.h"
#include "renderer/volume/brick_builder.h"
#include "tests/support/guaranteed_limits.h"
#include "tests/support/lit.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using test::GuaranteedLimits;

/// To its end by a renderer's services.
image::Image pictureBy(view::Renderer& renderer, const view::RenderScene& scene) {
  view::VolumeRenderPass pass(scene);
  for (double done = 0; done < 1;) {
    const auto step = pass.step(renderer.gpu(), 1e12);
    if (!step) {
      ADD_FAILURE() << step.error().message;
      return {};
    }
    done = *step;
  }
  return view::readBack(*pass.picture()).value();
}

/// A cloud of voxels and a box under a sun, a point light with its six faces, and a spot, each with another
/// kind of shadow.
image::Image cloudBy(view::Renderer& renderer) {
  const volume::InstanceList volumes{test::profile(48, [](double depth) { return 6 * depth; }),
                                     test::box({0, -0.8, 0}, {1.5, 0.3, 1.5}, 2)};
  shadow::ShadowSpec sun = test::improved(4, 8, 256),
                     series = test::transmittance(7, shadow::Basis::Cosine, 128);
  view::RenderScene scene;
  scene.options.size = ivec2(96, 64);
  scene.options.samples = 2;
  scene.options.camera = {dvec3(3, 1, 4), dvec3(0), dvec3(0, 1, 0), 30};
  scene.volumes = volumes;
  const auto add = [&](const scene::Light& light, const shadow::ShadowSpec& spec) {
    auto map = shadow::buildShadow(renderer.gpu(), spec, light, volumes);
    if (!map)
      ADD_FAILURE() << map.error().message;
    else
      scene.lights.push_back({light, *map});
  };
  add(test::sunFrom(dvec3(0.3, 1, 0.2)), sun);
  add(test::pointAt(dvec3(0, 2, 1), 3), series);
  add(test::sunFrom(dvec3(-1, 1, 0.3)), test::deep(0.01, 64));
  scene.lights.push_back({test::spotAt(dvec3(2, 2, 0), dvec3(0), 40),
                          shadow::marchedShadow(test::spotAt(dvec3(2, 2, 0), dvec3(0), 40), volumes, {}, 1)});
  scene.solids = {test::solidPlane(dvec3(0, -1.2, 0), dvec3(4, 1, 4))};
  return pictureBy(renderer, scene);
}

TEST(GuaranteedLimits, GiveTheSamePicture) {
  const image::Image whole = cloudBy(test::renderer());
  const GuaranteedLimits limits;
  const auto least = view::Renderer::create({.gpuMemory = std::size_t(256) << 20});
  ASSERT_TRUE(least) << least.error().message;
  EXPECT_EQ((*least)->device().maxBufferTexels, std::size_t(GuaranteedLimits::kBufferTexels));
  EXPECT_EQ((*least)->device().maxTextureSize, GuaranteedLimits::kTexture);
  EXPECT_EQ((*least)->device().maxViewport, GuaranteedLimits::kViewport);
  const image::Image picture = cloudBy(**least);
  ASSERT_EQ(picture.layers.size(), 1u);
  EXPECT_EQ(picture.layers[0].pixels, whole.layers[0].pixels);
  EXPECT_GT(*std::max_element(whole.layers[0].pixels.begin(), whole.layers[0].pixels.end()), 0.05f);
}

TEST(GuaranteedLimits, RefuseGridsOfTooManyBricks) {
  volume::VoxelSource source;
  source.name = "wide";
  source.activeMin = ivec3(0);
  source.activeMax = ivec3(41 * 16 - 1);  // 68921 bricks without their mips
  source.fill = [](ivec3 lo, float* out) {
    if (lo.x > 0 || lo.y > 0 || lo.z > 0) return volume::Fill::Zero;
    std::fill(out, out + volume::kStoredVoxels, 1.0f);
    return volume::Fill::Voxels;
  };
  JobControl control;
  const auto built = volume::buildBricks(source, control);
  ASSERT_TRUE(built) << built.error().message;
  view::Renderer& whole = test::renderer();
  EXPECT_TRUE(whole.bricks().ensure(std::vector{built->grid}, 1e12));
  const GuaranteedLimits limits;
  const auto least = view::Renderer::create({.gpuMemory = std::size_t(256) << 20});
  const auto refused = (*least)->bricks().ensure(std::vector{built->grid}, 1e12);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::Gpu);
  EXPECT_NE(refused.error().message.find("65536"), std::string::npos) << refused.error().message;
  // A smaller one still goes, and two that do not go together take turns.
  source.activeMax = ivec3(35 * 16 - 1);
  volume::GridPtr one = volume::buildBricks(source, control)->grid;
  source.activeMax = ivec3(34 * 16 - 1);
  volume::GridPtr other = volume::buildBricks(source, control)->grid;
  for (const volume::GridPtr& grid : {one, other, one}) {
    const auto residency = (*least)->bricks().ensure(std::vector{grid}, 1e12);
    ASSERT_TRUE(residency) << residency.error().message;
    EXPECT_EQ(residency->fraction, 1);
    EXPECT_NE((*least)->bricks().find(*grid), nullptr);
  }
  EXPECT_FALSE((*least)->bricks().ensure(std::vector{one, other}, 1e12));
}

TEST(GuaranteedLimits, RefuseDeepMapsOfTooManyVertices) {
  test::renderer();
  const GuaranteedLimits limits;
  const auto least = view::Renderer::create({.gpuMemory = std::size_t(256) << 20});
  const volume::InstanceList volumes{test::box({0, 0, 0}, {1, 1, 1}, 2)};
  const auto map =
      shadow::buildShadow((*least)->gpu(), test::deep(0.01, 512), test::sunFrom(test::kUp), volumes);
  ASSERT_FALSE(map);
  EXPECT_NE(map.error().message.find("65536"), std::string::npos) << map.error().message;
  EXPECT_NE(map.error().message.find("resolution"), std::string::npos) << map.error().message;
}

TEST(GuaranteedLimits, RefuseLongerListsThanABufferTextureHolds) {
  test::renderer();
  const GuaranteedLimits limits;
  residency::SceneTable table;
  gl::ShaderLibrary library;
  gl::Program& program = **library.program({"test/sample_grid.comp.glsl"}, {{"SHAPES", 1}});
  using Section = residency::SceneTable::Section;
  table.set(Section::TileItems, std::span<const int>(std::vector<int>(4 * 65536, 1)));
  EXPECT_TRUE(table.bind(program)) << "just fits";
  table.set(Section::Volumes, std::span<const vec4>(std::vector<vec4>(1)));
  const auto refused = table.bind(program);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::Gpu);
  EXPECT_NE(refused.error().message.find("65537"), std::string::npos) << refused.error().message;
  EXPECT_NE(refused.error().message.find("65536"), std::string::npos) << refused.error().message;
  table.set(Section::TileItems, std::span<const int>(std::vector<int>(100, 1)));
  EXPECT_TRUE(table.bind(program));
}

}  // namespace
}  // namespace pileus
