// `pileus render`: pictures, overrides, sequences, and every kind of bad input with its exit code and
// message.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "editor/cli/render.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

namespace fs = std::filesystem;

/// A lit box; `extra` nodes and `params` can be put in.
std::string graph(const std::string& settings = R"("size": [64, 36])", const std::string& box = "",
                  const std::string& moreNodes = "", const std::string& moreLinks = "") {
  return R"({ "pileus": 1, "settings": { )" + settings + R"( },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { )" +
         box + R"( } },
    "Sun": { "type": "light.sun", "at": [0, 0], "params": {} },
    "Metric": { "type": "shadow.pseudometric", "at": [0, 0], "params": { "resolution": 64 } },
    "Extinction": { "type": "shadow.extinction", "at": [0, 0], "params": {} },
    "Render": { "type": "render.volume", "at": [0, 0], "params": { "samples": 1 } })" +
         moreNodes + R"(,
    "View": { "type": "output.view", "at": [0, 0], "params": {} } },
  "links": [ "Box.volume -> Metric.volumes", "Sun.light -> Metric.light", "Metric.metric -> Extinction.metric", "Box.volume -> Render.volumes",
             "Extinction.light -> Render.lights", "Render.image -> View.image")" +
         moreLinks + R"( ] })";
}

fs::path write(const fs::path& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name, std::ios::binary) << text;
  return folder / name;
}

void expectFails(const test::RunResult& r, int code, const std::vector<std::string>& words) {
  EXPECT_EQ(r.exitCode, code) << r.out << r.err;
  for (const std::string& w : words)
    EXPECT_NE(r.err.find(w), std::string::npos) << "'" << w << "' is not in: " << r.err;
}

TEST(Render, WritesALitPictureAndRefusesToOverwrite) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph()),
                 out = folder / "a.exr";
  const auto r = test::pileus({"render", file, "-o", out, "--png", "--stats", folder / "s.json"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const auto picture = image::readExr(out);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->size, ivec2(64, 36));
  const float* centre = &picture->layers[0].pixels[(18 * 64 + 32) * 4];
  EXPECT_GT(centre[0], 0.05f);
  EXPECT_GT(centre[3], 0.5f);
  EXPECT_NEAR(picture->chromaticities.red.x, 0.713f, 1e-4f);
  EXPECT_TRUE(fs::exists(folder / "a.png"));
  const auto about = image::readExrMetadata(out);
  ASSERT_TRUE(about) << about.error().message;
  const auto carried = nodes::parseGraph(about->at(image::kGraphAttribute));
  ASSERT_TRUE(carried) << carried.error().message;
  EXPECT_EQ(carried->graph, nodes::loadGraph(file)->graph) << "the still opens the graph it was made of";
  EXPECT_TRUE(fs::exists(folder / "s.json"));
  expectFails(test::pileus({"render", file, "-o", out}), 3, {"a.exr", "--overwrite"});
  EXPECT_EQ(test::pileus({"render", file, "-o", out, "--overwrite", "--size", "32x18"}).exitCode, 0);
  EXPECT_EQ(image::readExr(out)->size, ivec2(32, 18));
}

TEST(Render, SetOverridesParameters) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph());
  ASSERT_EQ(test::pileus({"render", file, "-o", folder / "a.exr"}).exitCode, 0);
  ASSERT_EQ(test::pileus({"render", file, "-o", folder / "b.exr", "--set", "Sun.irradiance=20"}).exitCode, 0);
  const auto a = image::readExr(folder / "a.exr"), b = image::readExr(folder / "b.exr");
  const std::size_t centre = (18 * 64 + 32) * 4;
  EXPECT_NEAR(b->layers[0].pixels[centre], 2 * a->layers[0].pixels[centre],
              2e-3f * b->layers[0].pixels[centre]);
  expectFails(test::pileus({"render", file, "-o", folder / "c.exr", "--set", "Moon.irradiance=20"}), 2,
              {"Moon"});
  expectFails(test::pileus({"render", file, "-o", folder / "c.exr", "--set", "Sun.brightness=20"}), 2,
              {"Sun", "brightness"});
  expectFails(test::pileus({"render", file, "-o", folder / "c.exr", "--set", "Metric.resolution=1000000"}), 2,
              {"Metric.resolution", "4096"});
  expectFails(test::pileus({"render", file, "-o", folder / "c.exr", "--set", "nonsense"}), 2, {"nonsense"});
}

