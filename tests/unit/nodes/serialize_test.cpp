// Graph files: round trips, everything that can be wrong with one, and hostile ones.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "nodes/file/migrations.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/graph_animation.h"
#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus::nodes {
namespace {

std::string fixture(const std::string& name = "format4.json") {
  return readFile(std::string(PILEUS_SOURCE_DIR) + "/tests/unit/nodes/fixtures/" + name).value();
}

/// All faults, one a line.
std::string faultsOf(std::string_view text) {
  const auto loaded = parseGraph(text);
  if (!loaded) return "refused: " + loaded.error().message + "\n";
  std::string all;
  for (const Fault& fault : loaded->faults) all += faultText(fault) + "\n";
  return all;
}

std::string withNodes(const std::string& nodes, const std::string& links = "") {
  return R"({"pileus": 1, "nodes": {)" + nodes + R"(}, "links": [)" + links + "]}";
}
std::string sunWith(const std::string& params) {
  return withNodes(R"("Sun": {"type": "light.sun", "params": {)" + params + "}}");
}

/// What all fixtures warn of.
constexpr const char* kFixtureFaults =
    "warning: settings.theme: unknown setting; kept as it is\n"
    "warning: Box.future: unknown member; kept as it is\n"
    "warning: Box.density: expressions are not evaluated yet: kept, but the default is used\n"
    "warning: Box.fluffiness: volume.box has no such parameter; kept as it is\n"
    "warning: Strange: unknown node type 'volume.from_the_future'; kept as it is\n"
    "warning: someday: unknown member; kept as it is\n";

void expectFixture(const Graph& graph) {
  EXPECT_EQ(graph.settings.size, ivec2(640, 360));
  EXPECT_TRUE(findNode(graph, "Haze")->bypass);
  EXPECT_EQ(findNode(graph, "Ball")->animated.at("radius").keys.size(), 2u);
  EXPECT_TRUE(graph.links.back().muted);
}

TEST(Serialize, FormatFourIsReadAndSavedByteForByte) {
  const auto loaded = parseGraph(fixture());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(graphText(loaded->graph), fixture());
  EXPECT_EQ(faultsOf(fixture()), kFixtureFaults);
  expectFixture(loaded->graph);
  EXPECT_EQ(loaded->graph.links.size(), 6u);
}

TEST(Serialize, FormatThreeIsReadAndSavedAsFormatFour) {
  const std::string text = fixture("format3.json");
  const auto loaded = parseGraph(text);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(faultsOf(text), kFixtureFaults);
  expectFixture(loaded->graph);
  EXPECT_EQ(graphText(loaded->graph), fixture()) << "its cloud is a classic one";
}

TEST(Serialize, FormatTwoIsReadAndSavedAsFormatFour) {
  std::string text = fixture("format2.json");
  const auto loaded = parseGraph(text);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(faultsOf(text), kFixtureFaults);
  expectFixture(loaded->graph);
  // Of one node a default changed, and nothing else is new.
  text.replace(text.find("\"pileus\": 2"), 11, "\"pileus\": 4");
  const std::string samples = "\"samples\": 4";
  text.replace(text.find(samples), samples.size(), samples + ",\n        \"scattering\": \"single\"");
  EXPECT_EQ(graphText(loaded->graph), text);
}

TEST(Serialize, FormatOneIsReadAndSavedAsFormatFour) {
  std::string text = fixture("format1.json");
  const auto loaded = parseGraph(text);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(faultsOf(text), kFixtureFaults);
  expectFixture(loaded->graph);
  EXPECT_EQ(loaded->graph.links.size(), 4u);
  // Of one node a default changed, and nothing else is new.
  text.replace(text.find("\"pileus\": 1"), 11, "\"pileus\": 4");
  const std::string file = "\"file\": \"../smoke/a.vdb\"";
  text.replace(text.find(file), file.size(), file + ",\n        \"level_set\": \"ignore\"");
  EXPECT_EQ(graphText(loaded->graph), text);
}

TEST(Serialize, ShippedPresetsAreAsPileusSavesThem) {
  int presets = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(PILEUS_SOURCE_DIR) / "presets")) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = readFile(entry.path()).value();
    const auto loaded = parseGraph(text);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(graphText(loaded->graph), text) << entry.path();
    ++presets;
  }
  EXPECT_GE(presets, 8);
}

