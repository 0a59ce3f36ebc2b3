// The editor in a real window with real input: a whole session, and what must never happen in one.
#include "nodes/file/serialize.h"
#include "renderer/image/exr.h"
#include "renderer/image/metrics.h"
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

/// Small enough that a software rasteriser finishes it while one looks.
constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [192, 108], "frames": [1, 1], "fps": 24, "ocio": "", "workingSpace": "ACEScg" },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 3 } },
    "Sun": { "type": "light.sun", "at": [0, 130], "params": { "elevation": 30 } },
    "Camera": { "type": "camera.perspective", "at": [0, 250], "params": { "eye": [1.5, 1, 3] } },
    "Map": { "type": "shadow.extinction", "at": [260, 60], "params": { "resolution": 64 } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 4 } },
    "View": { "type": "output.view", "at": [780, 0] }
  },
  "links": [
    "Box.volume -> Map.volumes",
    "Sun.light -> Map.light",
    "Box.volume -> Render.volumes",
    "Map.light -> Render.lights",
    "Camera.camera -> Render.camera",
    "Render.image -> View.image"
  ]
}
)";

std::filesystem::path graphFile() {
  const std::filesystem::path path = scratchFolder() / "scene.json";
  std::ofstream(path) << kGraph;
  return path;
}

/// Wheel notches over the canvas, so that there is room around the nodes.
void zoomOut(const UiSession& ui, int notches) {
  ui.finishPicture();
  ui.move(ui.emptySpot());
  for (int i = 0; i < notches; ++i) ui.input({"click", "5"});
  ui.settle();
}

TEST(Session, OpenAddLinkDragUndoSaveExportQuit) {
  UiSession ui({1280, 720}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(
      ui.waitFor([](const json& t) { return t["complete"] == true && t["notes"].contains("picture"); }, 60))
      << ui.log();
  ui.screenshot("01-opened");
  zoomOut(ui, 3);

  // A node by search.
  ui.move(ui.emptySpot());
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("search/field"));
  ui.type("sphr");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].value("search/0", "") == "Sphere"; }))
      << ui.trace()["notes"];
  ui.screenshot("02-search");
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Sphere"); }));
  EXPECT_TRUE(ui.trace()["dirty"]);

  // A link between sockets.
  ui.drag(ui.center("socket/Sphere/out/volume"), ui.center("socket/Render/in/volumes"));
  ASSERT_TRUE(ui.waitFor([](const json& t) { return hasLink(t, "Sphere.volume -> Render.volumes"); }))
      << ui.trace()["document"]["links"];

  // A link that cannot be: the reason stands beside the pointer, and nothing changes.
  const json before = ui.trace()["document"];
  const Point from = ui.center("socket/Sphere/out/volume"), to = ui.center("socket/Render/in/camera");
  ui.press(from);
  ui.dragTo(from, to);
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    const std::string reason = t["notes"].value("refusal", "");
    return reason.find("Volume") != std::string::npos && reason.find("Camera") != std::string::npos;
  })) << ui.trace()["notes"];
  ui.screenshot("03-refused");
  ui.release();
  EXPECT_EQ(ui.trace()["document"], before);

  // Dropping a link on nothing lists exactly what fits.
  ui.drag(ui.center("socket/Sun/out/light"), ui.emptySpot());
  ASSERT_TRUE(ui.waitRect("search/field"));
  ui.screenshot("04-filtered");
  std::size_t fitting = 0;
  for (const nodes::NodeType& type : nodes::allNodeTypes())
    for (const nodes::SocketSpec& s : type.inputs) fitting += s.type == nodes::SocketType::Light ? 1u : 0u;
  std::size_t listed = 0;
  const json notes = ui.trace()["notes"];
  for (const auto& [name, text] : notes.items())
    if (name.starts_with("search/")) ++listed;
  EXPECT_EQ(listed, fitting) << notes;
  ui.key("Escape");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("search/field"); }));

  // A slider: one undo step, undone and redone.
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitRect("param/elevation"));
  const Point slider = ui.center("param/elevation");
  const json undoBefore = ui.trace()["undo"];
  ui.press(slider);
  ui.dragTo(slider, {slider.x + 40, slider.y});
  ui.screenshot("05-dragging");
  ui.release();
  const auto elevation = [&] {
    return ui.trace()["document"]["nodes"]["Sun"]["params"].value("elevation", -1.0);
  };
  ASSERT_TRUE(ui.waitFor([&](const json&) { return elevation() > 31; })) << elevation();
  const double dragged = elevation();
  ui.move(ui.emptySpot());
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return elevation() == 30 && t["undo"] == undoBefore; }))
      << "the whole drag is one step";
  ui.key("ctrl+shift+z");
  EXPECT_TRUE(ui.waitFor([&](const json&) { return elevation() == dragged; })) << elevation();

  // Orbiting edits the linked camera as one step.
  const Point middle = ui.center("viewport"),
              view = {middle.x - 180, middle.y + 70};  // beside the sun's handles
  const json undoCamera = ui.trace()["document"]["nodes"]["Camera"];
  ui.drag(view, {view.x + 60, view.y + 10});
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"]["Camera"] != undoCamera; }));
  ui.key("bracketright");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["document"]["nodes"]["View"].contains("params") &&
           t["document"]["nodes"]["View"]["params"]["exposure"] == 0.5;
  }));

  // Save as: what is in the file is what is on the screen.
  const std::filesystem::path saved = scratchFolder() / "saved.json";
  ui.key("ctrl+shift+s");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.screenshot("06-save-as");
  ui.type(saved.string());
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["dirty"] == false && t["path"] != ""; }))
      << ui.trace()["notes"];
  EXPECT_EQ(json::parse(textOf(saved)), ui.trace()["document"]);

  // Export from the menu equals the command line's picture.
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 60));
  ui.screenshot("07-final");
  const std::filesystem::path folder = saved.parent_path();
  ui.click("menubar/File");
  ASSERT_TRUE(ui.waitRect("menu/file.export"));
  ui.screenshot("08-menu");
  ui.click("menu/file.export");
  ASSERT_TRUE(ui.waitRect("browser/name"));
  ui.type((folder / "editor.exr").string());
  ui.key("Return");
  ASSERT_TRUE(
      ui.waitFor([](const json& t) { return t["message"].get<std::string>().starts_with("Exported"); }, 60))
      << ui.trace()["message"];
  const RunResult rendered = pileus({"render", saved.string(), "-o", (folder / "cli.exr").string()});
  ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
  const auto a = image::readExr(folder / "editor.exr"), b = image::readExr(folder / "cli.exr");
  ASSERT_TRUE(a && b);
  const auto difference = image::compare(*a, *b);
  ASSERT_TRUE(difference) << difference.error().message;
  EXPECT_LT(difference->maximum, 1e-3) << "half floats of the same samples";
  double brightest = 0;
  for (const float v : b->layers[0].pixels) brightest = std::max(brightest, static_cast<double>(v));
  EXPECT_GT(brightest, 0.05) << "the picture shows something";

  ui.key("ctrl+q");
  EXPECT_EQ(ui.waitExit(), 0) << ui.log();
}

