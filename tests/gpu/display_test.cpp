// What the viewport's display stage makes of pixels: order of gain, view, gamma, channel and marks, and
// layers of pictures.
#include <cmath>
#include <fstream>

#include "renderer/view/display.h"
#include "tests/support/gpu.h"

namespace pileus::test {
namespace {

using view::Channel;
using view::DisplaySettings;

/// One row of pixels as the display shows it, 0..1.
std::vector<vec3> shown(const std::vector<vec4>& pixels, const DisplaySettings& settings,
                        const image::ColorConfig& config) {
  view::Renderer& r = renderer();
  static view::Display display(r.shaders());
  const ivec2 size(static_cast<int>(pixels.size()), 1);
  const gl::Texture picture =
      std::move(*gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(size, 1), "test"));
  glTextureSubImage2D(picture.id(), 0, 0, 0, size.x, 1, GL_RGBA, GL_FLOAT, pixels.data());
  const auto texture = display.draw(picture, size, size, config, settings);
  if (!texture) {
    ADD_FAILURE() << texture.error().message;
    return std::vector<vec3>(pixels.size());
  }
  std::vector<unsigned char> bytes(pixels.size() * 4);
  glGetTextureImage(*texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes.size()), bytes.data());
  std::vector<vec3> out;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    out.push_back(vec3(bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2]) / 255.0f);
  return out;
}

const image::ColorConfig& config() {
  static const auto shipped = image::ColorConfig::shipped().value();
  return *shipped;
}

