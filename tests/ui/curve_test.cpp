// Curves and ramps in the parameter panel, in a real window: points and stops are added, dragged, typed and
// removed; the histogram of what comes in lies behind them.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [320, 180] },
  "nodes": {
    "Cloud": { "type": "volume.cloud", "at": [0, 0], "params": { "resolution": 48 } },
    "Medium": { "type": "volume.medium", "at": [200, 0] },
    "Remap": { "type": "volume.remap", "at": [400, 0] },
    "Sun": { "type": "light.sun", "at": [400, 220] },
    "Shadow": { "type": "shadow.ray_march", "at": [600, 160], "params": { "step_scale": 2 } },
    "Render": { "type": "render.volume", "at": [800, 0], "params": { "samples": 1, "step_scale": 2 } },
    "View": { "type": "output.view", "at": [1000, 0] }
  },
  "links": [
    "Cloud.volume -> Medium.volume", "Medium.volume -> Remap.volume", "Remap.volume -> Shadow.volumes",
    "Sun.light -> Shadow.light", "Remap.volume -> Render.volumes", "Shadow.light -> Render.lights",
    "Render.image -> View.image"
  ]
}
)";

class Curves : public testing::Test {
 protected:
  Curves() : file_(scratchFolder() / "remap.json") { std::ofstream(file_) << kGraph; }

  void start(const json& settings = json::object()) {
    session_ =
        std::make_unique<UiSession>(ivec2(1440, 900), std::vector<std::string>{file_.string()}, settings);
    ASSERT_TRUE(ui().running()) << ui().log();
    ui().click("header/Remap");
    ASSERT_TRUE(ui().waitRect("curve/curve"));
    ASSERT_TRUE(ui().waitFor([](const json& t) { return t["notes"].contains("histogram/curve"); }, 60));
  }
  const UiSession& ui() const { return *session_; }

  json param(const std::string& id) const {
    const json t = ui().trace();
    const json& params = t["document"]["nodes"]["Remap"]["params"];
    return params.contains(id) ? params[id] : json();
  }
  bool becomes(const std::string& id, const std::function<bool(const json&)>& condition) const {
    return ui().waitFor([&](const json&) { return condition(param(id)); }, 8);
  }
  bool hasPoints(const std::string& id, std::size_t count) const {
    return becomes(id, [count](const json& v) { return v.size() == count + 1; });
  }
  /// A point of the graph: 0 .. 1 along both axes.
  Point inGraph(double x, double y) const {
    const json r = ui().trace()["rects"]["curve/curve"];
    const double lo = r[0].get<double>() + 7, hi = r[2].get<double>() - 7;
    const double top = r[1].get<double>() + 7, bottom = r[3].get<double>() - 7;
    return {lo + x * (hi - lo), bottom + y * (top - bottom)};
  }
  /// Between two pictures a press is seen where the pointer is, not where it will be.
  void idle() const {
    EXPECT_TRUE(ui().waitFor([](const json& t) { return t["complete"] == true; }, 60));
  }
  void drag(Point from, Point to, const std::vector<std::string>& held = {}) const {
    idle();
    ui().drag(from, to, held);
  }
  void doubleClick(Point p) const {
    idle();
    ui().doubleClick(p);
  }

  std::filesystem::path file_;
  std::unique_ptr<UiSession> session_;
};

TEST_F(Curves, PointsAreAddedDraggedTypedAndRemoved) {
  start();
  EXPECT_TRUE(ui().trace()["notes"].value("range/curve", "").starts_with("0 .. 0.0"))
      << ui().trace()["notes"].value("range/curve", "");
  doubleClick(inGraph(0.3, 0.7));
  ASSERT_TRUE(hasPoints("curve", 3));
  const json added = param("curve");
  EXPECT_NEAR(added[2][0].get<double>(), 0.3, 0.01);
  EXPECT_NEAR(added[2][1].get<double>(), 0.7, 0.02);
  EXPECT_EQ(ui().trace()["undo"], "Set Remap.curve");

  // A drag is one step; Ctrl snaps.
  drag(ui().center("point/curve/1"), inGraph(0.52, 0.23));
  ASSERT_TRUE(becomes("curve", [](const json& v) { return v[2][1].get<double>() < 0.3; })) << param("curve");
  EXPECT_NEAR(param("curve")[2][0].get<double>(), 0.52, 0.02);
  ui().key("ctrl+z");
  EXPECT_TRUE(becomes("curve", [&](const json& v) { return v == added; })) << param("curve");
  drag(ui().center("point/curve/1"), inGraph(0.52, 0.23), {"ctrl"});
  EXPECT_TRUE(becomes("curve", [](const json& v) { return v[2] == json{0.5, 0.25}; })) << param("curve");

  // Esc takes a drag back.
  const Point from = ui().center("point/curve/1");
  idle();
  ui().press(from);
  ui().dragTo(from, inGraph(0.8, 0.8));
  EXPECT_TRUE(becomes("curve", [](const json& v) { return v[2][0].get<double>() > 0.7; }));
  ui().key("Escape");
  ui().release();
  EXPECT_TRUE(becomes("curve", [](const json& v) { return v[2] == json{0.5, 0.25}; })) << param("curve");

  // The selected point's numbers.
  idle();
  ui().click("point/curve/1");
  ui().click(ui().center("point/out"), {"ctrl"});
  ui().type("0.6");
  ui().key("Return");
  EXPECT_TRUE(becomes("curve", [](const json& v) { return v[2] == json{0.5, 0.6}; })) << param("curve");
  ui().screenshot("curve-01-dark");

  // A click on the line adds as well; right click and Delete remove, and no menu opens.
  idle();
  ui().click(inGraph(0.75, 0.81));
  ASSERT_TRUE(hasPoints("curve", 4)) << param("curve");
  ui().key("Delete");
  EXPECT_TRUE(hasPoints("curve", 3)) << param("curve");
  EXPECT_TRUE(ui().trace()["document"]["nodes"].contains("Remap"));
  idle();
  ui().click("point/curve/1", 3);
  EXPECT_TRUE(becomes("curve", [](const json& v) { return v.is_null(); }))
      << "the default again: " << param("curve");
  EXPECT_FALSE(ui().trace()["rects"].contains("row menu/reset"));
  EXPECT_TRUE(ui().log().empty()) << ui().log();
}

