// EXR files as written and read by Pileus: round trips, layers, windows, refusals.
#include "renderer/image/exr.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus::image {
namespace {

namespace fs = std::filesystem;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Values of many magnitudes and both signs; the same for the same arguments.
Layer makeLayer(const std::string& name, int channels, ivec2 size) {
  Layer layer{name, channels, {}};
  unsigned state = 1u + static_cast<unsigned>(name.size()) * 977u + static_cast<unsigned>(channels);
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                            static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < count; ++i) {
    state = state * 1664525u + 1013904223u;
    const float mantissa = static_cast<float>(state >> 8) / 8388608.0f - 1.0f;
    layer.pixels.push_back(std::ldexp(mantissa, static_cast<int>(i % 20) - 10));
  }
  return layer;
}

Image makeImage(ivec2 size = {67, 41}) {
  Image image;
  image.size = size;
  image.layers = {makeLayer("", 4, size), makeLayer("direct", 3, size), makeLayer("volume.tau", 1, size)};
  return image;
}

/// The first value that differs by more than `relative` of its size (or 2^-24, half's smallest step).
void expectClose(const Layer& expected, const Layer& read, float relative) {
  ASSERT_EQ(expected.channels, read.channels) << expected.name;
  ASSERT_EQ(expected.pixels.size(), read.pixels.size()) << expected.name;
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    const float tolerance =
        relative == 0.0f ? 0.0f : std::max(std::abs(expected.pixels[i]) * relative, 6e-8f);
    ASSERT_LE(std::abs(expected.pixels[i] - read.pixels[i]), tolerance)
        << "layer '" << expected.name << "', value " << i;
  }
}

class RoundTrip : public testing::TestWithParam<Compression> {};

TEST_P(RoundTrip, KeepsEveryLayer) {
  const fs::path folder = test::scratchFolder();
  const Image image = makeImage();
  for (const PixelType type : {PixelType::Half, PixelType::Float}) {
    const fs::path path = folder / fmt::format("{}-{}.exr", enumId(GetParam()), enumId(type));
    const auto written = writeExr(path, image, {type, GetParam()});
    ASSERT_TRUE(written) << written.error().message;
    const auto read = readExr(path);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->size, image.size);
    EXPECT_EQ(read->displaySize, image.size);
    EXPECT_EQ(read->dataOrigin, ivec2(0));
    ASSERT_EQ(read->layers.size(), image.layers.size());
    EXPECT_EQ(read->layers.front().name, "");
    for (const Layer& layer : image.layers) {
      const Layer* twin = read->layer(layer.name);
      ASSERT_TRUE(twin) << layer.name;
      // DWAA is lossy by design and meant for smooth pictures; here only the frame around the values is of
      // interest.
      if (GetParam() == Compression::Dwaa)
        EXPECT_EQ(twin->pixels.size(), layer.pixels.size());
      else
        expectClose(layer, *twin, type == PixelType::Half ? 1.0f / 2048.0f : 0.0f);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Exr, RoundTrip,
                         testing::Values(Compression::None, Compression::Zips, Compression::Zip,
                                         Compression::Piz, Compression::Dwaa),
                         [](const auto& param) { return std::string(enumId(param.param)); });

TEST(Exr, DwaaStaysNearSmoothPictures) {
  Image image;
  image.size = {128, 96};
  Layer layer{"", 4, {}};
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 128; ++x)
      for (int c = 0; c < 4; ++c)
        layer.pixels.push_back(c == 3 ? 1.0f : 0.5f + 0.4f * std::sin(0.05f * static_cast<float>(x + c * y)));
  image.layers = {layer};
  const fs::path path = test::scratchFolder() / "smooth.exr";
  ASSERT_TRUE(writeExr(path, image, {PixelType::Half, Compression::Dwaa}));
  const auto read = readExr(path);
  ASSERT_TRUE(read) << read.error().message;
  for (std::size_t i = 0; i < layer.pixels.size(); ++i)
    ASSERT_NEAR(read->layers[0].pixels[i], layer.pixels[i], 0.02f) << i;
}