TEST(Session, UnsavedChangesAreAskedAbout) {
  const std::filesystem::path file = graphFile();
  UiSession ui({1280, 720}, {file.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Sun"}; }));
  ui.key("Delete");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["document"]["nodes"].contains("Sun"); }));
  ui.key("ctrl+q");
  ASSERT_TRUE(ui.waitRect("dialog/cancel"));
  ui.screenshot("09-unsaved");
  ui.click("dialog/cancel");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("dialog/cancel"); }));
  EXPECT_EQ(ui.waitExit(0.5), -1) << "cancel keeps the window";
  ui.key("ctrl+q");
  ui.click("dialog/discard");
  EXPECT_EQ(ui.waitExit(), 0);
  EXPECT_EQ(textOf(file), kGraph) << "discarding leaves the file alone";
}

TEST(Session, CopyPasteDuplicateBypassAndTyping) {
  UiSession ui({1280, 720}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  zoomOut(ui, 3);
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Sun"}; }));
  ui.key("ctrl+c");
  ui.move(ui.emptySpot());
  ui.key("ctrl+v");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Sun 2"); }));
  EXPECT_EQ(ui.trace()["document"]["nodes"]["Sun 2"]["params"]["elevation"], 30);
  ui.key("ctrl+d");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Sun 3"); }));
  ui.key("d");
  EXPECT_TRUE(
      ui.waitFor([](const json& t) { return t["document"]["nodes"]["Sun 3"].value("bypass", false); }));

  // Typing: a value beyond the soft range but inside the hard one is taken, one beyond that is refused with
  // the range.
  ui.click("header/Box");
  ASSERT_TRUE(ui.waitRect("param/density"));
  const auto typeDensity = [&](const std::string& text) {
    const Point field = ui.center("param/density");
    ui.click(field, {"ctrl"});
    ui.type(text);
    ui.key("Return");
  };
  typeDensity("7.25");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["document"]["nodes"]["Box"]["params"]["density"] == 7.25;
  })) << ui.trace()["document"]["nodes"]["Box"];
  typeDensity("-5");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("refusal", "").find("out of range") != std::string::npos;
  })) << ui.trace()["notes"];
  EXPECT_EQ(ui.trace()["document"]["nodes"]["Box"]["params"]["density"], 7.25);
  ui.screenshot("10-refused-value");
}

TEST(Session, ABadFileIsRefusedAndNothingIsLost) {
  const std::filesystem::path bad = scratchFolder() / "bad.json";
  std::ofstream(bad) << "{ \"pileus\": 1, ";
  UiSession ui({1280, 720}, {bad.string()});
  ui.expectLogged("bad.json: line 1");
  ASSERT_TRUE(ui.running()) << ui.log();
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("dialog error", "").find("bad.json") != std::string::npos;
  })) << ui.trace()["notes"];
  ui.screenshot("11-bad-file");
  ui.key("Escape");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["notes"].contains("dialog error"); }));
  ui.screenshot("12-empty");
  ui.key("ctrl+q");
  EXPECT_EQ(ui.waitExit(), 0);
}

TEST(Session, FaultsAreListedAndSurviveASave) {
  const std::filesystem::path file = scratchFolder() / "future.json";
  std::ofstream(file)
      << R"({ "pileus": 1, "nodes": { "New": { "type": "from.tomorrow", "at": [0, 0], "params": { "x": 1 } } }, "links": [] })";
  UiSession ui({1280, 720}, {file.string()});
  ui.expectLogged("unknown node type 'from.tomorrow'");
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitRect("dialog/close"));
  ui.screenshot("14-faults");
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("dialog/close"); }));
  ui.key("ctrl+s");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["message"].get<std::string>().starts_with("Saved"); }))
      << ui.trace()["message"];
  EXPECT_EQ(json::parse(textOf(file))["nodes"]["New"]["params"]["x"], 1);
  ui.key("ctrl+q");
  EXPECT_EQ(ui.waitExit(), 0);
}

TEST(Session, AFinishedPictureCostsNothing) {
  UiSession ui({1920, 1080}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 60));
  ui.click("header/Render");
  ui.screenshot("13-large");
  pause(1);
  const double before = cpuSeconds(ui.process());
  pause(4);
  EXPECT_LT((cpuSeconds(ui.process()) - before) / 4, 0.03) << "idle processor share";
}

}  // namespace
}  // namespace pileus::test
