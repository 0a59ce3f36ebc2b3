// Fields are left in every way there is, and what was typed is never lost without a word.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

constexpr char kGraph[] = R"({ "pileus": 1,
  "settings": { "size": [192, 108], "frames": [1, 48], "fps": 24, "ocio": "", "workingSpace": "ACEScg" },
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 4 } },
    "Sun": { "type": "light.sun", "at": [0, 150] },
    "File": { "type": "volume.vdb_file", "at": [0, 330] },
    "Render": { "type": "render.volume", "at": [300, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [560, 0] } },
  "links": [ "Box.volume -> Render.volumes", "Sun.light -> Render.lights", "Render.image -> View.image" ] })";

fs::path graphFile(const std::string& name = "fields.json") {
  const fs::path file = scratchFolder() / name;
  std::ofstream(file) << kGraph;
  return file;
}

void begin(const UiSession& ui, const std::string& rect, const std::string& text) {
  ui.click(ui.center(rect), {"ctrl"});
  ui.type(text);
}

void select(const UiSession& ui, const std::string& node, const std::string& row) {
  ui.click("header/" + node);
  ASSERT_TRUE(ui.waitRect(row));
}

/// No field holds the keyboard: the search opens over the canvas.
void expectKeysAct(const UiSession& ui) {
  ui.move(ui.emptySpot());
  ui.key("Tab");
  EXPECT_TRUE(ui.waitRect("search/field", 4)) << "keys do nothing";
  ui.key("Escape");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("search/field"); }, 4));
}

struct Way {
  const char* name;
  std::function<void(const UiSession&)> leave;
};

const std::vector<Way>& ways() {
  static const std::vector<Way> all = {
      {"another node", [](const UiSession& ui) { ui.click("header/Box"); }},
      {"the empty canvas", [](const UiSession& ui) { ui.click(ui.emptySpot()); }},
      {"a socket",
       [](const UiSession& ui) {
         ui.click("socket/Render/out/image");
         ui.key("Escape");
       }},
      {"the viewport", [](const UiSession& ui) { ui.click("viewport"); }},
      {"the right button",
       [](const UiSession& ui) {
         ui.click("header/Box", 3);
         ui.key("Escape");
       }},
      {"a menu",
       [](const UiSession& ui) {
         ui.click("menubar/Edit");
         ui.key("Escape");
       }},
      {"a splitter", [](const UiSession& ui) { ui.click("splitter/parameters"); }},
      {"a switch of the panel",
       [](const UiSession& ui) { ui.click("panel/modified"), ui.click("panel/modified"); }},
      {"saving", [](const UiSession& ui) { ui.key("ctrl+s"); }},
  };
  return all;
}

TEST(Fields, ANumberIsTakenHoweverItIsLeft) {
  const fs::path file = graphFile();
  UiSession ui({1380, 860}, {file.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  int value = 31;
  for (const Way& way : ways()) {
    SCOPED_TRACE(way.name);
    select(ui, "Sun", "param/irradiance");
    begin(ui, "param/irradiance", std::to_string(++value));
    way.leave(ui);
    EXPECT_TRUE(becomes(ui, "Sun", "irradiance", value)) << param(ui, "Sun", "irradiance");
    expectKeysAct(ui);
  }
  EXPECT_EQ(json::parse(textOf(file))["nodes"]["Sun"]["params"]["irradiance"], value)
      << "saved with what was typed";

  // What cannot be is dropped with a message.
  select(ui, "Sun", "param/irradiance");
  begin(ui, "param/irradiance", "-5");
  ui.click("header/Box");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["message"].get<std::string>().find("\"-5\" was not taken") != std::string::npos;
  })) << ui.trace()["message"];
  EXPECT_EQ(param(ui, "Sun", "irradiance"), value);
  expectKeysAct(ui);
  // Also after it was refused by Enter, where it stays to be mended.
  select(ui, "Sun", "param/irradiance");
  begin(ui, "param/irradiance", "-7");
  ui.key("Return");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("refusal"); }));
  ui.click("header/Box");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["message"].get<std::string>().find("\"-7\" was not taken") != std::string::npos;
  })) << ui.trace()["message"];
  expectKeysAct(ui);
  // Escape alone takes nothing.
  select(ui, "Sun", "param/irradiance");
  begin(ui, "param/irradiance", "99");
  ui.key("Escape");
  expectKeysAct(ui);
  EXPECT_EQ(param(ui, "Sun", "irradiance"), value);
}

