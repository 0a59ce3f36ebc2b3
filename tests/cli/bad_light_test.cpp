// Light and media that no picture can be made of, through the command line: a message that says what and
// where, or a clamp that is documented, and nothing in a file that is not finite.
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

namespace fs = std::filesystem;

/// A box in the light of an environment, 24 x 14 pixels.
fs::path graph(const fs::path& folder, const std::string& render, const std::string& file,
               const std::string& medium = R"("extinction": 2)") {
  const fs::path path = folder / "graph.json";
  std::ofstream(path, std::ios::binary) << R"({ "pileus": 2, "settings": { "size": [24, 14] },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": {} },
    "Medium": { "type": "volume.medium", "at": [0, 0], "params": { )" +
                                               medium + R"( } },
    "Light": { "type": "light.environment", "at": [0, 0], "params": { "file": ")" +
                                               file + R"(" } },
    "Render": { "type": "render.)" + render + R"(", "at": [0, 0], "params": { "samples": 2 } },
    "EXR": { "type": "output.exr", "at": [0, 0], "params": { "type": "float" } } },
  "links": [ "Box.volume -> Medium.volume", "Medium.volume -> Render.volumes", "Light.light -> Render.lights",
             "Render.image -> EXR.image" ] })";
  return path;
}

image::Image even(ivec2 size, float value) {
  image::Image out;
  out.size = size;
  out.layers = {{"", 3, std::vector<float>(std::size_t(size.x) * std::size_t(size.y) * 3, value)}};
  return out;
}

/// A map in which one value is put that no picture of ours may hold.
void writePatched(const fs::path& path, float value) {
  image::Image map = even({8, 4}, 0.75f);
  const float mark = 1234.5f;
  map.layers[0].pixels[10] = mark;
  ASSERT_TRUE(image::writeExr(path, map, {image::PixelType::Float, image::Compression::None}));
  std::string bytes = *readFile(path);
  const std::string from(reinterpret_cast<const char*>(&mark), 4),
      to(reinterpret_cast<const char*>(&value), 4);
  const std::size_t at = bytes.find(from);
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(bytes.find(from, at + 1), std::string::npos);
  bytes.replace(at, 4, to);
  ASSERT_TRUE(writeFileAtomic(path, bytes));
}

/// The file is there and holds numbers only; the sum of its RGB.
double sumOf(const fs::path& path) {
  const auto picture = image::readExr(path);
  if (!picture) {
    ADD_FAILURE() << picture.error().message;
    return 0;
  }
  double sum = 0;
  std::size_t wrong = 0;
  for (const image::Layer& layer : picture->layers)
    for (const float v : layer.pixels) wrong += !std::isfinite(v), sum += std::isfinite(v) ? double(v) : 0;
  EXPECT_EQ(wrong, 0u) << path;
  return sum;
}

struct Case {
  std::string file;
  std::string says;      ///< on standard error; of a warning or of why it is refused
  bool renders = false;  ///< else: it is refused, and nothing is written
};

void expectAll(const fs::path& folder, const std::vector<Case>& cases) {
  test::ExpectLogged expected;
  for (const std::string render : {"volume", "path_trace"})
    for (const Case& c : cases) {
      SCOPED_TRACE(render + ": " + c.file);
      const fs::path out = folder / "out.exr";
      fs::remove(out);
      const auto r = test::pileus({"render", graph(folder, render, c.file), "-o", out});
      EXPECT_NE(r.err.find(c.says), std::string::npos) << r.err;
      EXPECT_EQ(r.exitCode, c.renders ? 0 : 3) << r.out << r.err;
      EXPECT_EQ(fs::exists(out), c.renders);
      if (c.renders) {
        EXPECT_GT(sumOf(out), 0);
      } else {
        EXPECT_NE(r.err.find(fs::path(c.file).filename().string()), std::string::npos) << r.err;
      }
    }
}