TEST(Serialize, ANewGraphRoundTrips) {
  Graph graph = addNode({}, "light.sun", {40, 80}, "Sun").value();
  graph = setParam(graph, "Sun", "elevation", 25).value();
  graph = setParam(graph, "Sun", "color", dvec3(0.1, 1.0 / 3.0, 1)).value();
  const std::string text = graphText(graph);
  EXPECT_NE(text.find("\"at\": [40, 80]"), std::string::npos) << text;
  EXPECT_NE(text.find("\"elevation\": 25\n"), std::string::npos) << text;
  EXPECT_NE(text.find("[0.1, 0.3333333333333333, 1]"), std::string::npos) << text;
  EXPECT_EQ(text.find("irradiance"), std::string::npos) << "defaults are not written";
  EXPECT_TRUE(parseGraph(text)->graph == graph);
}

TEST(Serialize, FaultsNameNodeAndKey) {
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": 120)")), "error: Sun.elevation: 120 is outside -90..90\n");
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": "high")")), "error: Sun.elevation: 'high' is not a number\n");
  EXPECT_EQ(faultsOf(sunWith(R"("color": [1, 2])")),
            "error: Sun.color: [1,2] is not a value this parameter takes\n");
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": null)")),
            "error: Sun.elevation: null is not a value this parameter takes\n");
  EXPECT_EQ(faultsOf(sunWith(R"("use_temperature": 1)")),
            "error: Sun.use_temperature: 1 is not true or false\n");
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": 1, "elevation": 2)")), "error: Sun.elevation: is given twice\n");
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": {"keys": []})")),
            "error: Sun.elevation: an animation is {\"keys\": [[frame, value, \"smooth\"], ...]}\n");
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": {"keys": [[1, 2, "bouncy"]]})")),
            "error: Sun.elevation: key 1: 'bouncy' is not one of constant, linear, smooth\n");
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": {"keys": [[1, 2, "smooth"], [1, 3, "smooth"]]})")),
            "error: Sun.elevation: key 2: frames must increase\n");
  EXPECT_EQ(faultsOf(sunWith(R"("elevation": {"keys": [[1, 200, "smooth"]]})")),
            "error: Sun.elevation: key 1: 200 is outside -90..90\n");
  EXPECT_EQ(faultsOf(withNodes(R"("Sun": {"type": "light.sun"}, "Sun": {"type": "light.sun"})")),
            "error: Sun: is given twice\n");
  EXPECT_EQ(faultsOf(withNodes(R"("Sun": {"type": "light.sun", "at": [1]})")),
            "error: Sun.at: [1] is not two numbers\n");
  EXPECT_EQ(faultsOf(withNodes(R"("Sun": {"at": [1, 2]})")), "error: Sun.type: is missing or not a text\n");
  EXPECT_EQ(faultsOf(withNodes(R"("Sun": 5)")), "error: Sun: is not an object\n");
  EXPECT_EQ(faultsOf(withNodes(R"("a.b": {"type": "light.sun"})")),
            "error: nodes.a.b: 'a.b': a node name may not hold '.'\n");
  EXPECT_EQ(faultsOf(withNodes(R"("X": {"type": "no.such"})")),
            "warning: X: unknown node type 'no.such'; kept as it is\n");
}