TEST(Render, Sequences) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph());
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr", "--frames", "1-3"}), 2, {"token"});
  ASSERT_EQ(test::pileus({"render", file, "-o", folder / "a.####.exr", "--frames", "1-5x2"}).exitCode, 0);
  EXPECT_TRUE(fs::exists(folder / "a.0001.exr") && fs::exists(folder / "a.0003.exr") &&
              fs::exists(folder / "a.0005.exr"));
  // A whole frame is skipped, a broken one is rendered again.
  write(folder, "a.0003.exr", "cut off");
  const auto again = test::pileus({"render", file, "-o", folder / "a.####.exr", "--frames", "1-5x2"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_NE(again.err.find("skipped"), std::string::npos);
  EXPECT_TRUE(image::readExr(folder / "a.0003.exr"));
  EXPECT_EQ(cli::framePath("x.%04d.exr", 7), "x.0007.exr");
  EXPECT_EQ(cli::framePath("x.$F.exr", 7), "x.7.exr");
  EXPECT_EQ(cli::framePath("x#.exr", 12), "x12.exr");
}

TEST(Render, BadArguments) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph());
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr", "--size", "0x0"}), 2, {"0x0"});
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr", "--size", "wide"}), 2, {"wide"});
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr", "--frames", "5-1"}), 2, {"5-1"});
  expectFails(test::pileus({"render", file}), 2, {"-o"});
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr", "--nonsense"}), 2, {});
  expectFails(test::pileus({"render"}), 2, {});
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr", "--output", "Nobody"}), 2, {"Nobody"});
  expectFails(test::pileus({"render", file, "-o", folder / "no" / "such" / "a.exr"}), 3, {"a.exr"});
}

TEST(Render, SeveralOutputsNeedAName) {
  const std::string second = R"(, "Second": { "type": "output.view", "at": [0, 0], "params": {} })",
                    link = R"(, "Render.image -> Second.image")";
  const fs::path folder = test::scratchFolder(),
                 file = write(folder, "a.json", graph(R"("size": [32, 18])", "", second, link));
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr"}), 2, {"--output", "Second"});
  EXPECT_EQ(test::pileus({"render", file, "-o", folder / "a.exr", "--output", "Second"}).exitCode, 0);
  const std::string exr =
      R"(, "Still": { "type": "output.exr", "at": [0, 0], "params": { "type": "float" } })";
  const fs::path still =
      write(folder, "b.json", graph(R"("size": [32, 18])", "", exr, R"(, "Render.image -> Still.image")"));
  EXPECT_EQ(test::pileus({"render", still, "-o", folder / "b.exr"}).exitCode, 0)
      << "an EXR output goes before a view";
}

TEST(Render, BadFiles) {
  const fs::path folder = test::scratchFolder(), out = folder / "out.exr";
  const auto render = [&](const std::string& text) {
    return test::pileus({"render", write(folder, "bad.json", text), "-o", out});
  };
  expectFails(test::pileus({"render", folder / "missing.json", "-o", out}), 3, {"missing.json"});
  expectFails(render("{ \"pileus\": 1, \"nodes\": "), 3, {"bad.json", "line"});
  expectFails(render("[1, 2]"), 3, {"bad.json"});
  expectFails(render(R"({ "pileus": 99, "nodes": {} })"), 3, {"99"});
  expectFails(render(graph(R"("size": [0, 0])")), 3, {"size"});
  expectFails(render(graph(R"("size": [64, 36])", R"("density": "thick")")), 3, {"Box.density"});
  expectFails(
      render(graph(
          R"("size": [64, 36])", "",
          R"(, "T": { "type": "volume.transform", "at": [0,0], "params": {} }, "U": { "type": "volume.transform", "at": [0,0], "params": {} })",
          R"(, "T.volume -> U.volume", "U.volume -> T.volume", "U.volume -> Render.volumes")")),
      3, {"cycle", "T", "U"});
  expectFails(render(graph(R"("size": [64, 36])", "",
                           R"(, "Odd": { "type": "volume.plasma", "at": [0,0], "params": {} })",
                           R"(, "Odd.volume -> Render.volumes")")),
              3, {"Odd", "volume.plasma"});
  EXPECT_FALSE(fs::exists(out)) << "nothing may be written on error";
  // An unknown type nobody needs is only a warning.
  const auto unused = render(
      graph(R"("size": [64, 36])", "", R"(, "Odd": { "type": "volume.plasma", "at": [0,0], "params": {} })"));
  EXPECT_EQ(unused.exitCode, 0) << unused.err;
  EXPECT_NE(unused.err.find("Odd"), std::string::npos);
}