TEST(Fields, NamesTextsAndSettingsAreTakenAsWell) {
  UiSession ui({1380, 860}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  // The node's name, left for another node and for the empty canvas.
  select(ui, "Sun", "node name");
  ui.click("node name");
  ui.key("ctrl+a");
  ui.type("Key");
  ui.click("header/Box");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Key"); }));
  expectKeysAct(ui);
  // A file, left for the viewport.
  select(ui, "File", "browse/file");
  const json r = ui.trace()["rects"]["param/file"];
  ui.click(Point{r[0].get<double>() + 25, r[1].get<double>() + 12});
  ui.type("smoke.vdb");
  ui.click("header/Box");
  EXPECT_TRUE(becomes(ui, "File", "file", "smoke.vdb"));
  expectKeysAct(ui);
  // A setting of the document, left for a node.
  ui.click(ui.emptySpot());
  ASSERT_TRUE(ui.waitRect("setting/fps"));
  begin(ui, "setting/fps", "30");
  ui.click("header/Box");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["settings"]["fps"] == 30; }));
  expectKeysAct(ui);
}

TEST(Fields, ClosingTakesTheNumberAndAsks) {
  UiSession ui({1380, 860}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  select(ui, "Sun", "param/irradiance");
  begin(ui, "param/irradiance", "21");
  ui.key("ctrl+q");
  ASSERT_TRUE(ui.waitRect("dialog/cancel", 8)) << "quits with an unsaved number";
  EXPECT_TRUE(becomes(ui, "Sun", "irradiance", 21));
  ui.click("dialog/cancel");
  begin(ui, "param/irradiance", "22");
  ui.key("ctrl+o");
  ASSERT_TRUE(ui.waitRect("dialog/discard", 8));
  EXPECT_TRUE(becomes(ui, "Sun", "irradiance", 22));
}

TEST(Fields, TabGoesOn) {
  UiSession ui({1380, 860}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  select(ui, "Box", "param/size/0");
  ui.click(ui.center("param/size/0"), {"ctrl"});
  ui.type("1");
  ui.key("Tab");
  ui.type("2");
  ui.key("Tab");
  ui.type("3");
  ui.key("Return");
  EXPECT_TRUE(becomes(ui, "Box", "size", {1, 2, 3})) << param(ui, "Box", "size");
  ui.click(ui.center("param/size/2"), {"ctrl"});
  ui.type("6");
  ui.key("shift+Tab");
  ui.type("5");
  ui.key("Return");
  EXPECT_TRUE(becomes(ui, "Box", "size", {1, 5, 6})) << param(ui, "Box", "size");
  // What cannot be stays.
  ui.click(ui.center("param/size/0"), {"ctrl"});
  ui.type("-4");
  ui.key("Tab");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("refusal"); }));
  ui.key("Escape");
  expectKeysAct(ui);
  EXPECT_EQ(param(ui, "Box", "size"), json({1, 5, 6}));
}

TEST(Fields, NoDigitIsLostWhenFramesAreSlow) {
  UiSession ui({1380, 860}, {graphFile().string()}, json::object(), {}, {"PILEUS_UI_FRAME_MS=250"});
  ASSERT_TRUE(ui.running()) << ui.log();
  select(ui, "Sun", "param/irradiance");
  // All of it while one frame is drawn: the field that takes the digits is there two frames later.
  const Point p = ui.center("param/irradiance");
  ui.move(p);
  ui.input({"keydown", "ctrl", "click", "1", "keyup", "ctrl", "type", "30", "key", "Return"});
  EXPECT_TRUE(becomes(ui, "Sun", "irradiance", 30)) << param(ui, "Sun", "irradiance");
  const Point header = ui.center("header/Box");
  ui.move({p.x + 20, p.y});  // no double click
  ui.input({"keydown", "ctrl", "click", "1", "keyup", "ctrl", "type", "47", "mousemove",
            std::to_string(header.x), std::to_string(header.y), "click", "1"});
  EXPECT_TRUE(becomes(ui, "Sun", "irradiance", 47)) << param(ui, "Sun", "irradiance");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["selection"] == json{"Box"}; }));
  // A search that a key opens gets the letters that follow it.
  ui.move(ui.emptySpot());
  ui.input({"key", "Tab", "type", "spher", "key", "Return"});
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Sphere"); }));
}

}  // namespace
}  // namespace pileus::test