TEST(Serialize, LinkFaultsNameTheLink) {
  const std::string nodes =
      R"("A": {"type": "volume.transform"}, "B": {"type": "volume.transform"}, "Box": {"type": "volume.box"},
                               "Sun": {"type": "light.sun"})";
  const auto faults = [&](const std::string& links) { return faultsOf(withNodes(nodes, links)); };
  EXPECT_EQ(faults(R"("Box.volume -> A.volume", "A.volume -> B.volume")"), "");
  EXPECT_EQ(faults(R"("Box.volume - A.volume")"),
            "error: links[0]: \"Box.volume - A.volume\" is not \"Node.output -> Node.input\"\n");
  EXPECT_EQ(faults("7"), "error: links[0]: 7 is not \"Node.output -> Node.input\"\n");
  EXPECT_EQ(faults(R"("Nobody.volume -> A.volume")"),
            "error: links[0]: \"Nobody.volume -> A.volume\": there is no node 'Nobody'\n");
  EXPECT_EQ(faults(R"("Box.smoke -> A.volume")"),
            "error: Box.smoke: there is no such output, in link Box.smoke -> A.volume\n");
  EXPECT_EQ(faults(R"("Box.volume -> A.smoke")"),
            "error: A.smoke: there is no such input, in link Box.volume -> A.smoke\n");
  EXPECT_EQ(faults(R"("Sun.light -> A.volume")"),
            "error: A.volume: takes volume, but Sun.light gives light\n");
  EXPECT_EQ(faults(R"("Box.volume -> A.volume", "Box.volume -> A.volume")"),
            "error: links[1]: \"Box.volume -> A.volume\" is listed twice\n");
  EXPECT_EQ(faults(R"("Box.volume -> A.volume", "B.volume -> A.volume")"),
            "error: A.volume: takes one link, but has Box.volume -> A.volume and B.volume -> A.volume\n");
  EXPECT_EQ(faults(R"("A.volume -> B.volume", "B.volume -> A.volume")"),
            "error: links: cycle: A -> B -> A\n");
}

TEST(Serialize, SettingsAreChecked) {
  const auto faults = [](const std::string& settings) {
    return faultsOf(R"({"pileus": 1, "nodes": {}, "settings": {)" + settings + "}}");
  };
  EXPECT_EQ(faults(R"("size": [0, 0])"), "error: settings.size: 0x0 is outside 1x1..32768x32768\n");
  EXPECT_EQ(faults(R"("size": [1000000, 1000000])"),
            "error: settings.size: 1000000x1000000 is outside 1x1..32768x32768\n");
  EXPECT_EQ(faults(R"("size": [1e3, 99999999999])"),
            "error: settings.size: [1000.0,99999999999] is not two whole numbers\n");
  EXPECT_EQ(faults(R"("frames": [5, 1])"), "error: settings.frames: the first frame comes after the last\n");
  EXPECT_EQ(faults(R"("fps": 0)"), "error: settings.fps: 0 is not a number above 0 and up to 1000\n");
  EXPECT_EQ(faults(R"("ocio": 3)"), "error: settings.ocio: 3 is not a text\n");
}