TEST(Exr, ChannelNamesAreThoseOfOtherPrograms) {
  const fs::path path = test::scratchFolder() / "names.exr";
  ASSERT_TRUE(writeExr(path, makeImage({4, 4}), {PixelType::Float, Compression::None}));
  const auto bytes = readFile(path);
  ASSERT_TRUE(bytes);
  for (const char* name : {"R", "G", "B", "A", "direct.R", "direct.G", "direct.B", "volume.tau.Y"})
    EXPECT_NE(bytes->find(std::string(1, '\0') + name + std::string(1, '\0')), std::string::npos) << name;
  EXPECT_EQ(bytes->find("direct.A"), std::string::npos);
}

TEST(Exr, KeepsWindowsChromaticitiesAndMetadata) {
  Image image = makeImage({20, 10});
  image.dataOrigin = {-3, 7};
  image.displaySize = {640, 360};
  image.metadata = {{"comments", "low sun"}, {"pileus:graph", "0123"}, {"empty", ""}};
  const fs::path path = test::scratchFolder() / "window.exr";
  const auto written = writeExr(path, image, {PixelType::Float, Compression::Zip});
  ASSERT_TRUE(written) << written.error().message;
  const auto read = readExr(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->size, image.size);
  EXPECT_EQ(read->dataOrigin, image.dataOrigin);
  EXPECT_EQ(read->displaySize, image.displaySize);
  EXPECT_EQ(read->metadata, image.metadata);
  expectClose(image.layers[0], read->layers[0], 0.0f);
  const Chromaticities acescg;
  EXPECT_EQ(read->chromaticities.red, acescg.red);
  EXPECT_EQ(read->chromaticities.green, acescg.green);
  EXPECT_EQ(read->chromaticities.blue, acescg.blue);
  EXPECT_EQ(read->chromaticities.white, acescg.white);
}

TEST(Exr, LongMetadataNamesAreShortenedAndStayDistinct) {
  Image image = makeImage({4, 4});
  const std::string stem = "pileus:a name that is much longer than allowed ";
  image.metadata = {{stem + "1", "one"}, {stem + "2", "two"}};
  const fs::path folder = test::scratchFolder();
  ASSERT_TRUE(writeExr(folder / "a.exr", image));
  ASSERT_TRUE(writeExr(folder / "b.exr", image));
  EXPECT_EQ(*readFile(folder / "a.exr"), *readFile(folder / "b.exr"));
  const auto read = readExr(folder / "a.exr");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->metadata.size(), 2u);
  for (const auto& [name, value] : read->metadata) {
    EXPECT_EQ(name.size(), 31u);
    EXPECT_EQ(name.substr(0, 22), stem.substr(0, 22));
  }
  // The flag for long names would make the file unreadable to old programs.
  const std::string bytes = *readFile(folder / "a.exr");
  EXPECT_EQ(static_cast<unsigned char>(bytes[5]) & 0x04, 0);
}

TEST(Exr, ReservedMetadataIsRefused) {
  for (const char* name : {"channels", "compression", "type", "dataWindow", "chromaticities", ""}) {
    Image image = makeImage({4, 4});
    image.metadata = {{name, "x"}};
    const auto written = writeExr(test::scratchFolder() / "x.exr", image);
    ASSERT_FALSE(written) << name;
    EXPECT_NE(written.error().message.find(fmt::format("'{}'", name)), std::string::npos);
  }
}

TEST(Exr, HalfClampsToItsLargestValue) {
  Image image;
  image.size = {4, 1};
  image.layers = {{"", 1, {1e9f, -1e9f, 65504.0f, 65519.9f}}};
  const fs::path path = test::scratchFolder() / "clamp.exr";
  std::vector<std::string> warnings;
  ASSERT_TRUE(writeExr(path, image, {}, &warnings));
  EXPECT_EQ(warnings.size(), 1u);
  const auto read = readExr(path);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->layers[0].pixels, (std::vector<float>{65504.0f, -65504.0f, 65504.0f, 65504.0f}));
  ASSERT_TRUE(writeExr(path, image, {PixelType::Float, Compression::Zip}));
  EXPECT_EQ(readExr(path)->layers[0].pixels, image.layers[0].pixels);
}

