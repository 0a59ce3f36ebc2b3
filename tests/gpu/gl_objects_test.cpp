// Textures and buffers that a driver does not give: what is wrong is said, and what was there stays.
#include <cmath>

#include "renderer/shadow/additive_target.h"
#include "tests/support/gl_faults.h"
#include "tests/support/lit.h"
#include "tests/support/noise_grid.h"

namespace pileus {
namespace {

using test::Faults;

/// The driver at hand reports its own errors to the log, too.
constexpr std::size_t kMiB = std::size_t(1) << 20;

view::RenderScene boxScene(ivec2 size) {
  view::RenderScene scene;
  scene.options.size = size;
  scene.options.samples = 1;
  scene.options.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40};
  scene.volumes = {test::box({0, 0, 0}, {1, 1, 1}, 1)};
  scene.lights = {{test::sunFrom({0.3, 1, 0.2}), nullptr}};
  return scene;
}

/// The error a pass ends in, or "".
template <class Pass>
std::string errorOf(Pass& pass, const shadow::Gpu& gpu) {
  for (double done = 0; done < 1;) {
    const auto step = pass.step(gpu, 1e12);
    if (!step) return step.error().message;
    done = *step;
  }
  return {};
}

TEST(GlObjects, WhatIsBeyondTheDriversLimitsIsRefusedByNameAndFigure) {
  test::renderer();
  const Faults claimed(
      {{GL_MAX_TEXTURE_SIZE, 512}, {GL_MAX_3D_TEXTURE_SIZE, 64}, {GL_MAX_ARRAY_TEXTURE_LAYERS, 8}},
      Faults::kAny);
  const auto error = [](GLenum target, ivec3 size) {
    const auto t = gl::Texture::create(target, GL_R8, size, "thing");
    EXPECT_TRUE(t || t.error().code == Code::Gpu);
    return t ? std::string() : t.error().message;
  };
  EXPECT_EQ(error(GL_TEXTURE_2D, {512, 512, 1}), "");
  EXPECT_EQ(error(GL_TEXTURE_2D, {513, 20, 1}),
            "thing: 513 x 20 texels are wanted, this OpenGL driver holds at most 512 x 512 in a texture");
  EXPECT_EQ(error(GL_TEXTURE_2D_ARRAY, {64, 64, 8}), "");
  EXPECT_EQ(error(GL_TEXTURE_2D_ARRAY, {64, 64, 9}),
            "thing: 9 layers are wanted, this OpenGL driver holds at most 8 in a texture");
  EXPECT_NE(error(GL_TEXTURE_3D, {64, 65, 64}), "");
  EXPECT_NE(error(GL_TEXTURE_3D, {64, 64, 65}), "");
  EXPECT_EQ(claimed.refused(), 0) << "not even asked for";
}

TEST(GlObjects, MemoryThatIsOutIsAnError) {
  test::renderer();
  const Faults scarce({}, 64 << 10);
  const auto texture = gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(128, 128, 1), "picture");
  ASSERT_FALSE(texture);
  EXPECT_EQ(texture.error().message, "picture: out of GPU memory: 0.2 MiB more are needed");
  gl::Buffer buffer("march states");
  EXPECT_TRUE(buffer.reserve(60000));
  const auto grown = buffer.reserve(200000);
  ASSERT_FALSE(grown);
  EXPECT_EQ(grown.error().code, Code::Gpu);
  EXPECT_EQ(grown.error().message.find("march states: out of GPU memory"), 0u) << grown.error().message;
  EXPECT_EQ(buffer.capacity(), 0u);
  EXPECT_TRUE(buffer.reserve(1000)) << "usable again";
}

TEST(GlObjects, APictureTooLargeForTheDriverIsRefused) {
  const shadow::Gpu gpu = test::renderer().gpu();
  const Faults claimed({{GL_MAX_TEXTURE_SIZE, 1024}}, Faults::kAny);
  view::VolumeRenderPass pass(boxScene({1200, 8}));
  EXPECT_EQ(errorOf(pass, gpu),
            "picture: 1200 x 8 texels are wanted, this OpenGL driver holds at most 1024 x 1024 in a texture");
}

TEST(GlObjects, StripsGiveTheTexelsOfTheWhole) {
  test::renderer();
  const ivec2 size(37, 23);
  std::vector<float> texels;
  for (int i = 0; i < size.x * size.y * 4; ++i) texels.push_back(static_cast<float>(i));
  const gl::Texture t = std::move(*gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(size, 1), "t"));
  glTextureSubImage2D(t.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
  // Less than a row, a row, some that do not go evenly into it, all.
  for (const std::size_t bytes : {std::size_t(1), std::size_t(37 * 16), std::size_t(5 * 37 * 16 + 3), kMiB}) {
    std::vector<float> read(texels.size(), -1.0f);
    gl::readTexels(t, GL_RGBA, 4, read.data(), bytes);
    EXPECT_EQ(read, texels) << bytes;
  }
}

