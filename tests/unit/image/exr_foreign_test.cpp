// EXR files laid out as other programs do: tiles, integers, vectors, lone channels, sub-sampling, deep data,
// several parts.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <cstring>

#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus::image {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 50, kHeight = 30;

/// Channel number and pixel in one float that half holds exactly.
float valueAt(std::size_t channel, int x, int y) {
  return static_cast<float>(static_cast<int>(channel) * 128 + (x + y * 3) % 128);
}

struct Planes {
  std::vector<std::vector<float>> values;
  Imf::FrameBuffer frame;
  explicit Planes(const std::vector<std::string>& channels) {
    for (std::size_t c = 0; c < channels.size(); ++c) {
      std::vector<float>& plane = values.emplace_back();
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) plane.push_back(valueAt(c, x, y));
    }
    for (std::size_t c = 0; c < channels.size(); ++c)
      frame.insert(channels[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values[c].data()),
                                           sizeof(float), sizeof(float) * kWidth));
  }
};

Imf::Header header(const std::vector<std::string>& channels) {
  Imf::Header h(kWidth, kHeight);
  for (const std::string& name : channels) h.channels().insert(name, Imf::Channel(Imf::FLOAT));
  return h;
}

fs::path writeFloat(const std::vector<std::string>& channels) {
  const fs::path path = test::scratchFolder() / "foreign.exr";
  Planes planes(channels);
  Imf::OutputFile file(path.c_str(), header(channels), 0);
  file.setFrameBuffer(planes.frame);
  file.writePixels(kHeight);
  return path;
}

void expectChannel(const Image& image, const std::string& layer, int component, std::size_t channel) {
  const Layer* l = image.layer(layer);
  ASSERT_TRUE(l) << layer;
  ASSERT_LT(component, l->channels) << layer;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ASSERT_EQ(l->pixels[static_cast<std::size_t>((y * kWidth + x) * l->channels + component)],
                valueAt(channel, x, y))
          << layer;
}

TEST(ExrForeign, ChannelsBecomeLayersByPrefix) {
  const std::vector<std::string> channels{"A",           "B",      "G",    "N.X",         "N.Y",
                                          "N.Z",         "R",      "Z",    "light.key.B", "light.key.G",
                                          "light.key.R", "mask.Y", "uv.u", "uv.v"};
  const auto read = readExr(writeFloat(channels));
  ASSERT_TRUE(read) << read.error().message;
  std::vector<std::string> names;
  for (const Layer& layer : read->layers) names.push_back(layer.name + ":" + std::to_string(layer.channels));
  EXPECT_EQ(names,
            (std::vector<std::string>{":4", "Z:1", "N:3", "light.key:3", "mask:1", "uv.u:1", "uv.v:1"}));
  expectChannel(*read, "", 0, 6);
  expectChannel(*read, "", 3, 0);
  expectChannel(*read, "N", 0, 3);
  expectChannel(*read, "N", 2, 5);
  expectChannel(*read, "light.key", 0, 10);
  expectChannel(*read, "uv.v", 0, 13);
}

TEST(ExrForeign, PartialColoursKeepTheirChannelNames) {
  const auto read = readExr(writeFloat({"A", "G", "Y"}));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->layers.size(), 3u);
  expectChannel(*read, "", 0, 2);
  expectChannel(*read, "A", 0, 0);
  expectChannel(*read, "G", 0, 1);
}

TEST(ExrForeign, AChannelAndALayerOfOneNameStayApart) {
  const auto read = readExr(writeFloat({"Z", "Z.B", "Z.G", "Z.R"}));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->layers.size(), 2u);
  EXPECT_NE(read->layers[0].name, read->layers[1].name);
  EXPECT_TRUE(writeExr(test::scratchFolder() / "again.exr", *read));
}

TEST(ExrForeign, TilesAndMipmapsRead) {
  const std::vector<std::string> channels{"B", "G", "R"};
  for (const Imf::LevelMode mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS}) {
    const fs::path path = test::scratchFolder() / "tiled.exr";
    {
      Imf::Header h = header(channels);
      h.setTileDescription(Imf::TileDescription(16, 8, mode));
      Planes planes(channels);
      Imf::TiledOutputFile file(path.c_str(), h, 0);
      file.setFrameBuffer(planes.frame);
      for (int level = 0; level < file.numLevels(); ++level)
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
    const auto read = readExr(path);
    ASSERT_TRUE(read) << read.error().message;
    for (int c = 0; c < 3; ++c) expectChannel(*read, "", c, static_cast<std::size_t>(2 - c));
  }
}