TEST(Serialize, WhatIsNoGraphIsRefusedWithLineAndColumn) {
  EXPECT_EQ(faultsOf(""),
            "refused: line 1, column 1: not JSON: syntax error while parsing value - unexpected end of "
            "input; expected '[', '{', or a literal\n");
  EXPECT_TRUE(
      faultsOf("{\n  \"pileus\": 1,\n  \"nodes\": x\n}").starts_with("refused: line 3, column 12: not JSON"))
      << faultsOf("{\n  \"pileus\": 1,\n  \"nodes\": x\n}");
  EXPECT_TRUE(faultsOf("{\"pileus\": 1} x").starts_with("refused: line 1, column 15: not JSON"));
  EXPECT_NE(faultsOf(R"({"pileus": 1, "nodes": {"S": {"type": "light.sun", "params": {"angle": 1e999}}}})")
                .find("refused: "),
            std::string::npos);
  EXPECT_TRUE(faultsOf("[]").starts_with("refused: not a Pileus graph"));
  EXPECT_TRUE(faultsOf("{}").starts_with("refused: not a Pileus graph: \"pileus\""));
  EXPECT_TRUE(faultsOf(R"({"pileus": "1"})").starts_with("refused: not a Pileus graph"));
  EXPECT_TRUE(faultsOf(R"({"pileus": 0})").starts_with("refused: not a Pileus graph"));
  EXPECT_TRUE(faultsOf(R"({"pileus": 5})").starts_with("refused: written by a newer Pileus: format 5"));
  EXPECT_TRUE(faultsOf(R"({"pileus": 99999999999999999999})").starts_with("refused: "));
  EXPECT_EQ(faultsOf(std::string(100000, '[')), "refused: line 1, column 65: nested deeper than 64\n");
  std::string nested = R"({"pileus": 1, "x": )" + std::string(63, '[') + std::string(63, ']') + "}";
  EXPECT_TRUE(parseGraph(nested));
  EXPECT_TRUE(faultsOf("{\"pileus\": 1, \"x\": \"\xff\"}").starts_with("refused: line 1")) << "not UTF-8";
}

TEST(Serialize, FaultyValuesStayUntilTheyAreSet) {
  const std::string text = sunWith(R"("elevation": 120, "azimuth": "north", "irradiance": {"keys": 3})");
  Graph graph = parseGraph(text)->graph;
  const std::string saved = graphText(graph);
  EXPECT_EQ(graphText(parseGraph(saved)->graph), saved);
  for (const auto part : {"\"elevation\": 120", "\"azimuth\": \"north\"", "\"keys\": 3"})
    EXPECT_NE(saved.find(part), std::string::npos) << part;
  for (const auto param : {"elevation", "azimuth", "irradiance"})
    graph = setParam(graph, "Sun", param, 10.0).value();
  EXPECT_EQ(faultsOf(graphText(graph)), "");
}

TEST(Serialize, MigrationsRunInOrderFromTheFilesFormat) {
  const Migration steps[] = {
      {1, [](nlohmann::json& file) { file["trace"] = file.value("trace", "") + "1"; }},
      {2, [](nlohmann::json& file) { file["trace"] = file.value("trace", "") + "2"; }}};
  nlohmann::json old = {{"pileus", 1}}, newer = {{"pileus", 2}};
  migrate(old, 1, steps);
  migrate(newer, 2, steps);
  EXPECT_EQ(old, (nlohmann::json{{"pileus", 3}, {"trace", "12"}}));
  EXPECT_EQ(newer, (nlohmann::json{{"pileus", 3}, {"trace", "2"}}));
  EXPECT_EQ(migrations().size(), std::size_t(kFormatVersion - 1)) << "one step per old format";
}

TEST(Files, StorePathsRelativeToThemselves) {
  const auto root = test::scratchFolder();
  std::filesystem::create_directories(root / "graphs");
  std::filesystem::create_directories(root / "other");
  const auto stored = [&](const std::string& typed, const std::filesystem::path& folder = {}) {
    Graph graph = addNode({}, "volume.vdb_file", {0, 0}, "V").value();
    graph = setParam(graph, "V", "file", typed).value();
    const auto saved = saveGraph(root / "graphs" / "g.json", graph, folder);
    EXPECT_TRUE(saved);
    EXPECT_EQ(std::get<std::string>(findNode(graph, "V")->params.at("file")), typed) << "in memory as typed";
    const auto loaded = loadGraph(root / "graphs" / "g.json");
    EXPECT_TRUE(loaded && loaded->faults.empty());
    EXPECT_EQ(readFile(root / "graphs" / "g.json").value(), graphText(loaded->graph))
        << "re-saved byte for byte";
    return std::get<std::string>(findNode(loaded->graph, "V")->params.at("file"));
  };
  EXPECT_EQ(stored((root / "data" / "a.vdb").string()), "../data/a.vdb");
  EXPECT_EQ(stored((root / "graphs" / "a.vdb").string()), "a.vdb");
  EXPECT_EQ(stored("a.vdb"), "a.vdb");
  EXPECT_EQ(stored("a.vdb", root / "other"), "../other/a.vdb") << "saved elsewhere";
  EXPECT_EQ(stored("/nowhere/a.vdb"), "/nowhere/a.vdb");
}