TEST(Exr, ClampedPixelsAreCountedOnce) {
  Image image = makeImage({16, 8});
  image.layers[0].pixels[5] = 1e6f;  // of one pixel, in two channels and two layers
  image.layers[0].pixels[6] = -1e6f;
  image.layers[1].pixels[4] = 1e6f;
  image.layers[0].pixels[40] = 65510.0f;  // rounds to the largest half
  std::vector<std::string> warnings;
  ASSERT_TRUE(encodeExr(image, {PixelType::Half, Compression::Zip}, warnings));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "1 pixel is brighter than half floats can hold: clamped to 65504 (float as type keeps them)");
  image.layers[2].pixels[100] = 7e4f;
  warnings.clear();
  ASSERT_TRUE(encodeExr(image, {PixelType::Half, Compression::Zip}, warnings));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].substr(0, 12), "2 pixels are");
  warnings.clear();
  ASSERT_TRUE(encodeExr(image, {PixelType::Float, Compression::Zip}, warnings));
  EXPECT_TRUE(warnings.empty());
}

TEST(Exr, FinitePixelsAreReadBackFiniteInEveryCompression) {
  // Highlights at the limit of halves over a dark ground: lossy compression rounds beyond it.
  constexpr ivec2 kSize{64, 48};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> dark(0, 1), bright(60000, 65504);
  Image image;
  image.size = kSize;
  for (const char* name : {"", "Sun", "emission", "depth"}) {
    Layer layer{name, *name == 'd' ? 1 : 4, {}};
    layer.data = layer.channels == 1;
    for (int i = 0; i < kSize.x * kSize.y * layer.channels; ++i)
      layer.pixels.push_back(random() % 10 == 0 ? bright(random) : dark(random));
    image.layers.push_back(std::move(layer));
  }
  for (const PixelType type : {PixelType::Half, PixelType::Float})
    for (const Compression compression :
         {Compression::None, Compression::Zips, Compression::Zip, Compression::Piz, Compression::Dwaa}) {
      // A whole patch far beyond, too: what halves cannot hold at all.
      Image beyond = image;
      for (std::size_t i = 0; i < 4 * 64 * 8; ++i) beyond.layers[1].pixels[i] = 1e6f;
      for (const Image& one : {image, beyond}) {
        const fs::path path = test::scratchFolder() / "a.exr";
        std::vector<std::string> warnings;
        ASSERT_TRUE(writeExr(path, one, {type, compression}, &warnings));
        const auto read = readExr(path);
        ASSERT_TRUE(read) << read.error().message;
        ASSERT_EQ(read->layers.size(), 4u);
        for (const Layer& layer : read->layers)
          for (std::size_t i = 0; i < layer.pixels.size(); ++i)
            ASSERT_TRUE(std::isfinite(layer.pixels[i]))
                << enumId(type) << ", " << enumId(compression) << ", '" << layer.name << "', value " << i;
        if (compression == Compression::Dwaa) {
          ASSERT_FALSE(warnings.empty());
          EXPECT_NE(warnings.back().find("a.exr: DWAA would make infinities"), std::string::npos);
        }
      }
    }
}

TEST(Exr, NonFiniteValuesReachNoFile) {
  for (const float bad : {std::nanf(""), kInfinity, -kInfinity}) {
    Image image = makeImage({8, 6});
    image.layers[1].pixels[(3 * 8 + 5) * 3 + 1] = bad;
    const fs::path path = test::scratchFolder() / "bad.exr";
    const auto written = writeExr(path, image);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, Code::Internal);
    EXPECT_NE(written.error().message.find("layer 'direct', channel G, pixel (5, 3)"), std::string::npos)
        << written.error().message;
    EXPECT_FALSE(fs::exists(path));
  }
}