TEST(ExrForeign, IntegersAndHalvesBecomeFloats) {
  const fs::path path = test::scratchFolder() / "uint.exr";
  std::vector<unsigned> ids;
  std::vector<Imath::half> halves;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    ids.push_back(static_cast<unsigned>(i) * 9973u);
    halves.emplace_back(static_cast<float>(i) * 0.25f);
  }
  {
    Imf::Header h(kWidth, kHeight);
    h.channels().insert("id", Imf::Channel(Imf::UINT));
    h.channels().insert("Y", Imf::Channel(Imf::HALF));
    Imf::FrameBuffer frame;
    frame.insert("id", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(ids.data()), 4, 4 * kWidth));
    frame.insert("Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data()), 2, 2 * kWidth));
    Imf::OutputFile file(path.c_str(), h, 0);
    file.setFrameBuffer(frame);
    file.writePixels(kHeight);
  }
  const auto read = readExr(path);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_TRUE(read->layer("id") && read->layer(""));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ASSERT_EQ(read->layer("id")->pixels[i], static_cast<float>(ids[i]));
    ASSERT_EQ(read->layer("")->pixels[i], static_cast<float>(i) * 0.25f);
  }
}

TEST(ExrForeign, MissingChromaticitiesAreRec709) {
  const auto read = readExr(writeFloat({"B", "G", "R"}));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->chromaticities.red, vec2(0.64f, 0.33f));
  EXPECT_EQ(read->chromaticities.white, vec2(0.3127f, 0.3290f));
}

TEST(ExrForeign, TheFirstPartIsRead) {
  const fs::path path = test::scratchFolder() / "parts.exr";
  const std::vector<std::string> channels{"B", "G", "R"};
  {
    std::vector<Imf::Header> headers{header(channels), header(channels)};
    headers[0].setName("rgb");
    headers[1].setName("other");
    for (Imf::Header& h : headers) h.setType(Imf::SCANLINEIMAGE);
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2, false, 0);
    for (int part = 0; part < 2; ++part) {
      Planes planes(channels);
      Imf::OutputPart out(file, part);
      out.setFrameBuffer(planes.frame);
      out.writePixels(kHeight);
    }
  }
  const auto read = readExr(path);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->layers.size(), 1u);
  expectChannel(*read, "", 0, 2);
}

TEST(ExrForeign, SubSampledAndLuminanceChromaFilesAreRefusedByName) {
  const fs::path path = test::scratchFolder() / "yca.exr";
  {
    Imf::Header h(kWidth, kHeight);
    h.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    h.channels().insert("RY", Imf::Channel(Imf::FLOAT, 2, 2));
    Planes planes({"Y", "RY"});
    Imf::FrameBuffer frame;
    frame.insert("Y", *planes.frame.findSlice("Y"));
    frame.insert(
        "RY", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(planes.values[1].data()), 4, 4 * kWidth, 2, 2));
    Imf::OutputFile file(path.c_str(), h, 0);
    file.setFrameBuffer(frame);
    file.writePixels(kHeight);
  }
  for (const fs::path& file : {path, writeFloat({"RY", "BY", "Y"})}) {
    const auto read = readExr(file);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Code::Input);
    EXPECT_NE(read.error().message.find("luminance/chroma"), std::string::npos) << read.error().message;
  }
}

TEST(ExrForeign, DeepFilesAreRefusedByName) {
  const fs::path path = test::scratchFolder() / "deep.exr";
  {
    Imf::Header h(4, 4);
    h.setType(Imf::DEEPSCANLINE);
    h.compression() = Imf::ZIPS_COMPRESSION;
    h.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    std::vector<unsigned> counts(16, 1);
    std::vector<float> samples(16, 2.0f);
    std::vector<float*> pointers;
    for (float& s : samples) pointers.push_back(&s);
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), 4, 16));
    frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()), sizeof(float*),
                                     sizeof(float*) * 4, sizeof(float)));
    Imf::DeepScanLineOutputFile file(path.c_str(), h, 0);
    file.setFrameBuffer(frame);
    file.writePixels(4);
  }
  const auto read = readExr(path);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, Code::Input);
  EXPECT_NE(read.error().message.find("deep"), std::string::npos) << read.error().message;
}