TEST(Files, SayWhatIsWrongWithTheirPath) {
  const auto root = test::scratchFolder();
  EXPECT_TRUE(loadGraph(root / "none.json").error().message.starts_with((root / "none.json").string()));
  std::ofstream(root / "bad.json") << "{";
  const auto bad = loadGraph(root / "bad.json");
  ASSERT_FALSE(bad);
  EXPECT_TRUE(bad.error().message.starts_with((root / "bad.json").string() + ": line 1, column 2"))
      << bad.error().message;
  EXPECT_EQ(bad.error().code, Code::Input);
  EXPECT_FALSE(saveGraph(root / "no" / "folder" / "g.json", {}));
}

TEST(Clipboard, PastesWithFreeNamesAndInnerLinks) {
  const Graph graph = parseGraph(fixture())->graph;
  const std::string text = copyText(graph, {"Box", "Haze", "Nobody"});
  std::set<std::string> pasted;
  const Graph result = pasteText(graph, text, {1000, 500}, &pasted).value();
  EXPECT_EQ(pasted, (std::set<std::string>{"Box 2", "Haze 2"}));
  EXPECT_EQ(result.links.size(), graph.links.size() + 1);
  EXPECT_EQ(result.links.back(), (Link{"Box 2", "volume", "Haze 2", "volume"}));
  EXPECT_EQ(findNode(result, "Box 2")->at, dvec2(900, 500));
  EXPECT_EQ(findNode(result, "Box 2")->params, findNode(graph, "Box")->params);
  EXPECT_EQ(findNode(result, "Box 2")->unknown, findNode(graph, "Box")->unknown);
  EXPECT_FALSE(pasteText(graph, "hello", {0, 0}));
  EXPECT_FALSE(pasteText(graph, copyText(graph, {}), {0, 0}));
}

Graph withFile(const std::string& file) {
  Graph graph = addNode({}, "volume.vdb_file", {0, 0}, "Smoke").value();
  return setParam(graph, "Smoke", "file", file).value();
}

std::string fileOf(const Graph& graph, const std::string& node = "Smoke") {
  return std::get<std::string>(findNode(graph, node)->params.at("file"));
}

TEST(Clipboard, FilesAreFoundFromAnotherFolder) {
  const std::string text = copyText(withFile("../vdb/smoke.vdb"), {"Smoke"}, "/shows/a/scenes");
  EXPECT_EQ(fileOf(pasteText({}, text, {0, 0}).value()), "/shows/a/vdb/smoke.vdb");
  EXPECT_EQ(fileOf(pasteText({}, copyText(withFile("smoke.vdb"), {"Smoke"}), {0, 0}).value()), "smoke.vdb")
      << "a document that lies nowhere";
}

TEST(Clipboard, FilesOfKeysAreFoundAsWell) {
  Graph graph = withFile("a.vdb");
  graph = setKey(graph, "Smoke", "file", 1, std::string("vdb/a.vdb")).value();
  graph = setKey(graph, "Smoke", "file", 2, std::string("/caches/b.vdb")).value();
  const Graph moved = withRelativePaths(graph, "/shows/a", "/shows/b");
  const auto values = heldValues(*findNode(moved, "Smoke"), "file");
  ASSERT_EQ(values.size(), 2u);
  EXPECT_EQ(std::get<std::string>(values[0].value), "../a/vdb/a.vdb");
  EXPECT_EQ(std::get<std::string>(values[1].value), "/caches/b.vdb") << "nothing in common";
  EXPECT_EQ(values[1].frame, 2);
}