void expectNear(vec3 a, vec3 b, float tolerance = 0.0045f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

/// The CPU twin of gain, view and gamma.
vec3 twin(vec4 pixel, const DisplaySettings& s) {
  vec4 p = vec4(vec3(pixel) * static_cast<float>(std::exp2(s.exposure)), 1);
  const bool viewed = s.raw || config().applyCpu(s.display, s.view, &p.x, 1, s.look);
  EXPECT_TRUE(viewed);
  for (int c = 0; c < 3; ++c)
    p[c] = std::clamp(std::pow(std::max(p[c], 0.0f), static_cast<float>(1 / s.gamma)), 0.0f, 1.0f);
  return vec3(p);
}

const std::vector<vec4> kPixels{
    {0.18f, 0.18f, 0.18f, 1}, {0.9f, 0.2f, 0.05f, 0.5f}, {0.02f, 0.4f, 3.0f, 0.25f}, {0, 0, 0, 0}};

TEST(Display, GainViewAndGammaInThatOrder) {
  for (const double exposure : {0.0, 1.5})
    for (const double gamma : {1.0, 2.2})
      for (const bool raw : {false, true}) {
        DisplaySettings s;
        s.exposure = exposure, s.gamma = gamma, s.raw = raw;
        const auto got = shown(kPixels, s, config());
        for (std::size_t i = 0; i < kPixels.size(); ++i) {
          SCOPED_TRACE(testing::Message()
                       << "pixel " << i << " exposure " << exposure << " gamma " << gamma << " raw " << raw);
          expectNear(got[i], twin(kPixels[i], s));
        }
      }
}

TEST(Display, ChannelsAreGreyAndWorkWithTheViewTransform) {
  DisplaySettings s;
  for (const Channel c : {Channel::Red, Channel::Green, Channel::Blue}) {
    s.channel = c;
    const auto got = shown(kPixels, s, config());
    for (std::size_t i = 0; i < kPixels.size(); ++i)
      expectNear(got[i], vec3(twin(kPixels[i], DisplaySettings{})[static_cast<int>(c) - 1]));
  }
  s.channel = Channel::Luminance;
  const auto grey = shown(kPixels, s, config());
  const float y = glm::dot(vec3(kPixels[1]), view::kLuminance);
  expectNear(grey[1], twin({y, y, y, 1}, DisplaySettings{}));
  // Alpha is no light: neither gain nor view nor gamma touch it.
  s.exposure = 3, s.gamma = 2;
  s.channel = Channel::Alpha;
  expectNear(shown(kPixels, s, config())[2], vec3(0.25f));
  s.channel = Channel::Transmittance;
  expectNear(shown(kPixels, s, config())[2], vec3(0.75f));
}

TEST(Display, FalseColoursAreBandsOfStops) {
  DisplaySettings s;
  s.falseColor = true;
  std::vector<vec4> pixels;
  for (int stop = -9; stop <= 9; ++stop)
    pixels.push_back(vec4(vec3(static_cast<float>(0.18 * std::exp2(stop))), 1));
  const auto got = shown(pixels, s, config());
  for (int stop = -9; stop <= 9; ++stop)
    expectNear(got[static_cast<std::size_t>(stop + 9)],
               view::exposureBands()[static_cast<std::size_t>(std::clamp(stop, -7, 7) + 7)]);
  s.exposure = 2;
  expectNear(shown({vec4(0.18f)}, s, config())[0], view::exposureBands()[9]);
}

TEST(Display, ZebraMarksWhatIsClippedAndNothingElse) {
  DisplaySettings s;
  s.view = "Un-tone-mapped";
  const std::vector<vec4> pixels{vec4(2, 2, 2, 1),         vec4(2, 2, 2, 1), vec4(2, 2, 2, 1),
                                 vec4(2, 2, 2, 1),         vec4(2, 2, 2, 1), vec4(2, 2, 2, 1),
                                 vec4(0.2f, 0.2f, 0.2f, 1)};
  const auto plain = shown(pixels, s, config());
  s.zebra = true;
  const auto marked = shown(pixels, s, config());
  int stripes = 0;
  for (std::size_t i = 0; i < 6; ++i) stripes += marked[i] != plain[i];
  EXPECT_GE(stripes, 2);
  EXPECT_LE(stripes, 4) << "what is under the stripes stays visible";
  EXPECT_EQ(marked[6], plain[6]);
}

/// A config whose only view multiplies by `gain`.
std::shared_ptr<const image::ColorConfig> gainConfig(const std::filesystem::path& path, double gain) {
  std::ofstream(path) << fmt::format(R"(ocio_profile_version: 2
roles: {{default: ACEScg, scene_linear: ACEScg, aces_interchange: ACES2065-1, cie_xyz_d65_interchange: XYZ}}
displays:
  sRGB: [!<View> {{name: Plain, colorspace: Gained}}]
display_colorspaces:
  - !<ColorSpace> {{name: XYZ}}
colorspaces:
  - !<ColorSpace> {{name: ACES2065-1}}
  - !<ColorSpace> {{name: ACEScg, to_scene_reference: !<BuiltinTransform> {{style: ACEScg_to_ACES2065-1}}}}
  - !<ColorSpace> {{name: Gained, to_scene_reference: !<GroupTransform> {{children: [!<MatrixTransform> {{matrix: [{0}, 0, 0, 0, 0, {0}, 0, 0, 0, 0, {0}, 0, 0, 0, 0, 1]}}, !<BuiltinTransform> {{style: ACEScg_to_ACES2065-1}}]}}}}
)",
                                     1 / gain);
  auto config = image::ColorConfig::load(path.string());
  EXPECT_TRUE(config) << (config ? "" : config.error().message);
  return config ? *config : nullptr;
}

TEST(Display, AConfigReadAnewIsNotTakenForTheOneBeforeIt) {
  // The same file with another content, sooner or later at an address that was used before.
  const auto path = scratchFolder() / "gain.ocio";
  for (int i = 0; i < 60; ++i) {
    const double gain = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 0.5 : 0.25;
    const auto config = gainConfig(path, gain);
    ASSERT_TRUE(config);
    expectNear(shown({vec4(0.6f, 0.4f, 0.2f, 1)}, {}, *config)[0],
               vec3(0.6f, 0.4f, 0.2f) * static_cast<float>(gain));
  }
  const auto half = gainConfig(path, 0.5), again = gainConfig(path, 0.5), whole = gainConfig(path, 1);
  EXPECT_EQ(half->key(), again->key());
  EXPECT_NE(half->key(), whole->key());
}

TEST(Display, LooksComeFromTheConfigAndUnknownOnesAreNamed) {
  EXPECT_TRUE(config().looks().empty());
  const auto missing = config().gpuTransform("", "", "Film");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("there is no look 'Film'"), std::string::npos)
      << missing.error().message;

  const auto path = scratchFolder() / "look.ocio";
  std::ofstream(path) << R"(ocio_profile_version: 2
roles: {default: ACEScg, scene_linear: ACEScg, aces_interchange: ACES2065-1, cie_xyz_d65_interchange: XYZ}
displays:
  sRGB: [!<View> {name: Plain, colorspace: ACEScg}]
