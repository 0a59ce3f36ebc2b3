// `pileus presets` and `pileus render NAME` with presets of one's own.
#include <fstream>
#include <nlohmann/json.hpp>

#include "nodes/file/preset_folder.h"
#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char kGraph[] = R"({"pileus": 1, "settings": {"size": [48, 27]}, "nodes": {
  "Ball": {"type": "volume.sphere", "at": [0, 0], "params": {"density": 3}},
  "Sun": {"type": "light.sun", "at": [0, 130], "params": {}},
  "Render": {"type": "render.volume", "at": [300, 0], "params": {"samples": 1, "scattering": "single"}},
  "View": {"type": "output.view", "at": [560, 0], "params": {}}},
  "links": ["Ball.volume -> Render.volumes", "Sun.light -> Render.lights", "Render.image -> View.image"]})";

nodes::Preset preset(const std::string& name, nodes::PresetKind kind) {
  const nodes::Graph graph = nodes::parseGraph(kGraph)->graph;
  nodes::Preset p;
  if (kind == nodes::PresetKind::Document)
    p.graph = graph;
  else
    p = *nodes::presetOf(graph, {"Sun"}, kind);
  p.kind = kind;
  p.name = name;
  p.about = "One ball";
  p.tags = {"ball"};
  return p;
}

/// A home with two scenes, a node and a damaged file in the user's folder, and another scene in a show's.
struct Home {
  fs::path folder = scratchFolder(), own = folder / "config" / "pileus" / "presets", show = folder / "show";
  std::vector<std::string> environment{"XDG_CONFIG_HOME=" + (folder / "config").string()};
  Home() {
    EXPECT_TRUE(nodes::savePreset(own, preset("Ball / low sun", nodes::PresetKind::Document), ""));
    EXPECT_TRUE(nodes::savePreset(own, preset("Key", nodes::PresetKind::Parameters), ""));
    EXPECT_TRUE(nodes::savePreset(show, preset("From the show", nodes::PresetKind::Document), ""));
    std::ofstream(own / "broken.json") << "{";
    std::ofstream(own.parent_path() / "settings.json") << json{{"presetFolders", {show.string()}}};
  }
};

TEST(OwnPresets, AreListed) {
  const Home home;
  const RunResult text = run({PILEUS_BINARY, "presets"}, 60, home.environment);
  EXPECT_EQ(text.exitCode, 0);
  for (const char* part : {"Broken cumulus", "shipped: default.json", "Ball / low sun", "One ball [ball]",
                           "light.sun", "From the show"})
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
  EXPECT_NE(text.err.find("broken.json"), std::string::npos) << text.err;

  const RunResult r = pileus({"presets", "--json"}, 60, home.environment);
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const json all = json::parse(r.out);
  const auto named = [&](const std::string& name) -> json {
    for (const json& p : all)
      if (p["name"] == name) return p;
    return {};
  };
  EXPECT_EQ(named("Broken cumulus")["shipped"], "default.json");
  EXPECT_EQ(named("Ball / low sun")["file"], (home.own / "ball-low-sun.json").string());
  EXPECT_EQ(named("Ball / low sun")["tags"], json({"ball"}));
  EXPECT_EQ(named("Key")["kind"], "parameters");
  EXPECT_TRUE(named("broken").contains("fault"));
}

TEST(OwnPresets, AreRenderedByName) {
  const Home home;
  const fs::path file = home.folder / "scene.json", a = home.folder / "a.exr", b = home.folder / "b.exr";
  std::ofstream(file) << kGraph;
  ASSERT_EQ(pileus({"render", file.string(), "-o", a.string()}, 120, home.environment).exitCode, 0);
  for (const char* name : {"Ball / low sun", "ball-low-sun", "BALL / LOW SUN", "From the show"}) {
    const RunResult r = pileus({"render", name, "-o", b.string(), "--overwrite"}, 120, home.environment);
    ASSERT_EQ(r.exitCode, 0) << name << r.err;
    EXPECT_EQ(pileus({"compare", a.string(), b.string(), "--max-relmse", "0"}).exitCode, 0) << name;
  }
  // One that is part of the program.
  const RunResult shipped = pileus({"render", "cumulus", "-o", b.string(), "--overwrite", "--size", "32x18"},
                                   240, home.environment);
  EXPECT_EQ(shipped.exitCode, 0) << shipped.err;

  const auto refused = [&](const std::string& name, const char* why) {
    const RunResult r =
        run({PILEUS_BINARY, "render", name, "-o", b.string(), "--overwrite"}, 60, home.environment);
    EXPECT_EQ(r.exitCode, 3) << name;
    EXPECT_NE(r.err.find(why), std::string::npos) << r.err;
  };
  refused("Key", "holds parameters");
  refused("Nowhere", "neither a file nor a preset");
  refused("broken", "broken.json");
  refused("nowhere.json", "nowhere.json");
}

}  // namespace
}  // namespace pileus::test
