// The parameter panel in a real window: typing, dragging, keys over a row, several nodes, colours, files,
// help.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

fs::path graphFile(const std::string& nodes) {
  const fs::path file = scratchFolder() / "parameters.json";
  std::ofstream(file) << R"({ "pileus": 1, "links": [], "nodes": {)" << nodes << "} }";
  return file;
}

constexpr char kNodes[] = R"(
  "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 4 } },
  "Box 2": { "type": "volume.box", "at": [0, 150] },
  "Sun": { "type": "light.sun", "at": [260, 0] },
  "File": { "type": "volume.vdb_file", "at": [260, 150] })";

void open(const UiSession& ui, const std::string& rect) { ui.click(ui.center(rect), {"ctrl"}); }

void enter(const UiSession& ui, const std::string& rect, const std::string& text) {
  open(ui, rect);
  ui.type(text);
  ui.key("Return");
}

/// A point of the row's label.
Point label(const UiSession& ui, const std::string& id) {
  const json r = ui.trace()["rects"]["param/" + id];
  return {r[0].get<double>() - 30, 0.5 * (r[1].get<double>() + r[3].get<double>())};
}

TEST(Parameters, TypingUnitsArrowsAndEscape) {
  UiSession ui({1280, 800}, {graphFile(kNodes).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("header/Box");
  ASSERT_TRUE(ui.waitRect("param/density"));
  enter(ui, "param/density", "3*2");
  EXPECT_TRUE(becomes(ui, "Box", "density", 6));
  enter(ui, "param/density", "+0.5");
  EXPECT_TRUE(becomes(ui, "Box", "density", 6.5));
  enter(ui, "param/density", "+1 stop");
  EXPECT_TRUE(becomes(ui, "Box", "density", 13));
  enter(ui, "param/size/0", "1m 50cm");
  EXPECT_TRUE(becomes(ui, "Box", "size", {1.5, 1, 1}));

  // What cannot be stays in the field with its reason; Esc leaves the value as it was.
  enter(ui, "param/density", "5 bananas");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].value("refusal", "").find("bananas") != std::string::npos; }));
  ui.screenshot("param-01-refused");
  ui.key("Escape");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["notes"].contains("refusal"); }));
  EXPECT_EQ(param(ui, "Box", "density"), 13);

  // Arrows change the digit before the caret at once; Esc takes that back, and there is no step of it.
  const json undo = ui.trace()["undo"];
  open(ui, "param/density");
  ui.key("End");
  ui.key("Up");
  EXPECT_TRUE(becomes(ui, "Box", "density", 14));
  ui.key("Left");
  ui.key("Up");
  EXPECT_TRUE(becomes(ui, "Box", "density", 24));
  ui.key("Escape");
  EXPECT_TRUE(becomes(ui, "Box", "density", 13));
  EXPECT_EQ(ui.trace()["undo"], undo);

  // Esc in a drag as well.
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitRect("param/elevation"));
  const Point slider = ui.center("param/elevation");
  ui.press(slider);
  ui.dragTo(slider, {slider.x + 40, slider.y});
  EXPECT_TRUE(ui.waitFor([&](const json&) { return param(ui, "Sun", "elevation").is_number(); }));
  ui.key("Escape");
  EXPECT_TRUE(becomes(ui, "Sun", "elevation", json()));
  ui.release();
  EXPECT_EQ(ui.trace()["undo"], undo);

  // The wheel: only with Ctrl.
  ui.move(slider);
  ui.input({"click", "4"});
  EXPECT_EQ(param(ui, "Sun", "elevation"), json());
  ui.input({"keydown", "ctrl"});
  ui.input({"click", "4"});
  ui.input({"keyup", "ctrl"});
  EXPECT_TRUE(ui.waitFor([&](const json&) { return param(ui, "Sun", "elevation").is_number(); }));
  EXPECT_EQ(ui.trace()["undo"], "Set Sun.elevation");
  ui.screenshot("param-02-sun");
}

