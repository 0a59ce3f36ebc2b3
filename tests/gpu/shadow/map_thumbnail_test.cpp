// Pictures of what shadow maps hold: how many tiles, and whether their colours say what the texels do.
#include "renderer/view/map_thumbnail.h"

#include <algorithm>

#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

constexpr int kTile = 32;

struct Tiles {
  int count = 0;
  std::vector<unsigned char> rgba;
  vec3 at(int tile, int x, int y) const {
    const auto i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(count * kTile) +
                        static_cast<std::size_t>(tile * kTile + x));
    return vec3(rgba[i], rgba[i + 1], rgba[i + 2]);
  }
  /// Colours of a tile that differ clearly from that of its first texel.
  int lit(int tile) const {
    int n = 0;
    for (int y = 0; y < kTile; ++y)
      for (int x = 0; x < kTile; ++x) n += glm::length(at(tile, x, y) - at(tile, 0, 0)) > 24 ? 1 : 0;
    return n;
  }
};

template <class Map>
Tiles tilesOf(const Map& map) {
  gl::Texture texture;
  const Result<int> count = view::drawMapThumbnail(test::renderer().gpu(), map, kTile, texture);
  EXPECT_TRUE(count) << (count ? "" : count.error().message);
  Tiles t;
  if (!count || *count == 0) return t;
  t.count = *count;
  t.rgba.resize(static_cast<std::size_t>(t.count * kTile * kTile) * 4);
  glGetTextureImage(texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(t.rgba.size()),
                    t.rgba.data());
  return t;
}

const scene::Light& sun() {
  static const scene::Light light = test::sunFrom({0, 1, 0});
  return light;
}

TEST(MapThumbnail, IntervalEndsGoFromDarkToLightAndEmptyOnesAreBlank) {
  // One ball in the middle: the first interval has ends where it is, the others are empty.
  const auto map = test::build(test::improved(2, 4, 64, false), {test::ball({0, 0, 0}, 1, 1)}, sun());
  ASSERT_TRUE(map && map->metric);
  const Tiles t = tilesOf(*map->metric);
  ASSERT_EQ(t.count, 4);
  const vec3 near = t.at(0, kTile / 2, kTile / 2), far = t.at(1, kTile / 2, kTile / 2);
  EXPECT_GT(far.x + far.y + far.z, near.x + near.y + near.z + 60);
  EXPECT_LT(glm::length(t.at(2, kTile / 2, kTile / 2) - t.at(3, kTile / 2, kTile / 2)), 2);
  EXPECT_LT(t.at(2, kTile / 2, kTile / 2).x, 40);
  EXPECT_GT(t.lit(0), 200);
  EXPECT_EQ(t.lit(3), 0);
}

TEST(MapThumbnail, EachCoefficientHasATileAndTheDepthInAllIsWarm) {
  const auto map = test::build(test::improved(2, 6, 64, false), {test::ball({0, 0, 0}, 1, 1)}, sun());
  ASSERT_TRUE(map);
  const Tiles t = tilesOf(*map);
  ASSERT_EQ(t.count, 6);
  const vec3 middle = t.at(0, kTile / 2, kTile / 2), corner = t.at(0, 0, 0);
  EXPECT_GT(middle.x, middle.z + 60);            // positive: orange
  EXPECT_LT(std::abs(corner.x - corner.z), 20);  // nothing: grey
}

TEST(MapThumbnail, SignsAreTold) {
  // Beside its middle a ball lies around half of the ray: the first cosine is negative there.
  const auto map = test::build(test::fourier(5, 64), {test::ball({0, 0, 0}, 1, 1)}, sun());
  ASSERT_TRUE(map);
  const Tiles t = tilesOf(*map);
  ASSERT_EQ(t.count, 5);
  EXPECT_GT(t.at(0, 5, kTile / 2).x, t.at(0, 5, kTile / 2).z + 20);
  EXPECT_GT(t.at(1, 5, kTile / 2).z, t.at(1, 5, kTile / 2).x + 20);
}

TEST(MapThumbnail, OtherKindsOfMaps) {
  const volume::InstanceList ball{test::ball({0, 0, 0}, 1, 1)};
  const auto function = test::build(test::transmittance(4, shadow::Basis::Cosine, 64), ball, sun());
  ASSERT_TRUE(function);
  EXPECT_EQ(tilesOf(*function).count, 4);
  const auto deep = test::build(test::deep(0.01, 64), ball, sun());
  ASSERT_TRUE(deep);
  const Tiles t = tilesOf(*deep);
  ASSERT_EQ(t.count, 2);
  EXPECT_GT(t.lit(0), 200);
  // Less light comes through the middle than past the ball.
  EXPECT_LT(t.at(1, kTile / 2, kTile / 2).y, t.at(1, 0, 0).y);
  shadow::ShadowMap march;
  march.kind = shadow::ShadowMap::Kind::RayMarch;
  EXPECT_EQ(tilesOf(march).count, 0);
}

}  // namespace
}  // namespace pileus