std::string vdbGraph(const std::string& file) {
  return R"({ "pileus": 1, "settings": { "size": [32, 18] }, "nodes": {
    "Smoke": { "type": "volume.vdb_file", "at": [0, 0], "params": { "file": ")" +
         file + R"(" } },
    "Sun": { "type": "light.sun", "at": [0, 0], "params": {} },
    "Extinction": { "type": "shadow.extinction", "at": [0, 0], "params": { "resolution": 64 } },
    "Render": { "type": "render.volume", "at": [0, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [0, 0], "params": {} } },
  "links": [ "Smoke.volume -> Extinction.volumes", "Sun.light -> Extinction.light", "Smoke.volume -> Render.volumes", "Extinction.light -> Render.lights", "Render.image -> View.image" ] })";
}

TEST(Render, BadVolumes) {
  const fs::path folder = test::scratchFolder();
  write(folder, "words.vdb", "this is not a volume, but a text file that someone renamed\n");
  int n = 0;
  const auto render = [&](const std::string& volume) {
    const std::string name = std::to_string(n++);
    return test::pileus(
        {"render", write(folder, name + ".json", vdbGraph(volume)), "-o", folder / (name + ".exr")});
  };
  expectFails(render("nowhere.vdb"), 3, {"nowhere.vdb", "Smoke"});
  expectFails(render("words.vdb"), 3, {"words.vdb", "Smoke"});
  expectFails(render(""), 3, {"Smoke.file"});
}

TEST(Render, DamagedVolumesOfTheDataFolder) {
  PILEUS_NEEDS_DATA();
  const fs::path folder = test::scratchFolder();
  std::string whole = *readFile(*test::dataFolder() / "vdb" / "smoke1.vdb");
  write(folder, "cut.vdb", whole.substr(0, whole.size() / 2));
  std::vector<fs::path> files{folder / "cut.vdb"};
  for (const auto& entry : fs::directory_iterator(*test::dataFolder() / "vdb_bad"))
    files.push_back(entry.path());
  for (const fs::path& file : files) {
    const std::string name = file.filename().string();
    const bool empty = name.find("empty") != name.npos || name.find("inverted") != name.npos;
    const auto r = test::pileus(
        {"render", write(folder, name + ".json", vdbGraph(file.string())), "-o", folder / (name + ".exr")},
        60);
    EXPECT_EQ(r.exitCode, empty ? 0 : 3) << name << ": " << r.err;
    EXPECT_NE(r.err.find(empty ? "warning" : name), std::string::npos) << name << ": " << r.err;
    if (!empty) continue;
    const auto picture = image::readExr(folder / (name + ".exr"));
    ASSERT_TRUE(picture);
    for (const float v : picture->layers[0].pixels) ASSERT_EQ(v, 0.0f);
  }
}