TEST(Parameters, KeysActOnTheRowUnderThePointer) {
  UiSession ui({1280, 800}, {graphFile(kNodes).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("header/Box");
  ASSERT_TRUE(ui.waitRect("param/density"));
  const auto over = [&](const std::string& key) {
    return ui.waitFor([&](const json& t) { return t["notes"].value("hovered param", "") == key; });
  };
  ui.move(label(ui, "density"));
  ASSERT_TRUE(over("Box.density"));
  ui.key("ctrl+c");
  ui.key("BackSpace");
  EXPECT_TRUE(becomes(ui, "Box", "density", json()));
  ui.key("ctrl+v");
  EXPECT_TRUE(becomes(ui, "Box", "density", 4));
  ui.key("i");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["undo"].get<std::string>().find("Set key of Box.density") == 0;
  })) << ui.trace()["undo"];
  ui.screenshot("param-03-key");
  ui.key("i");
  EXPECT_TRUE(becomes(ui, "Box", "density", 4));

  // Help: a tooltip after a rest, the page with F1.
  ui.move({label(ui, "density").x - 3, label(ui, "density").y});
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["notes"].value("param help", "") == "density"; }, 4));
  ui.screenshot("param-04-tooltip");
  ui.key("F1");
  EXPECT_TRUE(
      ui.waitFor([](const json& t) { return t["notes"].value("help page", "") == "volume.box#density"; }));
  ui.screenshot("param-05-help");
  ui.key("Escape");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["notes"].contains("help page"); }));

  // A parameter as input of the node, and back.
  ui.click("expose/density");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["document"]["nodes"]["Box"].value("expose", json::array()) == json{"density"};
  })) << ui.trace()["document"]["nodes"]["Box"];
  ui.click("expose/density");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["document"]["nodes"]["Box"].contains("expose"); }));

  // All values of a node onto another one.
  ui.move(ui.center("header/Box"));
  ui.key("ctrl+c");
  ui.click("header/Box 2");
  ASSERT_TRUE(ui.waitRect("param/density"));
  ui.move(label(ui, "center"));
  ASSERT_TRUE(over("Box 2.center"));
  ui.key("ctrl+shift+v");
  EXPECT_TRUE(becomes(ui, "Box 2", "density", 4));

  // Two of a type together: one step; the pin keeps what is shown.
  enter(ui, "param/density", "2");
  EXPECT_TRUE(becomes(ui, "Box 2", "density", 2));
  ui.input({"keydown", "shift"});
  ui.click("header/Box");
  ui.input({"keyup", "shift"});
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].value("edited together", "") == "2"; }));
  ui.screenshot("param-06-together");
  enter(ui, "param/density", "7");
  EXPECT_TRUE(becomes(ui, "Box", "density", 7));
  EXPECT_TRUE(becomes(ui, "Box 2", "density", 7));
  EXPECT_EQ(ui.trace()["undo"], "Set density of 2 nodes");
  ui.click("header/Box");
  ASSERT_TRUE(ui.waitRect("panel/pin"));
  ui.click("panel/pin");
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Sun"}; }));
  EXPECT_TRUE(ui.waitRect("param/density")) << "pinned to the box";
  ui.click("panel/pin");
  EXPECT_TRUE(ui.waitRect("param/elevation"));
  ui.click("panel/modified");
  EXPECT_TRUE(ui.waitRect("panel/show all"));
  ui.click("panel/show all");
  EXPECT_TRUE(ui.waitRect("param/elevation"));
}

TEST(Parameters, ColoursThroughThePicker) {
  UiSession ui({1280, 800}, {graphFile(kNodes).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitRect("swatch/color"));
  enter(ui, "param/color/0", "3000K");
  EXPECT_TRUE(ui.waitFor([&](const json&) {
    const json c = param(ui, "Sun", "color");
    return c.is_array() && c[0].get<double>() > 1.2 && c[2].get<double>() < 0.6;
  })) << param(ui, "Sun", "color");
  ui.click("swatch/color");
  ASSERT_TRUE(ui.waitRect("picker/wheel"));
  ui.screenshot("param-07-picker");
  const json before = param(ui, "Sun", "color");
  const Point wheel = ui.center("picker/wheel");
  ui.drag(wheel, {wheel.x - 50, wheel.y});
  EXPECT_TRUE(ui.waitFor([&](const json&) {
    const json c = param(ui, "Sun", "color");
    return c != before && c[1].get<double>() > c[0].get<double>();
  })) << "left of the middle is cyan: "
      << param(ui, "Sun", "color");
  enter(ui, "picker/intensity", "2");
  EXPECT_TRUE(ui.waitFor([&](const json&) {
    const json c = param(ui, "Sun", "color");
    return std::abs(std::max({c[0].get<double>(), c[1].get<double>(), c[2].get<double>()}) - 2) < 1e-3;
  })) << param(ui, "Sun", "color");
  ui.screenshot("param-08-picked");
}

TEST(Parameters, FilesAndSettings) {
  const fs::path folder = scratchFolder() / "volumes";
  fs::create_directories(folder / "deep");
  for (int i = 1; i <= 12; ++i)
    std::ofstream(folder / ("smoke." + std::string(i < 10 ? "000" : "00") + std::to_string(i) + ".vdb"))
        << "x";
  for (const char* name : {"cumulus.vdb", "notes.txt"}) std::ofstream(folder / name) << "x";
  UiSession ui({1280, 800}, {graphFile(kNodes).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("header/File");
  ASSERT_TRUE(ui.waitRect("browse/file"));
  const json r = ui.trace()["rects"]["param/file"];
  const Point text = {r[0].get<double>() + 25, r[1].get<double>() + 12};
  ui.click(text);
  ui.type((folder / "nothing.vdb").string());
  ui.key("Return");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("missing file", "").find("no such file") != std::string::npos;
  })) << ui.trace()["notes"];
  ui.screenshot("param-09-missing");
  ui.click("clear/file");
  EXPECT_TRUE(becomes(ui, "File", "file", json()));
  ui.click(text);
  ui.type((folder / "cu").string());
  ui.key("Tab");
  ui.key("Return");
  EXPECT_TRUE(becomes(ui, "File", "file", (folder / "cumulus.vdb").string())) << "completed with Tab";

  ui.click("browse/file");
  ASSERT_TRUE(ui.waitRect("entry/smoke.####.vdb")) << "a sequence is one row";
  EXPECT_FALSE(ui.trace()["rects"].contains("entry/notes.txt"));
  ui.screenshot("param-10-browser");
  ui.click("browser/filter");
  ui.type("smo");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("entry/cumulus.vdb"); }));
  ui.click("entry/smoke.####.vdb");
  ui.click("browser/ok");
  EXPECT_TRUE(ui.waitFor([&](const json&) {
    const json file = param(ui, "File", "file");
    return file.is_string() && file.get<std::string>().find("smoke.") != std::string::npos;
  }));

  // With nothing selected: the document.
  ui.click(ui.emptySpot());
  ASSERT_TRUE(ui.waitRect("setting/fps"));
  enter(ui, "setting/fps", "24*2");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["settings"]["fps"] == 48; }));
  EXPECT_TRUE(ui.waitRect("setting/ocio"));
  ui.screenshot("param-11-document");
}

}  // namespace
}  // namespace pileus::test