TEST(Files, AMergedGraphFindsItsFiles) {
  const auto root = test::scratchFolder();
  std::filesystem::create_directories(root / "other" / "scenes");
  std::filesystem::create_directories(root / "mine");
  const auto file = root / "other" / "scenes" / "a.json";
  ASSERT_TRUE(saveGraph(file, withFile("../vdb/smoke.vdb")));
  std::set<std::string> pasted;
  const auto merged = mergeGraph(withFile("x.vdb"), file, root / "mine", {0, 0}, &pasted);
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_EQ(pasted, std::set<std::string>{"Smoke 2"});
  EXPECT_EQ(fileOf(*merged, "Smoke 2"), "../other/vdb/smoke.vdb");
  EXPECT_EQ(fileOf(*merged), "x.vdb");
  EXPECT_EQ(fileOf(mergeGraph({}, file, {}, {0, 0}).value()), (root / "other/vdb/smoke.vdb").string());
  const auto nothing = mergeGraph({}, root / "none.json", {}, {0, 0});
  ASSERT_FALSE(nothing);
  EXPECT_NE(nothing.error().message.find("none.json"), std::string::npos);
}

TEST(Files, TheColourConfigurationMovesWithTheGraph) {
  Graph graph;
  graph.settings.ocio = "color/show.ocio";
  EXPECT_EQ(withRelativePaths(graph, "/shows/a", "/shows/b").settings.ocio, "../a/color/show.ocio");
  EXPECT_EQ(withRelativePaths(graph, "/shows/a", "/shows/a").settings.ocio, "color/show.ocio");
  graph.settings.ocio = "ocio://default";
  EXPECT_EQ(withRelativePaths(graph, "/shows/a", "/shows/b").settings.ocio, "ocio://default");
}

TEST(Files, AVolumeOrAPictureIsNamed) {
  const auto root = test::scratchFolder();
  using namespace std::string_view_literals;
  std::ofstream(root / "a.vdb", std::ios::binary) << " BDV\0\0\0\0\xe0"sv;
  std::ofstream(root / "a.exr", std::ios::binary) << "\x76\x2f\x31\x01\x02\0\0\0"sv;
  const auto volume = loadGraph(root / "a.vdb"), picture = loadGraph(root / "a.exr");
  ASSERT_FALSE(volume || picture);
  EXPECT_NE(volume.error().message.find("a.vdb: a volume, not a graph: open it"), std::string::npos)
      << volume.error().message;
  EXPECT_NE(picture.error().message.find("a.exr: an OpenEXR picture, not a graph"), std::string::npos);
}

/// What a file says wrongly is either in the text that is saved, or the fault says that it would be lost.
TEST(Faults, SayWhatASaveWouldDelete) {
  const auto losing = [](const std::string& text) {
    const auto loaded = parseGraph(text);
    EXPECT_TRUE(loaded) << text;
    std::string lost;
    for (const Fault& f : loaded->faults)
      if (f.lost) lost += f.where + " ";
    EXPECT_EQ(loaded->loses(), !lost.empty());
    // A saved graph has nothing more to lose.
    EXPECT_FALSE(parseGraph(graphText(loaded->graph))->loses());
    return lost;
  };
  EXPECT_EQ(losing(fixture()), "");
  EXPECT_EQ(losing(withNodes(R"("a.b": {"type": "light.sun"}, "B": {"at": [0, 0]}, "C": 3)")),
            "B.type C nodes.a.b ");
  EXPECT_EQ(losing(withNodes(R"("Sun": {"type": "light.sun", "at": "left", "bypass": 1, "label": 2})")),
            "Sun.at Sun.bypass Sun.label ");
  EXPECT_EQ(losing(withNodes("", R"("A.b -> C.d", 7)")), "links[0] links[0] links[1] ");
  EXPECT_EQ(losing(R"({"pileus": 1, "nodes": {}, "settings": {"size": 5, "fps": -1, "frames": [2, 1]}})"),
            "settings.fps settings.frames settings.size ");
  EXPECT_EQ(losing(withNodes(R"("Sun": {"type": "light.sun", "type": "light.point"})")), "Sun.type ");
  // Kept as it stands.
  for (const char* params : {R"("elevation": "high")", R"("elevation": 1e6)", R"("warmth": 3)",
                             R"("elevation": {"keys": [[1, 2], [1, 3]]})"})
    EXPECT_EQ(losing(sunWith(params)), "") << params;
}