TEST(Render, GpuMemoryBudget) {
  PILEUS_NEEDS_DATA();
  const fs::path folder = test::scratchFolder(),
                 file =
                     write(folder, "a.json", vdbGraph((*test::dataFolder() / "vdb" / "smoke1.vdb").string()));
  const auto coarse = test::pileus({"render", file, "-o", folder / "a.exr", "--gpu-memory", "3"});
  EXPECT_EQ(coarse.exitCode, 0) << coarse.err;
  EXPECT_NE(coarse.err.find("coarser"), std::string::npos) << coarse.err;
  expectFails(test::pileus({"render", file, "-o", folder / "b.exr", "--gpu-memory", "3", "--set",
                            "Extinction.resolution=4096"}),
              4, {"MiB"});
}

/// Every frame another sky and other suns.
std::string longGraph() {
  return R"({ "pileus": 1, "settings": { "size": [24, 14], "frames": [1, 600] },
  "nodes": {
    "Cloud": { "type": "volume.cloud", "at": [0, 0], "params": { "resolution": 24, "coverage": 0.7,
               "seed": { "keys": [[1, 1, "linear"], [600, 600, "linear"]] } } },
    "Sun": { "type": "light.sun", "at": [0, 0], "params": { "angle": 3, "disc_samples": 4,
             "azimuth": { "keys": [[1, 0, "linear"], [600, 359, "linear"]] } } },
    "Metric": { "type": "shadow.pseudometric", "at": [0, 0], "params": { "resolution": 128 } },
    "Extinction": { "type": "shadow.extinction", "at": [0, 0], "params": {} },
    "Render": { "type": "render.volume", "at": [0, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [0, 0], "params": {} } },
  "links": [ "Cloud.volume -> Metric.volumes", "Sun.light -> Metric.light", "Metric.metric -> Extinction.metric",
             "Cloud.volume -> Render.volumes", "Extinction.light -> Render.lights", "Render.image -> View.image" ] })";
}

/// Resident bytes after each frame.
std::vector<double> residentOf(const fs::path& stats) {
  std::vector<double> out;
  std::ifstream file(stats);
  for (const auto& frame : nlohmann::json::parse(file)["frames"])
    out.push_back(frame["residentBytes"].get<double>());
  return out;
}

TEST(Render, ASequenceNeedsTheMemoryOfOneFrame) {
  const char* many = std::getenv("PILEUS_LONG_FRAMES");
  const int frames = many ? std::max(std::atoi(many), 21) : 120;
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", longGraph());
  const auto r = test::pileus({"render", file, "-o", folder / "a.####.exr", "--frames",
                               fmt::format("1-{}", frames), "--stats", folder / "s.json"},
                              2400);
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const std::vector<double> resident = residentOf(folder / "s.json");
  ASSERT_EQ(resident.size(), std::size_t(frames));
  // The allocator keeps some of what was freed; a frame's maps alone are 5 MiB.
  EXPECT_NEAR(resident.back() / resident[19], 1, 0.05)
      << resident[19] / (1 << 20) << " MiB, then " << resident.back() / (1 << 20);
}

TEST(Render, ABudgetThatHoldsAFrameHoldsASequence) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", longGraph());
  // Found by trial: one frame needs between 18 and 20 MiB in all.
  const auto r =
      test::pileus({"render", file, "-o", folder / "a.####.exr", "--frames", "1-8", "--gpu-memory", "24"});
  EXPECT_EQ(r.exitCode, 0) << r.err;
}

TEST(Render, DegenerateScenesStayFinite) {
  // Degenerate but legal scenes: a huge scale, a sliver, a medium of enormous extinction.
  const fs::path folder = test::scratchFolder();
  for (const char* box : {R"("size": [1000000, 1000000, 1000000])", R"("size": [0.000001, 1, 1])",
                          R"("density": 1000000)", R"("density": 0)", R"("center": [1000000, 0, 0])"}) {
    const fs::path file = write(folder, "a.json", graph(R"("size": [32, 18])", box));
    const auto r = test::pileus({"render", file, "-o", folder / "a.exr", "--overwrite"});
    ASSERT_EQ(r.exitCode, 0) << box << ": " << r.err;
    const auto picture = image::readExr(folder / "a.exr");
    ASSERT_TRUE(picture);
    for (const float v : picture->layers[0].pixels) ASSERT_TRUE(std::isfinite(v)) << box;
  }
}

}  // namespace
}  // namespace pileus
