// `pileus render`: pictures, overrides, sequences, and every kind of bad input with its exit code and
// message.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "editor/cli/render_target.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "renderer/image/png.h"
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

TEST(Render, SetOfALinkedParameterNamesTheLink) {
  const fs::path folder = test::scratchFolder(),
                 file = write(folder, "a.json",
                              graph(R"("size": [16, 9])", "",
                                    R"(, "N": { "type": "value.number", "at": [0, 0],
                                                "params": { "value": 5 } })",
                                    R"(, "N.value -> Sun.irradiance")"));
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr", "--set", "Sun.irradiance=20"}), 2,
              {"Sun.irradiance", "N.value -> Sun.irradiance"});
  EXPECT_EQ(test::pileus({"render", file, "-o", folder / "a.exr", "--set", "N.value=20"}).exitCode, 0);
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
  expectFails(test::pileus({"render", file, "-o", folder / "b.####.exr", "--frames", "1-1000001"}), 2,
              {"1000001 frames", "at most 1000000"});
  expectFails(test::pileus({"render", file, "-o", folder / "b.####.exr", "--frames=-2000000000-2000000000"}),
              2, {"4000000001 frames"});
  EXPECT_TRUE(test::pileus({"render", file, "-o", folder / "b.####.exr", "--frames", "2147483646-2147483647",
                            "--size", "8x8"})
                  .exitCode == 0)
      << "the last frame there can be";
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
  // The second frame's file is missing.
  std::string keyed = vdbGraph("");
  const std::string constant = R"("file": "")";
  keyed.replace(keyed.find(constant), constant.size(),
                R"("file": {"keys": [[1, "gone.0001.vdb", "constant"], [2, "gone.0002.vdb", "constant"]]})");
  expectFails(test::pileus({"render", write(folder, "keyed.json", keyed), "-o", folder / "keyed.#.exr",
                            "--frames", "2-3"}),
              3, {"frame 2: ", "Smoke", "gone.0002.vdb"});
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

TEST(Render, OneFileAtATime) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph());
  expectFails(test::pileus({"render", file, folder / "b.json", "-o", folder / "a.exr"}), 2,
              {"b.json", "one file too many"});
  EXPECT_FALSE(fs::exists(folder / "a.exr"));
}

TEST(Render, AMisspeltCommandIsNamed) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph());
  expectFails(test::pileus({"rendr", file}), 2, {"no command 'rendr'", "did you mean render?"});
  expectFails(test::pileus({"cehck", file}), 2, {"did you mean check?"});
  expectFails(test::pileus({"marmalade"}), 2, {"no command 'marmalade' and no such file"});
}

TEST(Render, AVolumeInPlaceOfAGraph) {
  using namespace std::string_view_literals;
  const fs::path folder = test::scratchFolder();
  const fs::path file = write(folder, "b.vdb", std::string(" BDV\0\0\0\0\xe0\0\0\0"sv));
  expectFails(test::pileus({"render", file, "-o", folder / "a.exr"}), 3,
              {"b.vdb: a volume, not a graph: open it", "make a scene of it with"});
}

TEST(Render, StandardOutputPipesAndLinks) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph(R"("size": [32, 18])"));
  const auto r = test::pileus({"render", file, "-o", "-"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  EXPECT_NE(r.err.find("standard output"), std::string::npos) << "progress is on standard error";
  write(folder, "piped.exr", r.out);
  const auto picture = image::readExr(folder / "piped.exr");
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->size, ivec2(32, 18));
  expectFails(test::pileus({"render", file, "-o", "-", "--frames", "1-2"}), 2,
              {"standard output", "2 frames"});
  expectFails(test::pileus({"render", file, "-o", "-", "--png"}), 2, {"--png"});
  // The program's own standard output by its name: a pipe, which nothing can take the place of.
  const auto pipe = test::pileus({"render", file, "-o", "/proc/self/fd/1"});
  ASSERT_EQ(pipe.exitCode, 0) << pipe.err;
  EXPECT_EQ(pipe.out.substr(0, 4), "\x76\x2f\x31\x01");
  // A link to what is not there yet.
  fs::create_directory(folder / "out");
  fs::create_symlink("out/real.exr", folder / "link.exr");
  ASSERT_EQ(test::pileus({"render", file, "-o", folder / "link.exr"}).exitCode, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link.exr"));
  EXPECT_TRUE(image::readExr(folder / "out" / "real.exr"));
}

TEST(Render, APngIsThePictureOfTheView) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", graph(R"("size": [32, 18])"));
  ASSERT_EQ(test::pileus({"render", file, "-o", folder / "a.png"}).exitCode, 0);
  ASSERT_EQ(test::pileus({"render", file, "-o", folder / "b.exr", "--png"}).exitCode, 0);
  EXPECT_FALSE(fs::exists(folder / "a.exr"));
  const auto picture = image::decodePng(*readFile(folder / "a.png"));
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->size, ivec2(32, 18));
  EXPECT_EQ(*readFile(folder / "a.png"), *readFile(folder / "b.png"));
  for (const char* name : {"a.jpg", "a.tif", "a"})
    expectFails(test::pileus({"render", file, "-o", folder / name}), 2, {name, ".exr"});
  // Frames that are there, whole, are not rendered again.
  const std::vector<std::string> sequence{"render", file, "-o", folder / "s.#.png", "--frames", "1-2"};
  ASSERT_EQ(test::pileus(sequence).exitCode, 0);
  write(folder, "s.2.png", "cut off");
  const auto again = test::pileus(sequence);
  ASSERT_EQ(again.exitCode, 0) << again.err;
  EXPECT_NE(again.err.find("frame 1: "), std::string::npos);
  EXPECT_TRUE(image::decodePng(*readFile(folder / "s.2.png")));
}