TEST(Exr, MalformedPicturesAreRefused) {
  const fs::path path = test::scratchFolder() / "x.exr";
  Image none;
  EXPECT_FALSE(writeExr(path, none));
  Image noLayers;
  noLayers.size = {2, 2};
  EXPECT_FALSE(writeExr(path, noLayers));
  Image tooFew = makeImage({4, 4});
  tooFew.layers[0].pixels.pop_back();
  EXPECT_FALSE(writeExr(path, tooFew));
  Image twice = makeImage({4, 4});
  twice.layers.push_back(twice.layers[1]);
  EXPECT_FALSE(writeExr(path, twice));
  Image two = makeImage({4, 4});
  two.layers[0] = makeLayer("", 2, {4, 4});
  EXPECT_FALSE(writeExr(path, two));
  EXPECT_FALSE(fs::exists(path));
}

TEST(Exr, UnwritableTargetIsNamedAndKept) {
  const fs::path folder = test::scratchFolder();
  const auto missing = writeExr(folder / "none" / "a.exr", makeImage({4, 4}));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, Code::Input);
  EXPECT_NE(missing.error().message.find((folder / "none" / "a.exr").string()), std::string::npos);
  fs::create_directory(folder / "folder.exr");
  const auto onFolder = writeExr(folder / "folder.exr", makeImage({4, 4}));
  ASSERT_FALSE(onFolder);
  EXPECT_EQ(onFolder.error().code, Code::Input);
  // Nothing is left behind, and a failed write keeps the old file.
  ASSERT_TRUE(writeExr(folder / "a.exr", makeImage({4, 4})));
  const std::string before = *readFile(folder / "a.exr");
  Image bad = makeImage({4, 4});
  bad.layers[0].pixels[0] = std::nanf("");
  ASSERT_FALSE(writeExr(folder / "a.exr", bad));
  EXPECT_EQ(*readFile(folder / "a.exr"), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST(Exr, ReadRefusesWhatIsNoPicture) {
  const fs::path folder = test::scratchFolder();
  std::ofstream(folder / "text.exr") << "not a picture\n";
  std::ofstream(folder / "empty.exr");
  for (const fs::path& path : {folder / "text.exr", folder / "empty.exr", folder / "missing.exr", folder}) {
    const auto read = readExr(path);
    ASSERT_FALSE(read) << path;
    EXPECT_EQ(read.error().code, Code::Input);
    EXPECT_EQ(read.error().message.find(path.string()), 0u) << read.error().message;
  }
}

/// Bits and bytes changed at random in files of every compression, each read in a process of its own.
TEST(Exr, MutatedFilesNeverCrash) {
  const fs::path folder = test::scratchFolder();
  std::vector<std::string> seeds;
  for (const auto& item : enumInfo(static_cast<Compression*>(nullptr))) {
    ASSERT_TRUE(writeExr(folder / "seed.exr", makeImage({37, 40}), {PixelType::Half, item.value}));
    seeds.push_back(*readFile(folder / "seed.exr"));
  }
  for (unsigned run = 0; run < 400; ++run) {
    std::mt19937 random(run);
    std::string bytes = seeds[run % seeds.size()];
    for (auto changes = 1 + random() % 6; changes > 0; --changes) {
      const std::size_t at =
          random() % (random() % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 700));
      bytes[at] = static_cast<char>(
          random() % 2 ? random() : static_cast<unsigned char>(bytes[at]) ^ 1u << random() % 8);
    }
    std::ofstream(folder / "mutated.exr", std::ios::binary) << bytes;
    const pid_t child = ::fork();
    if (child == 0) {
      ::alarm(10);
      const auto read = readExr(folder / "mutated.exr");
      ::_exit(read || read.error().code == Code::Input ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << "mutation " << run << " ended with signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 0) << "mutation " << run;
  }
}

TEST(Exr, EveryTruncationIsAnError) {
  const fs::path folder = test::scratchFolder();
  ASSERT_TRUE(writeExr(folder / "whole.exr", makeImage({16, 40})));
  const std::string whole = *readFile(folder / "whole.exr");
  for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 97) {
    std::ofstream(folder / "cut.exr", std::ios::binary)
        .write(whole.data(), static_cast<std::streamsize>(length));
    const auto read = readExr(folder / "cut.exr");
    ASSERT_FALSE(read) << length << " of " << whole.size() << " bytes";
    EXPECT_EQ(read.error().code, Code::Input);
    EXPECT_LE(read.error().message.size(), 1500u);
  }
}

}  // namespace
}  // namespace pileus::image
