// Presets of one's own: round trips, what a name may be, two programs in one folder, a full disk, damage.
#include "nodes/file/preset.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "nodes/file/preset_folder.h"
#include "nodes/graph/graph_edits.h"
#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus::nodes {
namespace {

namespace fs = std::filesystem;

/// A box, lit by a sun.
Graph scene() {
  Graph g = *addNode({}, "volume.box", {0, 0}, "Box");
  g = *addNode(g, "light.sun", {0, 100}, "Sun");
  g = *addNode(g, "render.volume", {300, 0}, "Render");
  g = *connect(g, {"Box", "volume", "Render", "volumes"});
  g = *connect(g, {"Sun", "light", "Render", "lights"});
  return *setParam(g, "Sun", "elevation", 12.5);
}

Preset preset(const std::string& name, PresetKind kind = PresetKind::Document) {
  Preset p;
  if (kind == PresetKind::Document)
    p.graph = scene();
  else if (kind == PresetKind::Nodes)
    p = *presetOf(scene(), {"Box", "Render"}, kind);
  else
    p = *presetOf(scene(), {"Sun"}, kind);
  p.kind = kind;
  p.name = name;
  p.about = "A box in \xc3\xa9vening light";
  p.tags = presetTags("Warm, box,warm");
  return p;
}

std::size_t files(const fs::path& folder) {
  std::error_code ec;
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder, ec), fs::directory_iterator()));
}

TEST(Preset, TextIsTheSameAfterARoundTrip) {
  for (const PresetKind kind : {PresetKind::Document, PresetKind::Nodes, PresetKind::Parameters}) {
    const Preset before = preset("Dusk / low sun", kind);
    const std::string text = presetText(before);
    const auto loaded = presetFromText(text);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(loaded->faults.empty());
    EXPECT_EQ(loaded->preset.name, "Dusk / low sun");
    EXPECT_EQ(loaded->preset.tags, (std::vector<std::string>{"box", "warm"}));
    EXPECT_EQ(presetText(loaded->preset), text);
    EXPECT_TRUE(loaded->preset.graph == before.graph);
    // It is a graph file like any other.
    const auto graph = parseGraph(text);
    ASSERT_TRUE(graph);
    EXPECT_TRUE(graph->faults.empty()) << faultText(graph->faults.front());
  }
  // What a later version says of a preset stays.
  std::string later = presetText(preset("Later"));
  later.insert(later.find("\"kind\""), "\"author\": \"N\",\n    ");
  const auto loaded = presetFromText(later);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_NE(presetText(loaded->preset).find("\"author\": \"N\""), std::string::npos);
}

TEST(Preset, NodesKeepTheirLinksAndParametersNothingElse) {
  EXPECT_EQ(preset("a", PresetKind::Nodes).graph.links.size(), 1u);
  Graph g = setColor(scene(), {"Sun"}, "#445566");
  g = disableNodes(g, {"Sun"}, true);
  const Preset p = *presetOf(g, {"Sun"}, PresetKind::Parameters);
  const Node& sun = *p.graph.nodes.at("Sun");
  EXPECT_TRUE(p.graph.links.empty());
  EXPECT_TRUE(sun.color.empty());
  EXPECT_FALSE(sun.disabled);
  EXPECT_FALSE(presetOf(g, {"Sun", "Box"}, PresetKind::Parameters));
  EXPECT_FALSE(presetOf(g, {}, PresetKind::Nodes));
  EXPECT_FALSE(presetOf(g, {"Nobody"}, PresetKind::Nodes));

  // On another sun: its values, but name, place and links stay.
  Graph other = *addNode({}, "light.sun", {70, 80}, "Key");
  other = *setParam(other, "Key", "azimuth", 99.0);
  const auto set = withPresetParameters(other, "Key", p);
  ASSERT_TRUE(set);
  const Node& key = *set->nodes.at("Key");
  EXPECT_EQ(key.params, sun.params);
  EXPECT_EQ(key.at, dvec2(70, 80));
  EXPECT_FALSE(withPresetParameters(scene(), "Box", p)) << "another type";
  EXPECT_FALSE(withPresetParameters(scene(), "Nobody", p));
}

TEST(Preset, NamesAndWhatIsNoPreset) {
  EXPECT_TRUE(checkPresetName("A/B = C -> D."));
  for (const char* bad : {"", " ", " a", "a ", "a\nb", "\xff"}) EXPECT_FALSE(checkPresetName(bad)) << bad;
  EXPECT_FALSE(checkPresetName(std::string(129, 'x')));
  EXPECT_FALSE(checkPresetAbout(std::string(401, 'x')));
  EXPECT_EQ(presetTagList(presetTags(" B ,,a,  b")), "a, b");
  EXPECT_EQ(presetTags(std::string(100, ',') + "x").size(), 1u);
  for (const char* bad : {"", "{", "[]", R"({"pileus": 1, "nodes": {}, "links": []})",
                          R"({"pileus": 1, "nodes": {}, "preset": 3})",
                          R"({"pileus": 1, "nodes": {}, "preset": {"kind": "x"}})",
                          R"({"pileus": 1, "nodes": {}, "preset": {"kind": "document"}})",
                          R"({"pileus": 1, "nodes": {}, "preset": {"kind": "document", "name": ""}})",
                          R"({"pileus": 1, "nodes": {}, "preset": {"kind": "parameters", "name": "a"}})",
                          R"({"pileus": 1, "nodes": {}, "preset": {"kind": "nodes", "name": "a"}})"}) {
    const auto loaded = presetFromText(bad);
    EXPECT_FALSE(loaded) << bad;
    if (!loaded) {
      EXPECT_EQ(loaded.error().code, Code::Input);
    }
  }
}