TEST(Render, WhatAFileSaysOfItsOwnTargetIsTheFilesFault) {
  const fs::path folder = test::scratchFolder();
  const auto with = [&](const std::string& target) {
    return write(folder, "a.json",
                 graph(R"("size": [16, 9])", "",
                       R"(, "Still": { "type": "output.exr", "at": [0, 0], "params": { "file": ")" + target +
                           R"(" } })",
                       R"(, "Render.image -> Still.image")"));
  };
  expectFails(test::pileus({"render", with("x_%04d#.exr")}), 3, {"Still.file", "'%04d'", "'#'"});
  expectFails(test::pileus({"render", with("x.jpg")}), 3, {"Still.file", "x.jpg"});
}

TEST(FramePattern, TheLastRunOfOneKindIsTheFrame) {
  const auto path = [](const std::string& out) {
    const auto pattern = cli::framePattern(out);
    return pattern ? pattern->path(7) : "error: " + pattern.error().message;
  };
  EXPECT_EQ(path("x.%04d.exr"), "x.0007.exr");
  EXPECT_EQ(path("x.%d.exr"), "x.7.exr");
  EXPECT_EQ(path("x.$F.exr"), "x.7.exr");
  EXPECT_EQ(path("x.$F4.exr"), "x.0007.exr");
  EXPECT_EQ(path("x#.exr"), "x7.exr");
  EXPECT_EQ(path("take#2_####.exr"), "take#2_0007.exr");
  EXPECT_EQ(path("a_####_b_####.exr"), "a_####_b_0007.exr");
  EXPECT_EQ(path("a_%02d_%04d.exr"), "a_%02d_0007.exr");
  EXPECT_EQ(path("100%done_####.exr"), "100%done_0007.exr");
  EXPECT_EQ(path("$Fog_##.exr"), "$Fog_07.exr");
  EXPECT_EQ(path("shot#2/%04d/still.exr"), "shot#2/%04d/still.exr") << "folders have no frame";
  EXPECT_FALSE(cli::framePattern("100%done.exr")->hasFrame());
  EXPECT_EQ(cli::framePattern("x.####.exr")->path(-7), "x.-007.exr");
  for (const char* two : {"x_%04d#.exr", "x_$F_##.exr", "x_$F4_%03d.exr"}) {
    const auto pattern = cli::framePattern(two);
    ASSERT_FALSE(pattern) << two;
    EXPECT_EQ(pattern.error().code, Code::Arguments);
  }
  EXPECT_EQ(path("x_%04d#.exr"),
            "error: x_%04d#.exr: both '#' and '%04d' could be the frame; use one of them");
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
  const auto all = nlohmann::json::parse(file);
  for (const auto& frame : all["frames"]) out.push_back(frame["residentBytes"].get<double>());
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
  if (std::getenv("PILEUS_ROWS"))
    for (const std::size_t frame : {std::size_t(1), std::size_t(20), std::size_t(120), resident.size()})
      if (frame <= resident.size())
        std::printf("resident after frame %zu: %.1f MiB\n", frame, resident[frame - 1] / (1 << 20));
  // The allocator keeps some of what was freed; a frame's maps alone are 5 MiB.
  EXPECT_NEAR(resident.back() / resident[19], 1, 0.05)
      << resident[19] / (1 << 20) << " MiB, then " << resident.back() / (1 << 20);
}

TEST(Render, ABudgetThatHoldsAFrameHoldsASequence) {
  const fs::path folder = test::scratchFolder(), file = write(folder, "a.json", longGraph());
  // The maps of one frame are 4.5 MiB, a third of this is set aside for them.
  const auto r =
      test::pileus({"render", file, "-o", folder / "a.####.exr", "--frames", "1-8", "--gpu-memory", "14"});
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
