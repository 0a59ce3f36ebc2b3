// Fields are left in every way there is, and what was typed is never lost without a word.
#include <algorithm>

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
    "Plane": { "type": "solid.plane", "at": [300, 330] },
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
       [](const UiSession& ui) {
         const char* rect =
             ui.shows("panel/modified") ? "panel/modified" : "viewport";  // documents have none
         ui.click(rect), ui.click(rect);
       }},
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

/// A kind of field: how one gets to it and types `value`, and where the document has that then.
struct Kind {
  const char* name;
  std::function<void(const UiSession&, int value)> type;
  std::function<bool(const json& trace, int value)> taken;
  bool tabs = true;  ///< false: Tab completes what is typed, or does nothing
};

json paramOf(const json& trace, const char* node, const char* id) {
  const json& n = trace["document"]["nodes"][node];
  return n.contains("params") && n["params"].contains(id) ? n["params"][id] : json();
}

Kind numberOf(const char* name, const char* node, const char* id, int component = -1) {
  const std::string rect =
      std::string("param/") + id + (component < 0 ? "" : "/" + std::to_string(component));
  return {name,
          [=](const UiSession& ui, int value) {
            select(ui, node, rect);
            begin(ui, rect, std::to_string(value));
          },
          [=](const json& t, int value) {
            const json v = paramOf(t, node, id);
            return component < 0 ? v == value : v.is_array() && v[std::size_t(component)] == value;
          }};
}

/// A click into the row's first line, below which a fault may stand, then a text in place of all.
void retype(const UiSession& ui, const std::string& rect, const std::string& text) {
  const json r = ui.trace()["rects"][rect];
  ui.click(Point{r[0].get<double>() + 25, r[1].get<double>() + 12});
  ui.key("ctrl+a");
  ui.type(text);
}

std::vector<Kind> kinds() {
  return {
      numberOf("a number", "Sun", "irradiance"),
      numberOf("a whole number", "Render", "samples"),
      numberOf("a component", "Box", "size", 1),
      numberOf("an angle", "Sun", "azimuth"),
      {"a file",
       [](const UiSession& ui, int value) {
         select(ui, "File", "browse/file");
         retype(ui, "param/file", std::to_string(value) + ".vdb");
       },
       [](const json& t, int value) { return paramOf(t, "File", "file") == std::to_string(value) + ".vdb"; },
       false},
      {"the node's name",
       [](const UiSession& ui, int value) {
         std::string name;
         const json trace = ui.trace();
         for (const auto& [n, node] : trace["document"]["nodes"].items())
           if (node["type"] == "solid.plane") name = n;
         select(ui, name, "node name");
         ui.click("node name");
         ui.key("ctrl+a");
         ui.type("P" + std::to_string(value));
       },
       [](const json& t, int value) { return t["document"]["nodes"].contains("P" + std::to_string(value)); },
       false},
      {"a setting",
       [](const UiSession& ui, int value) {
         ui.click(ui.emptySpot());
         ASSERT_TRUE(ui.waitRect("setting/fps"));
         begin(ui, "setting/fps", std::to_string(value));
       },
       [](const json& t, int value) { return t["document"]["settings"]["fps"] == value; }},
      {"the speed in the timeline",
       [](const UiSession& ui, int value) { begin(ui, "timeline/fps", std::to_string(value)); },
       [](const json& t, int value) { return t["document"]["settings"]["fps"] == value; }}};
}

/// The question about unsaved work that a way ends in is taken back.
void cancelQuestion(const UiSession& ui) {
  ASSERT_TRUE(ui.waitRect("dialog/cancel", 8));
  ui.click("dialog/cancel");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("dialog/cancel"); }, 8));
}

std::vector<Way> everyWay() {
  std::vector<Way> all = {
      {"another node", [](const UiSession& ui) { ui.click("header/View"); }},
      {"a link",
       [](const UiSession& ui) {
         const Point a = ui.center("socket/Render/out/image"), b = ui.center("socket/View/in/image");
         ui.click(Point{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
       }},
      {"the tab key", [](const UiSession& ui) { ui.key("Tab"), ui.key("Escape"); }},
      {"another document", [](const UiSession& ui) { ui.key("ctrl+o"), cancelQuestion(ui); }},
      {"a frame change", [](const UiSession& ui) { ui.click("timeline/ruler"); }},
      {"closing", [](const UiSession& ui) { ui.close(), cancelQuestion(ui); }}};
  for (const Way& way : ways())
    if (way.name != std::string("another node")) all.push_back(way);
  return all;
}

class EveryField : public testing::TestWithParam<Kind> {};

TEST_P(EveryField, IsTakenHoweverItIsLeft) {
  const Kind& kind = GetParam();
  UiSession ui({1380, 980}, {graphFile().string()}, {{"showTimeline", true}});
  ASSERT_TRUE(ui.running()) << ui.log();
  int value = 40;  // no default is among what follows: those are not in the document
  for (const Way& way : everyWay()) {
    if (!kind.tabs && way.name == std::string("the tab key")) continue;
    SCOPED_TRACE(way.name);
    kind.type(ui, ++value);
    way.leave(ui);
    EXPECT_TRUE(ui.waitFor([&](const json& t) { return kind.taken(t, value); }, 5));
    EXPECT_TRUE(ui.waitFor([](const json& t) { return t["typing"] == false; }, 5));
    if (testing::Test::HasFailure()) return;
  }
  expectKeysAct(ui);

  // Undo takes what was typed before it takes that back.
  const json before = ui.trace()["document"];
  kind.type(ui, ++value);
  ui.click("menubar/Edit");
  ui.click("menu/edit.undo");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["typing"] == false && t["document"] == before; }, 5));
  ui.click("menubar/Edit");
  ui.click("menu/edit.redo");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return kind.taken(t, value); }, 5));
}

INSTANTIATE_TEST_SUITE_P(All, EveryField, testing::ValuesIn(kinds()), [](const auto& which) {
  std::string name = which.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '\''; }, '_');
  return name;
});

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