TEST(GlObjects, AnAtlasThatCannotGrowKeepsItsVolumes) {
  const shadow::Gpu shared = test::renderer().gpu();
  residency::BrickPool bricks(shared.device, 256 * kMiB);
  const shadow::Gpu gpu{shared.device, shared.shaders, bricks, shared.store};
  constexpr int kEdge = 96;
  const auto scene = [&](int edge) {
    view::RenderScene s = boxScene({24, 24});
    s.volumes = {test::gridInstance(
        test::gridOf(edge, [=](ivec3 v) { return 0.5f + 0.5f * std::sin(float(v.x * v.y + v.z * edge)); }),
        edge, 2)};
    return s;
  };
  const view::RenderScene first = scene(kEdge), large = scene(2 * kEdge);
  const auto draw = [&](const view::RenderScene& s) {
    view::VolumeRenderPass pass(s);
    EXPECT_EQ(errorOf(pass, gpu), "");
    return view::readBack(*pass.picture())->layers[0].pixels;
  };
  // Bricks may lie elsewhere in the atlas: weights of the filter round otherwise there.
  const auto expectLike = [](const std::vector<float>& a, const std::vector<float>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 2e-3);
  };
  const std::vector<float> before = draw(first);
  EXPECT_GT(before[(12 * 24 + 12) * 4 + 3], 0.1f);
  const std::size_t bytes = bricks.bytes();
  {
    const Faults scarce({}, bytes);
    view::VolumeRenderPass pass(large);
    const std::string error = errorOf(pass, gpu);
    EXPECT_EQ(error.find("brick atlas: out of GPU memory"), 0u) << error;
    EXPECT_EQ(bricks.bytes(), bytes);
    expectLike(draw(first), before);  // the old atlas is still there
  }
  EXPECT_GT(draw(large)[(12 * 24 + 12) * 4 + 3], 0.1f) << "and grows once there is memory";
  expectLike(draw(first), before);
}

TEST(GlObjects, ADeepMapOfAPointLightNeedsNoTallTexture) {
  const shadow::Gpu gpu = test::renderer().gpu();
  const volume::InstanceList volumes{test::box({0, 0, 0}, {2, 2, 2}, 1)};
  const auto light = test::pointAt({0, 2, 0});
  shadow::ShadowSpec spec;
  spec.kind = shadow::ShadowSpec::Kind::Deep;
  spec.resolution = 96;
  spec.errorBound = 0.001;
  const std::vector<vec3> at{{0, 0.5f, 0}, {0.3f, -0.2f, 0.1f}, {-0.4f, -0.9f, 0.3f}};
  const auto tau = [&] {
    const auto map = shadow::buildShadow(gpu, spec, light, volumes);
    EXPECT_TRUE(map) << (map ? "" : map.error().message);
    return map ? test::lookupTau(**map, light, at) : std::vector<float>(at.size());
  };
  const std::vector<float> want = tau();
  EXPECT_NEAR(want[0], 0.5, 0.02);
  // Six faces of 96 texels one below the other are 576.
  const Faults claimed({{GL_MAX_TEXTURE_SIZE, 256}}, Faults::kAny);
  EXPECT_EQ(tau(), want);
}

TEST(GlObjects, DrawingIntoAMapPutsBackWhatItFound) {
  test::renderer();
  glEnable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glBlendEquationSeparate(GL_FUNC_SUBTRACT, GL_MAX);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_DST_ALPHA);
  glViewport(1, 2, 30, 40);
  glScissor(3, 4, 50, 60);
  GLuint vertices = 0;
  glCreateVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  const auto state = [] {
    std::vector<GLint> s;
    for (const GLenum e : {GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_DEPTH_CLAMP, GL_BLEND})
      s.push_back(glIsEnabled(e));
    for (const GLenum e : {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB,
                           GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA, GL_VERTEX_ARRAY_BINDING,
                           GL_DRAW_FRAMEBUFFER_BINDING, GL_VIEWPORT, GL_SCISSOR_BOX}) {
      GLint values[4] = {};
      glGetIntegerv(e, values);
      s.insert(s.end(), values, values + 4);
    }
    return s;
  };
  const auto before = state();
  {
    shadow::AdditiveTarget target;
    const auto texture = gl::Texture::create(GL_TEXTURE_2D_ARRAY, GL_RGBA32F, ivec3(16, 16, 2), "t");
    target.attach(texture->id(), 0, 2, ivec2(0), 16, true);
    EXPECT_NE(state(), before);
  }
  EXPECT_EQ(state(), before);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &vertices);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ZERO);
}

}  // namespace
}  // namespace pileus
