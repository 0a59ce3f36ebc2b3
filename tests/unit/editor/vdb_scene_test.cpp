#include "editor/document/vdb_scene.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "editor/document/crash_log.h"
#include "editor/document/daylight.h"
#include "editor/document/drops.h"
#include "editor/document/environment_scene.h"
#include "editor/document/graph_pictures.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/document.h"
#include "renderer/image/exr.h"
#include "renderer/volume/vdb_child.h"
#include "tests/support/support.h"

// These tests read volumes, too.
namespace pileus::editor {
namespace {

namespace fs = std::filesystem;

volume::VdbFit smoke() {
  volume::VdbFit fit;
  fit.file = "/volumes/smoke_0012.vdb";
  fit.guess.grid = "density";
  fit.guess.why = "by its name, and it is a fog volume";
  fit.guess.confidence = volume::Confidence::Sure;
  fit.fit = {0.123456, 6};
  fit.voxelSize = 0.1;
  fit.longest = 200;
  fit.bounds = {dvec3(-5, 0, -5), dvec3(5, 20, 5)};
  return fit;
}

volume::VdbFit withFire(volume::VdbFit fit) {
  fit.fire = volume::FireFit{
      "temperature", "by its name", volume::Confidence::Guess, {0, 1.1, {900, 2100, 0.25}}, false, 4};
  return fit;
}

volume::VdbFit fireAlone() {
  volume::VdbFit fit = withFire(smoke());
  fit.file = "/volumes/fire_0012.vdb";
  fit.smoke = false;
  fit.guess.grid = "temperature";
  fit.fit = {};
  return fit;
}

bool linked(const nodes::Graph& graph, const nodes::Link& wanted) {
  return std::find(graph.links.begin(), graph.links.end(), wanted) != graph.links.end();
}

std::string ofType(const nodes::Graph& graph, const std::string& type) {
  for (const auto& [name, node] : graph.nodes)
    if (node->type == type) return name;
  return {};
}

TEST(VdbScene, AnEmptyGraphBecomesALitFramedCloud) {
  const volume::VdbFit fit = smoke();
  const Result<VdbScene> scene = addVdbFiles({}, {&fit, 1});
  ASSERT_TRUE(scene) << scene.error().message;
  const nodes::Graph& g = scene->graph;
  EXPECT_EQ(scene->added.size(), g.nodes.size());
  EXPECT_TRUE(linked(g, {"smoke_0012", "volume", "smoke_0012 Medium", "volume"}));
  EXPECT_TRUE(linked(g, {"smoke_0012 Medium", "volume", "Render", "volumes"}));
  // A sky lights it: its sun and the rest of it each through a shadow of its own, small where it is wide.
  for (const std::string part : {"Sun", "Sky"}) {
    EXPECT_TRUE(linked(g, {"Sky", part == "Sun" ? "sun" : "sky", part + " Metric", "light"})) << part;
    EXPECT_TRUE(linked(g, {"smoke_0012 Medium", "volume", part + " Metric", "volumes"})) << part;
    EXPECT_TRUE(linked(g, {part + " Shadow", "light", "Render", "lights"})) << part;
  }
  EXPECT_EQ(std::get<int>(nodes::findNode(g, "Sky Metric")->params.at("resolution")), 128);
  EXPECT_TRUE(ofType(g, "light.sun").empty()) << "the sky has the sun";
  EXPECT_TRUE(linked(g, {"Render", "image", "View", "image"}));
  EXPECT_EQ(std::get<double>(nodes::findNode(g, "smoke_0012 Medium")->params.at("extinction")), 0.123)
      << "three digits say what is known";
  ASSERT_TRUE(scene->camera);
  EXPECT_EQ(scene->cameraNode, "Camera");
  EXPECT_NEAR(scene->camera->target.y, 10, 0.1) << "it looks at the middle";
  // Nothing in it is a fault.
  const Result<nodes::Loaded> read = nodes::parseGraph(nodes::graphText(g));
  ASSERT_TRUE(read);
  for (const nodes::Fault& fault : read->faults) ADD_FAILURE() << nodes::faultText(fault);
}

TEST(VdbScene, ANewDocumentHasASkyThatVolumesJoin) {
  const Result<nodes::Graph> scene = newScene();
  ASSERT_TRUE(scene) << scene.error().message;
  const Result<nodes::Loaded> read = nodes::parseGraph(nodes::graphText(*scene));
  ASSERT_TRUE(read);
  for (const nodes::Fault& fault : read->faults) ADD_FAILURE() << nodes::faultText(fault);
  EXPECT_FALSE(ofType(*scene, "light.sky").empty());
  EXPECT_TRUE(linked(*scene, {"Render", "image", "View", "image"}));
  const volume::VdbFit fit = smoke();
  const Result<VdbScene> joined = addVdbFiles(*scene, {&fit, 1});
  ASSERT_TRUE(joined) << joined.error().message;
  EXPECT_EQ(joined->graph.nodes.size(), scene->nodes.size() + 2) << "no second sky, render or view";
  for (const char* metric : {"Sun Metric", "Sky Metric"})
    EXPECT_TRUE(linked(joined->graph, {"smoke_0012 Medium", "volume", metric, "volumes"})) << metric;
  // No two nodes lie on one another.
  for (const auto& [a, first] : scene->nodes)
    for (const auto& [b, second] : scene->nodes)
      EXPECT_TRUE(a >= b || std::abs(first->at.x - second->at.x) >= 200 ||
                  std::abs(first->at.y - second->at.y) >= 150)
          << a << " and " << b;
}

TEST(VdbScene, OneUndoTakesItBack) {
  const volume::VdbFit fit = smoke();
  nodes::Document document;
  document.edit(addVdbFiles(document.graph(), {&fit, 1})->graph, "Import smoke_0012.vdb");
  EXPECT_FALSE(document.graph().nodes.empty());
  document.undo();
  EXPECT_TRUE(document.graph().nodes.empty());
  EXPECT_FALSE(document.canUndo());
}

TEST(VdbScene, JoinsThePresentScene) {
  const Result<nodes::Loaded> preset =
      nodes::loadGraph(fs::path(PILEUS_SOURCE_DIR) / "presets" / "default.json");
  ASSERT_TRUE(preset);
  volume::VdbFit fit = smoke();
  scene::Camera camera;
  camera.eye = {0, 10, 60};
  camera.target = {0, 10, 0};
  const Result<VdbScene> scene = addVdbFiles(preset->graph, {&fit, 1}, "Render", camera);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene->graph.nodes.size(), preset->graph.nodes.size() + 2) << "no second sun, render or view";
  EXPECT_TRUE(linked(scene->graph, {"smoke_0012 Medium", "volume", "Render", "volumes"}));
  EXPECT_TRUE(linked(scene->graph, {"smoke_0012 Medium", "volume", "Pseudometric Map", "volumes"}));
  EXPECT_FALSE(linked(scene->graph, {"smoke_0012 Medium", "volume", "Extinction Map", "volumes"}))
      << "the map takes the metric's volumes";
  EXPECT_FALSE(scene->camera) << "it is in view";
  // Out of view: the camera moves, as part of the same graph.
  camera.eye = {0, 190, 27500};
  const Result<VdbScene> far = addVdbFiles(preset->graph, {&fit, 1}, "Render", camera);
  ASSERT_TRUE(far && far->camera);
  EXPECT_EQ(far->cameraNode, "Camera");
  EXPECT_EQ(std::get<dvec3>(nodes::findNode(far->graph, "Camera")->params.at("target")), far->camera->target);
}

TEST(VdbScene, SeveralFilesAndOddNames) {
  volume::VdbFit a = smoke(), b = smoke();
  a.file = "/x/fire=1.vdb";
  b.file = "/x/a.b/c->d.vdb";
  b.guess.grid = "flames";
  b.byDefault = false;
  const std::vector<volume::VdbFit> both{a, b};
  const Result<VdbScene> scene = addVdbFiles({}, both);
  ASSERT_TRUE(scene) << scene.error().message;
  int files = 0;
  for (const auto& [name, node] : scene->graph.nodes) {
    EXPECT_TRUE(nodes::checkName(name)) << name;
    if (node->type != "volume.vdb_file") continue;
    ++files;
    EXPECT_EQ(node->params.contains("grid"),
              std::get<std::string>(node->params.at("file")) == b.file.string());
  }
  EXPECT_EQ(files, 2);
  EXPECT_FALSE(ofType(scene->graph, "render.volume").empty());
}

TEST(VdbScene, FireGlowsBesideTheSmoke) {
  const volume::VdbFit fit = withFire(smoke());
  const Result<VdbScene> scene = addVdbFiles({}, {&fit, 1});
  ASSERT_TRUE(scene) << scene.error().message;
  const nodes::Graph& g = scene->graph;
  EXPECT_EQ(scene->added.size(), g.nodes.size()) << "all of it is one edit";
  EXPECT_TRUE(linked(g, {"smoke_0012 Medium", "volume", "Render", "volumes"}));
  EXPECT_TRUE(linked(g, {"smoke_0012 Fire", "volume", "smoke_0012 Fire Black Body", "volume"}));
  EXPECT_TRUE(linked(g, {"smoke_0012 Fire Black Body", "volume", "Render", "volumes"}));
  for (const nodes::Link& l : g.links)
    EXPECT_TRUE(l.fromNode != "smoke_0012 Fire Black Body" || l.toNode == "Render")
        << l.toNode << ": no shadow";
  EXPECT_EQ(std::get<std::string>(nodes::findNode(g, "smoke_0012 Fire")->params.at("grid")), "temperature");
  const auto& params = nodes::findNode(g, "smoke_0012 Fire Black Body")->params;
  EXPECT_EQ(std::get<double>(params.at("input_max")), 1.1);
  EXPECT_EQ(std::get<double>(params.at("coolest")), 900);
  EXPECT_EQ(std::get<double>(params.at("hottest")), 2100);
  EXPECT_EQ(std::get<double>(params.at("strength")), 0.25);
  const Result<nodes::Loaded> read = nodes::parseGraph(nodes::graphText(g));
  ASSERT_TRUE(read);
  for (const nodes::Fault& fault : read->faults) ADD_FAILURE() << nodes::faultText(fault);
  // No two nodes lie on one another.
  for (const auto& [a, first] : g.nodes)
    for (const auto& [b, second] : g.nodes)
      EXPECT_TRUE(a >= b || std::abs(first->at.x - second->at.x) >= 200 ||
                  std::abs(first->at.y - second->at.y) >= 100)
          << a << " and " << b;
  // It joins a scene in the same way.
  const Result<nodes::Loaded> preset =
      nodes::loadGraph(fs::path(PILEUS_SOURCE_DIR) / "presets" / "default.json");
  ASSERT_TRUE(preset);
  const Result<VdbScene> joined = addVdbFiles(preset->graph, {&fit, 1}, "Render");
  ASSERT_TRUE(joined) << joined.error().message;
  EXPECT_EQ(joined->graph.nodes.size(), preset->graph.nodes.size() + 4);
  EXPECT_TRUE(linked(joined->graph, {"smoke_0012 Fire Black Body", "volume", "Render", "volumes"}));
  EXPECT_FALSE(
      linked(joined->graph, {"smoke_0012 Fire Black Body", "volume", "Pseudometric Map", "volumes"}));
}

TEST(VdbScene, FireAloneIsAPictureWithoutLights) {
  const volume::VdbFit fit = fireAlone();
  const Result<VdbScene> scene = addVdbFiles({}, {&fit, 1});
  ASSERT_TRUE(scene) << scene.error().message;
  const nodes::Graph& g = scene->graph;
  EXPECT_TRUE(linked(g, {"fire_0012 Black Body", "volume", "Render", "volumes"}));
  EXPECT_TRUE(ofType(g, "volume.medium").empty());
  EXPECT_TRUE(ofType(g, "light.sky").empty());
  EXPECT_TRUE(ofType(g, "shadow.pseudometric").empty());
  ASSERT_TRUE(scene->camera);
  EXPECT_NEAR(scene->camera->target.y, 10, 0.1);
  EXPECT_NE(scene->summary.find("fire alone"), std::string::npos);
  // Fire and smoke of two files: the smoke is lit.
  const std::vector<volume::VdbFit> both{fireAlone(), smoke()};
  EXPECT_FALSE(ofType(addVdbFiles({}, both)->graph, "shadow.pseudometric").empty());
}

TEST(VdbScene, RealFireIsFoundAndFramed) {
  PILEUS_NEEDS_DATA();
  JobControl control;
  const auto fit =
      volume::fitVdb(*test::dataFolder() / "vdb" / "embergen_fire" / "embergen_fire_a_20.vdb", control);
  ASSERT_TRUE(fit) << fit.error().message;
  const Result<VdbScene> scene = addVdbFiles({}, {&*fit, 1});
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_FALSE(ofType(scene->graph, "volume.blackbody").empty());
  ASSERT_TRUE(scene->camera);
  EXPECT_LT(glm::length(scene->camera->target - fit->bounds.center()), 2);
}

TEST(VdbScene, ExplainsFire) {
  std::string all;
  for (const volume::VdbFit& fit : {fireAlone(), withFire(smoke())})
    for (const std::string& line : explainFit(fit)) all += line + "\n";
  for (const char* part : {"'temperature' glows by its name (a guess)", "900 to 2100 K", "they have no unit",
                           "strength 0.25", "optical depth above 6"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
  EXPECT_EQ(all.find("could not be fitted"), std::string::npos) << "fire alone has no density to fit";
}

TEST(VdbScene, ExplainsWhatItGuessed) {
  volume::VdbFit fit = smoke();
  fit.frames = {12, "smoke_0001.vdb", "smoke_0012.vdb"};
  fit.guess.notes = {"'v' looks like velocity: motion blur is not rendered yet, so it is left out"};
  std::string all;
  for (const std::string& line : explainFit(fit)) all += line + "\n";
  for (const char* part : {"'density'", "by its name", "(sure)", "0.123", "optical depth above 6",
                           "motion blur", "12 frames", "smoke_0001.vdb"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

TEST(Drops, KindsAndRefusals) {
  EXPECT_EQ(dropKind("a/B.JSON"), DropKind::Graph);
  EXPECT_EQ(dropKind("x.VDB"), DropKind::Volume);
  EXPECT_EQ(dropKind("x.exr"), DropKind::Still);
  EXPECT_EQ(dropKind("x.hdr"), DropKind::Environment);
  EXPECT_EQ(dropKind("x"), DropKind::Unknown);
  EXPECT_NE(whyNotDropped("x.nvdb").find("convert"), std::string::npos);
}

TEST(Drops, SeveralFilesAtOnceAndAStillGivesItsGraphBack) {
  const fs::path folder = test::scratchFolder();
  const nodes::Graph graph = *nodes::addNode({}, "volume.sphere", {0, 0}, "Ball");
  image::Image picture;
  picture.size = {4, 3};
  picture.layers.push_back({"", 4, std::vector<float>(48, 0.25f)});
  ASSERT_TRUE(image::writeExr(folder / "plain.exr", picture));
  picture.metadata[image::kGraphAttribute] = nodes::graphTextFor(folder / "still.exr", graph);
  ASSERT_TRUE(image::writeExr(folder / "still.exr", picture));
  ASSERT_TRUE(nodes::saveGraph(folder / "g.json", graph));
  std::ofstream(folder / "notes.txt") << "x";
  std::ofstream(folder / "broken.exr") << "no picture";
  JobControl control;
  const DropContent content = readDrops({folder / "g.json", folder / "still.exr", folder / "plain.exr",
                                         folder / "broken.exr", folder / "notes.txt", folder / "gone.vdb"},
                                        control);
  EXPECT_EQ(content.graphs, std::vector<fs::path>{folder / "g.json"});
  ASSERT_EQ(content.stills.size(), 1u);
  const Result<nodes::Loaded> back = nodes::parseGraph(content.stills[0].second);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->graph == graph);
  EXPECT_EQ(content.environments, std::vector<fs::path>{folder / "plain.exr"});
  ASSERT_EQ(content.refusals.size(), 3u);
  EXPECT_NE(content.refusals[0].find("not a readable EXR"), std::string::npos);
  EXPECT_NE(content.refusals[2].find("no such file"), std::string::npos);
}

TEST(Drops, AnEnvironmentLightsTheRender) {
  Result<EnvironmentScene> alone = addEnvironment({}, "/sky/a.b.hdr");
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->node, "a b");
  EXPECT_EQ(alone->graph.nodes.size(), 1u);
  nodes::Graph graph = *nodes::addNode({}, "volume.sphere", {0, 0}, "Ball");
  graph = *nodes::addNode(graph, "render.volume", {400, 0}, "Render");
  graph = *nodes::connect(graph, {"Ball", "volume", "Render", "volumes"});
  const Result<EnvironmentScene> lit = addEnvironment(graph, "/sky/noon.exr");
  ASSERT_TRUE(lit);
  const auto linked = [&](const char* from, const char* to) {
    return std::any_of(lit->graph.links.begin(), lit->graph.links.end(),
                       [&](const nodes::Link& l) { return l.fromNode == from && l.toNode == to; });
  };
  EXPECT_TRUE(linked("noon", "noon Metric"));
  EXPECT_TRUE(linked("Ball", "noon Metric"));
  EXPECT_TRUE(linked("noon Metric", "noon Shadow"));
  EXPECT_TRUE(linked("noon Shadow", "Render"));
  nodes::Graph traced = *nodes::addNode({}, "render.path_trace", {0, 0}, "Truth");
  const Result<EnvironmentScene> direct = addEnvironment(traced, "/sky/noon.exr");
  ASSERT_TRUE(direct);
  EXPECT_EQ(direct->graph.nodes.size(), 2u);
  EXPECT_EQ(direct->graph.links.size(), 1u);
}

TEST(Thumbnails, AreAveragedAndBounded) {
  std::vector<unsigned char> rgba(1024 * 512 * 4);
  for (std::size_t i = 0; i < rgba.size(); i += 4) rgba[i] = i / 4 % 2 ? 255 : 0, rgba[i + 1] = 51;
  const SmallPicture small = reducedPicture({1024, 512}, rgba, 512);
  EXPECT_EQ(small.size, ivec2(512, 256));
  EXPECT_FLOAT_EQ(small.rgba[0], 0.5f) << "columns are averaged";
  EXPECT_FLOAT_EQ(small.rgba[1], 0.2f);
  EXPECT_EQ(reducedPicture({300, 20}, std::vector<unsigned char>(24000), 512).size, ivec2(300, 20));
  EXPECT_EQ(reducedPicture({300, 20}, {}, 512).size, ivec2(0)) << "too few pixels";
  EXPECT_NE(thumbnailPath("/a/b.json"), thumbnailPath("/a/c.json"));
}

TEST(CrashLog, KeepsTheLastEventsAndReportsOnce) {
  for (int i = 0; i < 450; ++i) crash::note("event " + std::to_string(i));
  const std::vector<std::string> events = crash::events();
  ASSERT_EQ(events.size(), 200u);
  EXPECT_EQ(events.front(), "event 250");
  EXPECT_EQ(events.back(), "event 449");
  const fs::path folder = test::scratchFolder();
  std::ofstream(folder / "crash-1-2.txt") << "x";
  EXPECT_EQ(crash::takeNewReports(folder).size(), 1u);
  EXPECT_TRUE(crash::takeNewReports(folder).empty()) << "mentioned once";
}

TEST(CrashLogDeathTest, WritesAReport) {
  const fs::path folder = test::scratchFolder();
  EXPECT_EXIT(
      {
        crash::install(folder);
        crash::setGraph("/home/me/harbour.json");
        crash::setDevice("llvmpipe");
        crash::note("key Ctrl+90");
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "");
  const std::vector<fs::path> reports = crash::takeNewReports(folder);
  ASSERT_EQ(reports.size(), 1u);
  std::ifstream in(reports[0]);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  for (const char* part : {"SIGABRT", "/home/me/harbour.json", "llvmpipe", "key Ctrl+90", "stack:"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(Drops, ASequenceBeginsWithItsFirstFrameThatHoldsSomething) {
  PILEUS_NEEDS_DATA();
  const std::filesystem::path folder = test::scratchFolder();
  for (const char* empty : {"s.0001.vdb", "s.0002.vdb"}) std::ofstream(folder / empty) << "nothing";
  for (const char* full : {"s.0010.vdb", "s.0011.vdb", "t.0003.vdb"})
    std::filesystem::copy_file(*test::dataFolder() / "vdb" / "smoke1.vdb", folder / full);
  JobControl control;
  const DropContent read = readDrops({folder / "s.0001.vdb"}, control);
  ASSERT_EQ(read.volumes.size(), 1u);
  EXPECT_EQ(read.volumes.front().file.filename(), "s.0010.vdb");
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_NE(read.notes.front().find("s.0010.vdb"), std::string::npos);
  EXPECT_TRUE(read.refusals.empty());
  // What has nothing beside it is refused as before.
  std::ofstream(folder / "alone.vdb") << "nothing";
  EXPECT_EQ(readDrops({folder / "alone.vdb"}, control).refusals.size(), 1u);
}

}  // namespace
}  // namespace pileus::editor