TEST_F(Curves, PresetsShapesAndReset) {
  start();
  for (const auto& [preset, points] :
       {std::pair("threshold", 4), std::pair("invert", 2), std::pair("contrast", 5)}) {
    ui().click("presets/curve");
    ui().click(std::string("preset/") + preset);
    EXPECT_TRUE(hasPoints("curve", static_cast<std::size_t>(points))) << preset << param("curve");
  }
  ui().click("shape/curve");
  ui().click("choice/linear");
  EXPECT_TRUE(becomes("curve", [](const json& v) { return v[0] == "linear"; }));
  ui().move(inGraph(0.5, 0.9));
  ASSERT_TRUE(
      ui().waitFor([](const json& t) { return t["notes"].value("hovered param", "") == "Remap.curve"; }));
  ui().key("BackSpace");
  EXPECT_TRUE(becomes("curve", [](const json& v) { return v.is_null(); }));
  EXPECT_FALSE(ui().trace()["rects"].contains("expose/curve"));
  EXPECT_FALSE(ui().trace()["rects"].contains("key/curve"));
}

TEST_F(Curves, StopsOfARamp) {
  start({{"theme", "light"}});
  ASSERT_TRUE(ui().waitRect("ramp/color"));
  // A double click on a stop opens its colour.
  doubleClick(ui().center("stop/color/0"));
  ASSERT_TRUE(ui().waitRect("picker/g"));
  const auto typed = [&](const std::string& field, const std::string& text) {
    ui().click(ui().center(field), {"ctrl"});
    ui().type(text);
    ui().key("Return");
  };
  typed("picker/g", "0.4");
  EXPECT_TRUE(becomes("color", [](const json& v) {
    return v.is_array() && v[1] == json{0, 1, 0.4, 1};
  })) << param("color");
  typed("picker/b", "0.1");
  EXPECT_TRUE(becomes("color", [](const json& v) { return v[1] == json{0, 1, 0.4, 0.1}; })) << param("color");
  ui().screenshot("curve-02-picker");
  ui().key("Escape");
  EXPECT_TRUE(ui().waitFor([](const json& t) { return !t["rects"].contains("picker"); }));

  // Another one in the middle has the colour that was there; a drag is one step.
  const json r = ui().trace()["rects"]["ramp/color"];
  const double lo = r[0].get<double>() + 7, width = r[2].get<double>() - 7 - lo, y = r[1].get<double>() + 54;
  doubleClick({lo + 0.5 * width, y});
  ASSERT_TRUE(hasPoints("color", 3)) << param("color");
  const json added = param("color");
  EXPECT_NEAR(added[2][2].get<double>(), 0.7, 0.01);
  const Point stop = ui().center("stop/color/1");
  drag(stop, {lo + 0.8 * width, stop.y});
  EXPECT_TRUE(becomes("color", [](const json& v) { return std::abs(v[2][0].get<double>() - 0.8) < 0.02; }))
      << param("color");
  ui().screenshot("curve-03-light");
  ui().key("ctrl+z");
  EXPECT_TRUE(becomes("color", [&](const json& v) { return v == added; })) << param("color");
  idle();
  ui().click("stop/color/1", 3);
  EXPECT_TRUE(hasPoints("color", 2)) << param("color");
  EXPECT_EQ(ui().trace()["undo"], "Set Remap.color");
}

}  // namespace
}  // namespace pileus::test