TEST(PresetFolder, SaveListRenameReplaceDeleteAndBack) {
  const fs::path folder = test::scratchFolder() / "mine";
  EXPECT_TRUE(presetsIn(folder).empty());
  const auto saved = savePreset(folder, preset("Dusk / low sun"), "PNG1");
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->file.filename(), "dusk-low-sun.json");
  EXPECT_EQ(*readFile(folder / "dusk-low-sun.png"), "PNG1");
  // Another name with the same file name.
  const auto twin = savePreset(folder, preset("Dusk, low sun"), "");
  ASSERT_TRUE(twin);
  EXPECT_EQ(twin->file.filename(), "dusk-low-sun-2.json");
  ASSERT_TRUE(savePreset(folder, preset("\xe5\xa4\x95", PresetKind::Parameters), "")) << "no letter of ASCII";
  EXPECT_FALSE(savePreset(folder, preset("Dusk, low sun"), "")) << "the name is taken";

  std::vector<PresetEntry> all = presetsIn(folder);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "Dusk / low sun");
  EXPECT_EQ(all[0].nodes, 3);
  EXPECT_TRUE(all[0].writable);
  EXPECT_EQ(all[2].type, "light.sun");
  EXPECT_EQ(findPreset(all, "dusk / LOW sun"), &all[0]);
  EXPECT_EQ(findPreset(all, "dusk-low-sun-2"), &all[1]);
  EXPECT_EQ(findPreset(all, "dawn"), nullptr);

  // Replaced, and back.
  const std::string first = *readFile(saved->file);
  Preset changed = preset("Dusk / low sun");
  changed.graph = *setParam(changed.graph, "Sun", "elevation", 3.0);
  const auto replaced = replacePreset(saved->file, changed, "PNG2");
  ASSERT_TRUE(replaced);
  EXPECT_NE(*readFile(saved->file), first);
  EXPECT_EQ(*readFile(folder / "dusk-low-sun.png"), "PNG2");
  ASSERT_TRUE(undoPresetChange(*replaced));
  EXPECT_EQ(*readFile(saved->file), first);
  EXPECT_EQ(*readFile(folder / "dusk-low-sun.png"), "PNG1");

  // Renamed, and back; a name of another one is refused.
  EXPECT_FALSE(describePreset(saved->file, "Dusk, low sun", "", {}));
  const auto renamed = describePreset(saved->file, "Night", "Dark", {"dark"});
  ASSERT_TRUE(renamed) << renamed.error().message;
  EXPECT_EQ(loadPreset(saved->file)->preset.name, "Night");
  EXPECT_TRUE(loadPreset(saved->file)->preset.graph == scene());
  EXPECT_EQ(*readFile(folder / "dusk-low-sun.png"), "PNG1") << "its picture stays";
  ASSERT_TRUE(undoPresetChange(*renamed));
  EXPECT_EQ(*readFile(saved->file), first);

  // Deleted, and back.
  const auto deleted = deletePreset(saved->file);
  ASSERT_TRUE(deleted);
  EXPECT_EQ(deleted->label, "Deleted the preset Dusk / low sun");
  EXPECT_FALSE(fs::exists(saved->file));
  EXPECT_FALSE(fs::exists(folder / "dusk-low-sun.png"));
  ASSERT_TRUE(undoPresetChange(*deleted));
  EXPECT_EQ(*readFile(saved->file), first);
  EXPECT_EQ(*readFile(folder / "dusk-low-sun.png"), "PNG1");
  // A new one is taken back, too.
  ASSERT_TRUE(undoPresetChange(*twin));
  EXPECT_FALSE(fs::exists(twin->file));
}