looks:
  - !<Look> {name: Half, process_space: ACEScg, transform: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}}
display_colorspaces:
  - !<ColorSpace> {name: XYZ}
colorspaces:
  - !<ColorSpace> {name: ACES2065-1}
  - !<ColorSpace> {name: ACEScg, to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}}
)";
  const auto other = image::ColorConfig::load(path.string());
  ASSERT_TRUE(other) << other.error().message;
  ASSERT_EQ((*other)->looks(), std::vector<std::string>{"Half"});
  DisplaySettings s;
  s.look = "Half";
  expectNear(shown({vec4(0.6f, 0.4f, 0.2f, 1)}, s, **other)[0], vec3(0.3f, 0.2f, 0.1f));
}

/// Two boxes behind each other, seen along -z.
view::RenderScene layered(view::PictureLayer layer) {
  view::RenderScene scene;
  scene.options.size = ivec2(33, 33);
  scene.options.samples = 1;
  scene.options.camera = {dvec3(0, 0, 10), dvec3(0), dvec3(0, 1, 0), 8};
  scene.options.layer = layer;
  scene.volumes = {box(dvec3(0), dvec3(1, 1, 2), 60)};
  scene.lights = {{sunFrom({0, 1, 0}, 2), nullptr}, {sunFrom({0, 0, 1}, 3), nullptr}};
  return scene;
}

std::vector<float> pixels(const view::RenderScene& scene) {
  view::VolumeRenderPass pass(scene);
  while (pass.step(renderer().gpu(), 1e9).value() < 1) {
  }
  std::vector<float> out(static_cast<std::size_t>(scene.options.size.x * scene.options.size.y) * 4);
  glGetTextureImage(pass.picture()->color.id(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(out.size() * 4),
                    out.data());
  return out;
}

TEST(Layers, DepthIsThatOfTheMeanScatteringPoint) {
  const auto p = pixels(layered({view::PictureLayer::Kind::Depth, 0}));
  const std::size_t middle = (16 * 33 + 16) * 4;
  // Dense: 1/60 m behind the front face, which is 9 m away.
  EXPECT_NEAR(p[middle], 9 + 1.0 / 60, 0.02);
  EXPECT_NEAR(p[middle + 3], 1, 1e-3);
  EXPECT_EQ(p[0], 0) << "nothing there";
  EXPECT_EQ(p[3], 0);
  for (const float v : p) EXPECT_TRUE(std::isfinite(v));
}

TEST(Layers, LightsAddUpToThePicture) {
  using Kind = view::PictureLayer::Kind;
  const auto all = pixels(layered({Kind::Beauty, 0})), one = pixels(layered({Kind::Light, 0})),
             two = pixels(layered({Kind::Light, 1}));
  float largest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 4 == 3) {
      EXPECT_EQ(all[i], one[i]);
      continue;
    }
    largest = std::max(largest, all[i]);
    EXPECT_NEAR(all[i], one[i] + two[i], 1e-5f + 1e-4f * all[i]);
  }
  EXPECT_GT(largest, 0.01f);
  const std::size_t middle = (16 * 33 + 16) * 4;
  EXPECT_GT(two[middle], 0);
}

TEST(Layers, ARegionLeavesTheRestAsItWas) {
  view::RenderScene scene = layered({});
  const auto whole = pixels(scene);
  scene.options.region = {{0.25, 0.25}, {0.75, 0.5}};
  auto seed = std::make_shared<view::Picture>();
  seed->size = ivec2(4, 4);
  seed->color = std::move(*gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(4, 4, 1), "seed"));
  seed->color.clear(vec4(7));
  view::VolumeRenderPass pass(scene);
  pass.beginWith(seed);
  while (pass.step(renderer().gpu(), 1e9).value() < 1) {
  }
  std::vector<float> part(whole.size());
  glGetTextureImage(pass.picture()->color.id(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(part.size() * 4),
                    part.data());
  const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 33 + x) * 4; };
  EXPECT_EQ(part[at(16, 14)], whole[at(16, 14)]);
  EXPECT_EQ(part[at(2, 2)], 7);
  EXPECT_EQ(part[at(16, 20)], 7);
}

}  // namespace
}  // namespace pileus::test