TEST(Files, ACopyIsKeptOfWhatWouldBeLost) {
  const auto file = test::scratchFolder() / "a.json";
  const auto write = [&](const std::string& text) { std::ofstream(file) << text; };
  write("one");
  EXPECT_EQ(backUp(file).value(), file.string() + ".bak");
  EXPECT_EQ(backUp(file).value(), file.string() + ".bak") << "it is there";
  write("two");
  EXPECT_EQ(backUp(file).value(), file.string() + ".bak2");
  EXPECT_EQ(readFile(file.string() + ".bak").value(), "one");
  EXPECT_EQ(readFile(file.string() + ".bak2").value(), "two");
  EXPECT_FALSE(backUp(file.string() + "-none"));
}

TEST(Files, SavingOverWhatCouldNotBeReadKeepsIt) {
  const auto file = test::scratchFolder() / "a.json";
  const std::string text = withNodes(R"("a.b": {"type": "light.sun"})");
  std::ofstream(file) << text;
  const Graph graph = loadGraph(file)->graph;
  std::filesystem::path kept;
  ASSERT_TRUE(saveGraph(file, graph, {}, &kept));
  EXPECT_EQ(kept, file.string() + ".bak");
  EXPECT_EQ(readFile(kept).value(), text);
  kept.clear();
  ASSERT_TRUE(saveGraph(file, graph, {}, &kept));
  EXPECT_TRUE(kept.empty()) << "nothing is lost any more";
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".bak2"));
}

/// Cuts, copies, swaps and changes bytes; often where JSON is sensitive.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> kParts = {
      "\"",    "{",    "}",      "[",       "]",    ",", ":",        "null",      "-1",
      "1e308", "true", "1e-400", "\\u0000", " -> ", ".", "\"keys\"", "light.sun", "99999999999999999999"};
  for (std::size_t n = 1 + random() % 4; n > 0; --n) {
    const std::size_t at = random() % (text.size() + 1), length = random() % 40;
    switch (random() % 5) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(random() % (text.size() + 1), length));
        break;
      case 2:
        text.insert(at, kParts[random() % kParts.size()]);
        break;
      case 3:
        if (at < text.size()) text[at] = static_cast<char>(random() % 256);
        break;
      default: {
        const std::size_t number = text.find_first_of("0123456789", at);
        if (number != std::string::npos) text.replace(number, 1, kParts[random() % kParts.size()]);
      }
    }
  }
  return text;
}

TEST(Fuzz, MutatedFilesNeverCrashAndWhatLoadsIsStable) {
  const char* more = std::getenv("PILEUS_FUZZ_RUNS");  // the long version
  const int runs = more ? std::atoi(more) : 500;
  std::mt19937 random(1);
  const std::string text = fixture();
  int loadedCount = 0;
  for (int i = 0; i < runs; ++i) {
    const std::string input = mutated(text, random);
    const auto loaded = parseGraph(input);
    if (!loaded) {
      ASSERT_FALSE(loaded.error().message.empty());
      continue;
    }
    ++loadedCount;
    const std::string saved = graphText(loaded->graph);
    const auto again = parseGraph(saved);
    ASSERT_TRUE(again) << i << ": " << again.error().message << "\n" << saved;
    ASSERT_EQ(graphText(again->graph), saved) << i;
  }
  EXPECT_GT(loadedCount, runs / 50) << "the mutations are too wild to test anything";
}

}  // namespace
}  // namespace pileus::nodes
