// Environments in pictures: which way they face, what stands for them, what is seen of them.
#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

scene::EnvironmentMap black(ivec2 size) {
  return {size, std::vector<vec3>(std::size_t(size.x) * std::size_t(size.y), vec3(0.0f))};
}

std::shared_ptr<scene::Environment> made(scene::EnvironmentMap map, bool visible = false) {
  auto e = std::make_shared<scene::Environment>(scene::environmentOf(std::move(map)));
  e->visible = visible;
  return e;
}

view::RenderScene cloud() {
  view::RenderScene scene;
  scene.options.size = {32, 18};
  scene.options.samples = 256;
  scene.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 22};
  scene.volumes = {test::gridInstance(test::gridOf(80, test::blobs), 80, 10)};
  return scene;
}

shadow::ShadowedLight lightOf(std::shared_ptr<scene::Environment> e) {
  return {scene::environmentLight(std::move(e)), nullptr};
}

// One bright pixel is a sun of its azimuth, elevation and irradiance.
TEST(PathEnvironment, ABrightPixelIsASun) {
  for (const double rotation : {0.0, 30.0}) {
    const ivec2 size(72, 36), at(20, 9);
    scene::EnvironmentMap map = black(size);
    const double omega = scene::texelSolidAngle(size, at.y);
    map.at(at.x, at.y) = vec3(float(1 / omega));
    auto e = made(std::move(map));
    e->rotation = rotation;
    view::RenderScene scene = cloud();
    scene.lights = {lightOf(e)};
    const test::Traced t = test::traced(scene);
    const dvec2 uv = (dvec2(at) + 0.5) / dvec2(size);
    scene.lights = {
        {test::sunFrom(scene::sunDirection((0.5 - uv.x) * 360 + rotation, 90 - 180 * uv.y)), nullptr}};
    const test::Traced sun = test::traced(scene);
    const double error = std::hypot(t.grayError(), sun.grayError());
    std::printf("  rotation %.0f: %.6f +- %.6f, sun %.6f: %+.2f s.e.\n", rotation, t.gray(), t.grayError(),
                sun.gray(), (t.gray() - sun.gray()) / error);
    EXPECT_LE(error, 0.015 * sun.gray());
    EXPECT_NEAR(t.gray(), sun.gray(), 4 * error + 0.005 * sun.gray());  // the pixel is five degrees wide
  }
}

/// Bright on one side, dim elsewhere.
std::shared_ptr<scene::Environment> gradient() {
  scene::EnvironmentMap map = black({64, 32});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const dvec3 d = scene::environmentDirection((dvec2(x, y) + 0.5) / dvec2(64, 32));
      map.at(x, y) =
          vec3(float(0.2 + 2 * std::pow(std::max(0.0, glm::dot(d, glm::normalize(dvec3(1, 1, 0.5)))), 4.0)));
    }
  return made(std::move(map));
}

// A file's layers: each environment is a light, and so they add up.
TEST(PathEnvironment, EachIsALayer) {
  auto e = gradient(), other = std::make_shared<scene::Environment>(*e);
  other->rotation = 120;
  view::RenderScene scene = cloud();
  scene.options.samples = 4;
  scene.lights = {lightOf(e)};
  const test::Traced beauty = test::traced(scene);
  scene.lights.push_back(lightOf(other));
  scene.options.layer = {view::PictureLayer::Kind::Light, 0};
  EXPECT_EQ(test::traced(scene).picture.layers[0].pixels, beauty.picture.layers[0].pixels);
  scene.options.layer.light = 1;
  EXPECT_GT(test::traced(scene).gray(), 0);
  EXPECT_NE(test::traced(scene).picture.layers[0].pixels, beauty.picture.layers[0].pixels);
}

// What is seen behind all else: the same by either renderer, alpha that of the media.
TEST(PathEnvironment, SeenBehindTheMedia) {
  scene::EnvironmentMap map = black({64, 32});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) map.at(x, y) = vec3(float(x) / 64, float(y) / 32, 0.25f);
  auto e = made(std::move(map), true);
  e->rotation = 200;
  view::RenderScene scene;
  scene.options.size = {32, 18};
  scene.options.samples = 64;
  scene.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 60};
  scene.lights = {lightOf(e)};
  const test::Traced traced = test::traced(scene);
  const image::Image marched = test::render(scene);
  const std::vector<float>&p = traced.picture.layers[0].pixels, &q = marched.layers[0].pixels;
  double worst = 0;
  for (std::size_t i = 0; i < p.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(double(p[i + c] - q[i + c])));
    ASSERT_EQ(p[i + 3], 0);
    ASSERT_EQ(q[i + 3], 0);
  }
  EXPECT_LT(worst, 5e-3);
  // The pixel in the middle looks along (0, -0.4, -2.4).
  const vec3 right = scene::smoothRadiance(*e->seen, glm::normalize(dvec3(0, -0.4, -2.4)), 200);
  const std::size_t middle = (9 * 32 + 16) * 4;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(p[middle + std::size_t(c)], right[c], 0.02);
}

}  // namespace
}  // namespace pileus