/// A picture of one value, as small as its compression can make it.
fs::path writeConstant(Imf::Compression compression, int edge, float value) {
  const fs::path path = test::scratchFolder() / "constant.exr";
  Imf::Header h(edge, edge);
  h.compression() = compression;
  for (const char* name : {"R", "G", "B", "A"}) h.channels().insert(name, Imf::Channel(Imf::FLOAT));
  const std::vector<float> row(static_cast<std::size_t>(edge), value);
  Imf::FrameBuffer frame;
  for (const char* name : {"R", "G", "B", "A"})  // every row is that one
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(row.data())),
                                  sizeof(float), 0));
  Imf::OutputFile file(path.c_str(), h, 0);
  file.setFrameBuffer(frame);
  file.writePixels(edge);
  return path;
}

TEST(ExrForeign, ConstantPicturesReadHoweverSmallTheirFilesAre) {
  for (const auto compression :
       {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
        Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION,
        Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION})
    for (const float value : {0.0f, 0.5f}) {
      constexpr int kEdge = 1024;
      const fs::path path = writeConstant(compression, kEdge, value);
      const auto read = readExr(path);
      std::printf("compression %d, %g: %.0f : 1\n", int(compression), double(value),
                  16.0 * kEdge * kEdge / static_cast<double>(fs::file_size(path)));
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_NEAR(read->layers[0].pixels.back(), value, 2e-3);
    }
}

TEST(ExrForeign, AClaimThatTheFileCannotHoldIsRefused) {
  // 64 KiB of honest noise behind a header that says 8000 x 8000.
  const fs::path path = test::scratchFolder() / "claims.exr";
  constexpr int kEdge = 100, kClaimed = 8000;
  for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIP_COMPRESSION,
                                 Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION}) {
    Imf::Header h(kEdge, kEdge);
    h.compression() = compression;
    for (const char* name : {"R", "G", "B", "A"}) h.channels().insert(name, Imf::Channel(Imf::FLOAT));
    std::vector<float> pixels;
    unsigned state = 1;
    for (int i = 0; i < kEdge * kEdge; ++i)
      pixels.push_back(static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) * 1e-7f);
    Imf::FrameBuffer frame;
    for (const char* name : {"R", "G", "B", "A"})
      frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
                                    sizeof(float) * kEdge));
    {
      Imf::OutputFile file(path.c_str(), h, 0);
      file.setFrameBuffer(frame);
      file.writePixels(kEdge);
    }
    std::string bytes = *readFile(path);
    const std::size_t at = bytes.find("dataWindow");
    ASSERT_NE(at, std::string::npos);
    const std::int32_t last = kClaimed - 1;
    const std::size_t box = at + std::string("dataWindow").size() + 1 + std::string("box2i").size() + 1 + 4;
    for (const std::size_t side : {box + 8, box + 12}) std::memcpy(&bytes[side], &last, 4);
    bytes.resize(std::max(bytes.size(), std::size_t(200000)), '\0');  // enough for the table of chunks
    ASSERT_TRUE(writeFileAtomic(path, bytes));
    const auto read = readExr(path);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("too short"), std::string::npos)
        << "compression " << compression << ": " << read.error().message;
  }
}

TEST(ExrForeign, HeadersThatClaimAbsurdSizesHaveNoMetadata) {
  const fs::path path = writeFloat({"R", "G", "B"});
  std::string bytes = *readFile(path);
  const std::size_t box = bytes.find("dataWindow") + 10 + 1 + 5 + 1 + 4;
  const std::int32_t last = 1 << 28;
  std::memcpy(&bytes[box + 8], &last, 4);
  ASSERT_TRUE(writeFileAtomic(path, bytes));
  EXPECT_FALSE(readExrMetadata(path));
}

}  // namespace
}  // namespace pileus::image
