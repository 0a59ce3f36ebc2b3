// The window divided among its panels, and layouts that are kept.
#include <gtest/gtest.h>

#include "editor/app/panel_areas.h"
#include "editor/exchange/messages.h"
#include "editor/preferences/settings.h"

namespace pileus::editor {
namespace {

Theme scaled(float scale) {
  Theme theme;
  theme.scale = scale;
  return theme;
}

constexpr Panel kAll[] = {Panel::Viewport, Panel::Graph, Panel::Parameters, Panel::Scope,
                          Panel::Lab,      Panel::Log,   Panel::Timeline,   Panel::Lights};

PanelLayout everything() {
  PanelLayout all;
  all.showScope = all.showLab = all.showLog = all.showTimeline = all.showLights = true;
  return all;
}

TEST(PanelAreas, EverythingFitsAnyWindowWithoutOverlap) {
  for (const vec2 size : {vec2(720, 480), vec2(1280, 720), vec2(1920, 1080), vec2(3840, 2160)})
    for (const float scale : {0.75f, 1.0f, 2.0f, 2.5f}) {
      const PanelAreas a = panelAreas(everything(), Panel::Global, {0, 28}, size, scaled(scale));
      for (const Panel p : kAll) {
        const PanelRect& r = a[p];
        EXPECT_FALSE(r.empty()) << "panel " << static_cast<int>(p) << " at " << size.x << ", scale " << scale;
        EXPECT_GE(r.min.x, 0);
        EXPECT_GE(r.min.y, 28);
        EXPECT_LE(r.max.x, size.x);
        EXPECT_LE(r.max.y, size.y);
        for (const Panel q : kAll)
          if (q > p) {
            const vec2 lo = glm::max(r.min, a[q].min), hi = glm::min(r.max, a[q].max);
            EXPECT_FALSE(lo.x < hi.x && lo.y < hi.y)
                << static_cast<int>(p) << " covers " << static_cast<int>(q);
          }
      }
    }
}

TEST(PanelAreas, UsableSizesWhereTheWindowHasThem) {
  const PanelAreas a = panelAreas({}, Panel::Global, {0, 28}, {1280, 720}, scaled(1));
  EXPECT_EQ(a[Panel::Parameters].max.x - a[Panel::Parameters].min.x, 340);
  EXPECT_GE(a[Panel::Graph].max.y - a[Panel::Graph].min.y, 90);
  EXPECT_TRUE(a[Panel::Log].empty());
  PanelLayout tall;
  tall.logHeight = 800, tall.showLog = true;
  const PanelAreas b = panelAreas(tall, Panel::Global, {0, 28}, {1280, 720}, scaled(1));
  EXPECT_GE(b[Panel::Log].min.y - 28, 190) << "the middle keeps its room";
}

TEST(PanelAreas, HiddenPanelsLeaveTheirRoomAndOneFillsAll) {
  PanelLayout look;
  look.showGraph = look.showParameters = false;
  const PanelAreas a = panelAreas(look, Panel::Global, {0, 0}, {1000, 600}, scaled(1));
  EXPECT_EQ(a[Panel::Viewport].max, vec2(1000, 600));
  EXPECT_TRUE(a.splitters.empty());
  const PanelAreas b = panelAreas(everything(), Panel::Lab, {0, 0}, {1000, 600}, scaled(1));
  EXPECT_EQ(b[Panel::Lab].max, vec2(1000, 600));
  EXPECT_TRUE(b[Panel::Viewport].empty());
}

TEST(PanelAreas, ASplitterMovesItsPanelByAsMuch) {
  for (const float scale : {1.0f, 2.0f}) {
    PanelLayout layout = everything();
    const vec2 size = vec2(1920, 1400) * scale;
    const PanelAreas a = panelAreas(layout, Panel::Global, {0, 0}, size, scaled(scale));
    for (const PanelSplitter& s : a.splitters) {
      PanelLayout moved = layout;
      moved.*s.length += 20 * s.perPixel;
      const PanelAreas b = panelAreas(moved, Panel::Global, {0, 0}, size, scaled(scale));
      for (const PanelSplitter& t : b.splitters)
        if (std::string_view(t.id) == s.id) {
          const float shift = s.vertical ? t.strip.min.x - s.strip.min.x : t.strip.min.y - s.strip.min.y;
          EXPECT_NEAR(shift, 20, 1.01) << s.id;
        }
    }
  }
}

TEST(Layouts, AreKeptInTheSettings) {
  Settings s;
  s.theme = Appearance::Light;
  s.uiScale = 1.25;
  s.showLab = true;
  s.labHeight = 222;
  PanelLayout mine;
  mine.viewportShare = 0.7;
  mine.showParameters = false;
  keepLayout(s.layouts, "Mine", mine);
  keepLayout(s.layouts, "Mine", mine);
  EXPECT_EQ(s.layouts.size(), 1u);
  s.recentCommands = {"file.save"};
  EXPECT_EQ(settingsFromText(settingsText(s)), s);
  EXPECT_EQ(findLayout(s.layouts, "Mine")->panels, mine);
  EXPECT_EQ(findLayout(s.layouts, "Default")->panels, PanelLayout{});
  EXPECT_EQ(findLayout(s.layouts, "no such"), nullptr);
}

TEST(Layouts, DamageNeverHidesEverything) {
  const Settings s = settingsFromText(
      R"({"showViewport": false, "showGraph": false, "theme": "pink", "uiScale": 99, "layouts": {"a": 3, "": {}, "b": {"logHeight": -4}}})");
  EXPECT_TRUE(s.showViewport);
  EXPECT_EQ(s.theme, Appearance::Dark);
  EXPECT_EQ(s.uiScale, 4);
  ASSERT_EQ(s.layouts.size(), 1u);
  EXPECT_EQ(s.layouts[0].panels.logHeight, 90);
}

TEST(Messages, NoticesAreFewAndTheLineIsCalm) {
  log::setPrintLevel(log::Level::Error);
  Messages m;
  EXPECT_LT(m.msLeft(), 0);
  for (int i = 0; i < 6; ++i) m.info("saved " + std::to_string(i));
  EXPECT_EQ(m.notices().size(), Messages::kMost);
  EXPECT_EQ(m.notices().back().text, "saved 5");
  m.info("saved 5");
  EXPECT_EQ(m.notices().size(), Messages::kMost) << "the same again is not two";
  EXPECT_FALSE(m.lineVisible());
  m.hint("That cannot be linked");
  EXPECT_EQ(m.line(), "That cannot be linked");
  EXPECT_EQ(m.text(), "That cannot be linked");
  m.offer("Reset the camera", "Undo", "edit.undo");
  EXPECT_EQ(m.notices().back().command, "edit.undo");
  EXPECT_GT(m.notices().back().lifeMs(), m.notices().front().lifeMs());
  m.dismiss(m.notices().back().id);
  EXPECT_EQ(m.notices().back().command, "");
  EXPECT_GT(m.msLeft(), 0);
}

}  // namespace
}  // namespace pileus::editor