TEST(BadLight, EnvironmentFiles) {
  const fs::path folder = test::scratchFolder();
  const auto text = [&](const char* name, const std::string& size, const std::string& rest) {
    const fs::path path = folder / name;
    std::ofstream(path, std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + rest;
    return path.string();
  };
  const auto exr = [&](const char* name, const image::Image& map) {
    EXPECT_TRUE(image::writeExr(folder / name, map, {image::PixelType::Float, image::Compression::Zip}));
    return (folder / name).string();
  };
  const auto patched = [&](const char* name, float value) {
    writePatched(folder / name, value);
    return (folder / name).string();
  };
  const std::string cut = exr("cut.exr", even({64, 32}, 0.5f));
  fs::resize_file(cut, fs::file_size(cut) / 2);
  const std::string pixel("\x80\x80\x80\x81", 4);
  const float infinite = std::numeric_limits<float>::infinity();
  expectAll(folder, {{(folder / "missing.exr").string(), "there is no such file"},
                     {cut, "cut.exr"},
                     {text("cut.hdr", "-Y 8192 +X 16384", "abcd"), "too short"},
                     {text("huge.hdr", "-Y 16000 +X 32000", ""), "more than can be read"},
                     {text("none.hdr", "-Y 0 +X 0", ""), "no pixels"},
                     {text("turned.hdr", "+Y 1 +X 1", pixel), "turned or mirrored"},
                     {text("one.hdr", "-Y 1 +X 1", pixel), "", true},
                     {exr("one.exr", even({1, 1}, 0.5f)), "", true},
                     {exr("bright.exr", even({8, 4}, 3e38f)), "too bright", true},
                     {patched("nan.exr", std::numeric_limits<float>::quiet_NaN()), "not numbers", true},
                     {patched("infinite.exr", infinite), "infinite", true},
                     {patched("below.exr", -infinite), "", true},
                     {patched("negative.exr", -3.0f), "negative", true}});
}

// Files of other programs, good and damaged: each is refused by name or gives numbers.
TEST(BadLight, EnvironmentsOfOtherPrograms) {
  PILEUS_NEEDS_DATA();
  test::ExpectLogged expected;
  const fs::path folder = test::scratchFolder();
  int read = 0, refused = 0;
  for (const char* from : {"exr", "exr_damaged"})
    for (const auto& entry : fs::recursive_directory_iterator(*test::dataFolder() / from)) {
      if (!entry.is_regular_file()) continue;
      if (std::string_view(from) == "exr_damaged" && ++refused % 8 != 0) continue;  // all: EnvironmentImport
      SCOPED_TRACE(entry.path().string());
      const fs::path out = folder / "out.exr";
      fs::remove(out);
      const auto r = test::pileus({"render", graph(folder, "path_trace", entry.path().string()), "-o", out});
      if (r.exitCode == 0) {
        ++read;
        sumOf(out);
      } else {
        EXPECT_EQ(r.exitCode, 3) << r.err;
        EXPECT_NE(r.err.find(entry.path().filename().string()), std::string::npos) << r.err;
        EXPECT_FALSE(fs::exists(out));
      }
    }
  EXPECT_GE(read, 3);
  EXPECT_NE(
      test::pileus({"render",
                    graph(folder, "path_trace", (*test::dataFolder() / "exr" / "WavyLinesCube.exr").string()),
                    "-o", folder / "cube.exr"})
          .err.find("cube map"),
      std::string::npos);
}

TEST(BadLight, MediaAtTheirEnds) {
  test::ExpectLogged expected;
  const fs::path folder = test::scratchFolder(), map = folder / "even.exr", out = folder / "out.exr";
  ASSERT_TRUE(image::writeExr(map, even({8, 4}, 1.0f)));
  const auto rendered = [&](const std::string& render, const std::string& medium) {
    fs::remove(out);
    return test::pileus({"render", graph(folder, render, map.string(), medium), "-o", out});
  };
  for (const std::string render : {"volume", "path_trace"}) {
    for (const char* g : {"1", "-1"}) {
      SCOPED_TRACE(render + ", g " + g);
      const auto r = rendered(render, std::string(R"("extinction": 2, "anisotropy": )") + g);
      EXPECT_EQ(r.exitCode, 0) << r.err;
      EXPECT_NE(r.err.find("rendered with +-0.9999"), std::string::npos) << r.err;
      EXPECT_GT(sumOf(out), 0);
    }
    for (const char* medium : {R"("albedo": [1.5, 1, 1])", R"("albedo": [-0.1, 1, 1])",
                               R"("anisotropy": 1.5)", R"("extinction": -1)"}) {
      SCOPED_TRACE(render + ", " + medium);
      const auto r = rendered(render, medium);
      EXPECT_NE(r.exitCode, 0) << r.err;
      EXPECT_NE(r.err.find("Medium"), std::string::npos) << r.err;
      EXPECT_FALSE(fs::exists(out));
    }
  }
}

}  // namespace
}  // namespace pileus