TEST(PresetFolder, ADamagedPresetIsNamedAndLeftAlone) {
  const fs::path folder = test::scratchFolder();
  ASSERT_TRUE(savePreset(folder, preset("Good"), ""));
  std::ofstream(folder / "broken.json") << "{ \"pileus\": 1, ";
  std::ofstream(folder / "graph.json") << R"({"pileus": 1, "nodes": {}, "links": []})";
  std::ofstream(folder / "begun.json");
  std::ofstream(folder / "notes.txt") << "x";
  fs::create_directories(folder / "folder.json");
  const std::vector<PresetEntry> all = presetsIn(folder);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "Good");
  EXPECT_EQ(all[1].name, "broken");
  EXPECT_NE(all[1].fault.find("broken.json"), std::string::npos);
  EXPECT_NE(all[1].fault.find("line 1"), std::string::npos) << all[1].fault;
  EXPECT_NE(all[2].fault.find("not a preset"), std::string::npos);
  EXPECT_EQ(findPreset(all, "broken"), nullptr);
  // Its name is free, its file is not.
  const auto saved = savePreset(folder, preset("broken"), "");
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->file.filename(), "broken-2.json");
  EXPECT_EQ(*readFile(folder / "broken.json"), "{ \"pileus\": 1, ");
  EXPECT_FALSE(describePreset(folder / "broken.json", "x", "", {}));
  // It may be deleted, and comes back as it was.
  const auto deleted = deletePreset(folder / "broken.json");
  ASSERT_TRUE(deleted);
  ASSERT_TRUE(undoPresetChange(*deleted));
  EXPECT_EQ(*readFile(folder / "broken.json"), "{ \"pileus\": 1, ");
}

TEST(PresetFolder, TwoProgramsLoseNothing) {
  const fs::path folder = test::scratchFolder();
  // Both save names that want the same files at the same time.
  const auto many = [&](int program) {
    for (int i = 0; i < 20; ++i)
      EXPECT_TRUE(savePreset(folder, preset(fmt::format("{} {}", program == 0 ? "Dusk!" : "Dusk?", i)), ""));
  };
  std::thread other(many, 1);
  many(0);
  other.join();
  EXPECT_EQ(presetsIn(folder).size(), 40u);

  // One replaces what the other has just replaced: each is kept, and neither undoes the other's work.
  const auto base = savePreset(folder, preset("Base"), "");
  ASSERT_TRUE(base);
  Preset one = preset("Base"), two = preset("Base");
  one.about = "one", two.about = "two";
  const auto a = replacePreset(base->file, one, ""), b = replacePreset(base->file, two, "");
  ASSERT_TRUE(a && b);
  EXPECT_FALSE(undoPresetChange(*a)) << "the other has written it since";
  EXPECT_EQ(loadPreset(base->file)->preset.about, "two");
  ASSERT_TRUE(undoPresetChange(*b));
  EXPECT_EQ(loadPreset(base->file)->preset.about, "one");
  const auto deleted = deletePreset(base->file);
  ASSERT_TRUE(deleted);
  std::ofstream(base->file) << presetText(two);
  EXPECT_FALSE(undoPresetChange(*deleted)) << "something else is there now";
  EXPECT_EQ(loadPreset(deleted->before)->preset.about, "one") << "and it is kept";
}

/// In a process that may write no byte, as on a full disk.
TEST(PresetFolder, AFullDiskChangesNothing) {
  const fs::path folder = test::scratchFolder();
  const auto saved = savePreset(folder, preset("Kept"), "PNG1");
  ASSERT_TRUE(saved);
  const std::string before = *readFile(saved->file);
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit none{8, 8};
    ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &none);
    Preset changed = preset("Kept");
    changed.about = "other";
    const bool refused = !savePreset(folder, preset("New"), "PNG2 and more") &&
                         !replacePreset(saved->file, changed, "PNG2 and more") &&
                         !describePreset(saved->file, "Other", "", {});
    ::_exit(refused ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(*readFile(saved->file), before);
  EXPECT_EQ(*readFile(folder / "kept.png"), "PNG1");
  EXPECT_EQ(presetsIn(folder).size(), 1u);
  EXPECT_EQ(files(folder), 3u) << "the preset, its picture and the folder of deleted ones";
  EXPECT_EQ(files(folder / ".deleted"), 0u);
}

TEST(PresetFolder, FilesAreFoundFromWhereverItIsOpened) {
  const fs::path base = test::scratchFolder(), folder = base / "library", shot = base / "shot";
  Preset p = preset("Smoke");
  p.graph = *addNode(p.graph, "volume.vdb_file", {0, 0}, "File");
  p.graph = *setParam(p.graph, "File", "file", std::string("data/smoke.vdb"));
  const auto saved = savePreset(folder, p, "", shot);
  ASSERT_TRUE(saved);
  EXPECT_NE(readFile(saved->file)->find("../shot/data/smoke.vdb"), std::string::npos);
  const auto path = [&](const fs::path& from) {
    return std::get<std::string>(
        loadPreset(saved->file, from)->preset.graph.nodes.at("File")->params.at("file"));
  };
  EXPECT_EQ(path(shot), "data/smoke.vdb");
  EXPECT_EQ(path({}), (shot / "data/smoke.vdb").lexically_normal().string());
}

TEST(PresetFolder, AThousandAreRead) {
  const fs::path folder = test::scratchFolder();
  const std::string text = presetText(preset("x"));
  for (int i = 0; i < 1000; ++i) {
    std::string one = text;
    one.replace(one.find("\"name\": \"x\""), 11, fmt::format("\"name\": \"{}\"", i));
    std::ofstream(folder / fmt::format("{}.json", i)) << one;
  }
  EXPECT_EQ(presetsIn(folder).size(), 1000u);
}

}  // namespace
}  // namespace pileus::nodes
