#include "editor/timeline_view/timeline_rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/time/timeline_edits.h"
#include "editor/timeline_view/timeline_room.h"
#include "editor/timeline_view/timeline_state.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

constexpr float kNames = 190, kRuler = 24, kRow = 22, kReach = 7;  // design pixels

struct Rows {
  const TimelineRoom& room;
  Timeline& t;
  const Theme& theme;
  ImDrawList* draw;
  const std::vector<AnimatedRow>& rows;
  ImVec2 min, max;  ///< of ruler and rows, names included
  float left, top;  ///< of the keys' area
  float row;        ///< height of one

  float x(double frame) const { return static_cast<float>(t.scale.toPixel(frame)); }
  float middle(int r) const { return top + (static_cast<float>(r) + 0.5f) * row - t.scroll; }
  int rowAt(float y) const { return static_cast<int>(std::floor((y - top + t.scroll) / row)); }
  int count() const { return static_cast<int>(rows.size()) + 1; }
};

/// Adding 0 makes -0 a 0.
std::string frameText(double frame) { return fmt::format("{:g}", frame + 0.0); }

/// Half the width of the playhead's number.
float playheadHalf(const Rows& r) {
  return 0.5f * textWidth(r.theme.small, std::to_string(r.room.clock.frame)) + r.theme.px(4);
}

void drawBackground(const Rows& r) {
  const nodes::Settings& s = r.room.session.document.root().settings;
  r.draw->AddRectFilled({r.left, r.min.y}, r.max, palette::kField);
  // The range is lighter than what lies outside of it.
  const float from = std::clamp(r.x(s.frames.x), r.left, r.max.x),
              to = std::clamp(r.x(s.frames.y), r.left, r.max.x);
  if (to > from) r.draw->AddRectFilled({from, r.min.y}, {to, r.max.y}, palette::kBar);
  const double step = tickStep(r.t.scale.perFrame(), static_cast<double>(r.theme.px(64)));
  const double fine = tickStep(r.t.scale.perFrame(), static_cast<double>(r.theme.px(9)));
  for (double f = std::ceil(r.t.scale.first / fine) * fine; f <= r.t.scale.last; f += fine)
    r.draw->AddLine({r.x(f), r.top - r.theme.px(4)}, {r.x(f), r.top}, palette::kLine);
  for (double f = std::ceil(r.t.scale.first / step) * step; f <= r.t.scale.last; f += step) {
    r.draw->AddLine({r.x(f), r.top - r.theme.px(8)}, {r.x(f), r.max.y}, palette::kLine);
    // Where the playhead has its own number there is no room for another.
    const float left = r.x(f) + r.theme.px(3), head = r.x(r.room.clock.frame), half = playheadHalf(r);
    if (left < head + half && left + textWidth(r.theme.small, frameText(f)) > head - half) continue;
    drawText(r.draw, r.theme.small, {left, r.min.y + r.theme.px(2)}, palette::kTextDim, frameText(f),
             r.theme.px(60));
  }
  r.draw->AddLine({r.min.x, r.top}, {r.max.x, r.top}, palette::kLine);
}

void drawKey(const Rows& r, double frame, int row, bool selected, nodes::Interpolation how) {
  const float size = r.theme.px(5), x = r.x(frame), y = r.middle(row);
  const ImU32 ink = selected ? palette::kSelect : row == 0 ? palette::kTextDim : palette::kText;
  if (how == nodes::Interpolation::Constant)
    r.draw->AddRectFilled({x - 0.8f * size, y - 0.8f * size}, {x + 0.8f * size, y + 0.8f * size}, ink);
  else if (how == nodes::Interpolation::Linear || row == 0)
    r.draw->AddQuadFilled({x, y - size}, {x + size, y}, {x, y + size}, {x - size, y}, ink);
  else
    r.draw->AddCircleFilled({x, y}, 0.9f * size, ink);
}

void drawNames(const Rows& r) {
  r.draw->PushClipRect({r.min.x, r.top}, r.max, true);
  for (int i = 0; i < r.count(); ++i) {
    const float y = r.middle(i);
    if (y < r.top - r.row || y > r.max.y + r.row) continue;
    if (i % 2)
      r.draw->AddRectFilled({r.min.x, y - 0.5f * r.row}, {r.max.x, y + 0.5f * r.row}, palette::kRowAlt);
    const std::string_view name =
        i == 0 ? std::string_view("All keys") : r.rows[static_cast<std::size_t>(i - 1)].title;
    if (i > 0) r.room.ui.trace.note(fmt::format("timeline row {}", i), std::string(name));
    drawText(r.draw, r.theme.small, {r.min.x + r.theme.space(3), y - 0.5f * r.theme.small->FontSize},
             i == 0 ? palette::kTextDim : palette::kText, name, r.left - r.min.x - r.theme.space(5));
  }
  r.draw->PopClipRect();
}

void drawKeys(const Rows& r) {
  r.draw->PushClipRect({r.left, r.top}, r.max, true);
  for (int i = 1; i < r.count(); ++i) {
    const AnimatedRow& row = r.rows[static_cast<std::size_t>(i - 1)];
    if (row.keys.size() > 1)
      r.draw->AddLine({r.x(row.keys.front().frame), r.middle(i)}, {r.x(row.keys.back().frame), r.middle(i)},
                      palette::kAccentDim, r.theme.px(2));
    for (const nodes::AnimationKey& k : row.keys) {
      const bool selected = !r.room.clock.keys.selected.empty() &&
                            r.room.clock.keys.selected.contains({row.node, row.param, k.frame});
      drawKey(r, k.frame, 0, selected, nodes::Interpolation::Linear);
      drawKey(r, k.frame, i, selected, k.interpolation);
      if (!r.room.ui.trace.on()) continue;
      const float size = r.theme.px(5);
      r.room.ui.trace.rect(fmt::format("key/{}.{}/{:g}", row.node, row.param, k.frame),
                           {r.x(k.frame) - size, r.middle(i) - size},
                           {r.x(k.frame) + size, r.middle(i) + size});
    }
  }
  r.draw->PopClipRect();
}

void drawPlayhead(const Rows& r) {
  const float x = std::round(r.x(r.room.clock.frame));
  const std::string text = std::to_string(r.room.clock.frame);
  const float half = playheadHalf(r);
  r.draw->PushClipRect({r.left, r.min.y}, r.max, true);
  r.draw->AddLine({x, r.min.y}, {x, r.max.y}, palette::kAccent, r.theme.px(1.5f));
  const ImVec2 lo{x - half, r.min.y + r.theme.px(1)}, hi{x + half, r.top - r.theme.px(5)};
  r.draw->AddRectFilled(lo, hi, palette::kAccentDim, r.theme.px(3));
  drawText(r.draw, r.theme.small, {x - half + r.theme.px(4), 0.5f * (lo.y + hi.y - r.theme.small->FontSize)},
           palette::kTextStrong, text, 2 * half);
  r.draw->PopClipRect();
  r.room.ui.trace.rect("timeline/playhead", lo, hi);
}

void scaleGestures(const Rows& r) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0)
    r.t.scale.zoom(static_cast<double>(io.MousePos.x), std::pow(0.85, static_cast<double>(io.MouseWheel)));
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(2)) r.t.scale.pan(static_cast<double>(io.MouseDelta.x));
}

void ruler(const Rows& r) {
  ImGui::SetCursorScreenPos({r.left, r.min.y});
  ImGui::InvisibleButton("timeline/ruler", {r.max.x - r.left, r.top - r.min.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  r.room.ui.trace.item("timeline/ruler");
  scaleGestures(r);
  if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(0)) return;
  r.room.shown.preview.touch();
  const double frame = r.t.scale.toFrame(static_cast<double>(ImGui::GetIO().MousePos.x));
  goToFrame(r.room.clock, static_cast<int>(std::lround(std::clamp(frame, -1e6, 1e6))));
}

KeySelection pick(const Rows& r, ImVec2 at) {
  const int row = r.rowAt(at.y);
  if (row < 0 || row >= r.count()) return {};
  return keysAt(r.rows, row, r.t.scale.toFrame(static_cast<double>(at.x)),
                static_cast<double>(r.theme.px(kReach)) / r.t.scale.perFrame());
}

/// A click on keys selects them, unless they are part of what is selected; Shift adds and takes away.
void selectPicked(const Rows& r, const KeySelection& picked, bool shift) {
  KeySelection& selected = r.room.clock.keys.selected;
  const bool all = std::includes(selected.begin(), selected.end(), picked.begin(), picked.end());
  if (shift && all)
    for (const KeyRef& k : picked) selected.erase(k);
  else if (shift)
    selected.insert(picked.begin(), picked.end());
  else if (!all || picked.empty())
    selected = picked;
}

void beginDrag(const Rows& r) {
  const ImGuiIO& io = ImGui::GetIO();
  const KeySelection picked = pick(r, io.MousePos);
  if (!picked.empty() || !io.KeyShift) selectPicked(r, picked, io.KeyShift);
  r.t.fromX = static_cast<double>(io.MousePos.x), r.t.fromY = static_cast<double>(io.MousePos.y);
  r.t.moved = false;
  r.t.drag = picked.empty() ? Timeline::Drag::Box : Timeline::Drag::Keys;
  if (!picked.empty()) beginKeyMove(r.room.session, r.room.clock);
}

/// Esc: as if it had not begun.
void cancelDrag(const Rows& r) {
  if (r.t.drag == Timeline::Drag::Keys) {
    if (moveSelectedKeys(r.room.ui.messages, r.room.session, r.room.clock, 0)) r.room.shown.preview.touch();
    endKeyMove(r.room.session, r.room.clock);
  }
  r.t.drag = Timeline::Drag::None;
}

void drag(const Rows& r) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return cancelDrag(r);
  const double dx = static_cast<double>(io.MousePos.x) - r.t.fromX,
               dy = static_cast<double>(io.MousePos.y) - r.t.fromY;
  if (!r.t.moved && std::max(std::abs(dx), std::abs(dy)) < static_cast<double>(r.theme.px(3))) return;
  r.t.moved = true;
  if (r.t.drag == Timeline::Drag::Keys) {
    const double frames = dx / r.t.scale.perFrame();
    if (moveSelectedKeys(r.room.ui.messages, r.room.session, r.room.clock,
                         io.KeyCtrl ? std::round(frames * 10) / 10 : std::round(frames)))
      r.room.shown.preview.touch();
    return;
  }
  r.draw->AddRectFilled({static_cast<float>(r.t.fromX), static_cast<float>(r.t.fromY)}, io.MousePos,
                        faded(palette::kAccent, 0.15f));
  r.draw->AddRect({static_cast<float>(r.t.fromX), static_cast<float>(r.t.fromY)}, io.MousePos,
                  palette::kAccent);
}

void endDrag(const Rows& r) {
  const ImGuiIO& io = ImGui::GetIO();
  if (r.t.drag == Timeline::Drag::Keys) endKeyMove(r.room.session, r.room.clock);
  if (r.t.drag == Timeline::Drag::Box && r.t.moved) {
    const KeySelection box =
        keysInBox(r.rows, r.rowAt(static_cast<float>(r.t.fromY)), r.rowAt(io.MousePos.y),
                  r.t.scale.toFrame(r.t.fromX), r.t.scale.toFrame(static_cast<double>(io.MousePos.x)));
    if (!io.KeyShift) r.room.clock.keys.selected.clear();
    r.room.clock.keys.selected.insert(box.begin(), box.end());
  }
  r.t.drag = Timeline::Drag::None;
}

void contextMenu(const Rows& r) {
  if (!ImGui::BeginPopup("timeline keys")) return;
  for (const auto& item : enumInfo(static_cast<nodes::Interpolation*>(nullptr))) {
    if (ImGui::MenuItem(item.label.data()))
      interpolateSelectedKeys(r.room.ui.messages, r.room.session, r.room.clock, item.value);
    r.room.ui.trace.item("timeline/menu/" + std::string(item.id));
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Go to Key") && !r.room.clock.keys.selected.empty())
    goToFrame(r.room.clock, static_cast<int>(std::lround(r.room.clock.keys.selected.begin()->frame)));
  r.room.ui.trace.item("timeline/menu/go");
  ImGui::Separator();
  for (const char* id : {"timeline.cut", "timeline.copy", "timeline.paste", "timeline.delete"})
    commandMenuItem(r.room.ui, id);
  ImGui::EndPopup();
}

void keyGestures(const Rows& r) {
  if (r.max.y - r.top < 1) return;
  ImGui::SetCursorScreenPos({r.left, r.top});
  ImGui::InvisibleButton("timeline/keys", {r.max.x - r.left, r.max.y - r.top},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  r.room.ui.trace.item("timeline/keys");
  scaleGestures(r);
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(0)) beginDrag(r);
  if (r.t.drag != Timeline::Drag::None) ImGui::IsMouseDown(0) ? drag(r) : endDrag(r);
  if (hovered && ImGui::IsMouseReleased(1)) {
    if (const KeySelection picked = pick(r, ImGui::GetIO().MousePos); !picked.empty()) {
      selectPicked(r, picked, false);
      ImGui::OpenPopup("timeline keys");
    }
  }
  contextMenu(r);
}

/// What is gone is not selected.
void checkSelection(const Rows& r) {
  if (r.t.drag != Timeline::Drag::None) return;
  std::erase_if(r.room.clock.keys.selected, [&](const KeyRef& ref) {
    return std::none_of(r.rows.begin(), r.rows.end(), [&](const AnimatedRow& row) {
      return row.node == ref.node && row.param == ref.param &&
             std::any_of(row.keys.begin(), row.keys.end(),
                         [&](const nodes::AnimationKey& k) { return k.frame == ref.frame; });
    });
  });
}

void scrollRows(const Rows& r) {
  const float most = std::max(static_cast<float>(r.count()) * r.row - (r.max.y - r.top), 0.0f);
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect({r.min.x, r.top}, {r.left, r.max.y}))
    r.t.scroll -= ImGui::GetIO().MouseWheel * 2 * r.row;
  r.t.scroll = std::clamp(r.t.scroll, 0.0f, most);
}

}  // namespace

void drawTimelineRows(const TimelineRoom& room, ImVec2 min, ImVec2 max) {
  const Theme& theme = room.ui.theme;
  Timeline& t = room.timeline;
  const float left = min.x + std::min(theme.px(kNames), 0.35f * (max.x - min.x));
  if (!t.fitted) t.scale.fit(room.session.document.root().settings.frames), t.fitted = true;
  t.scale.left = static_cast<double>(left);
  t.scale.right = std::max(static_cast<double>(max.x), t.scale.left + 1);
  Rows r{room, t,   theme, ImGui::GetWindowDrawList(), shownRows(room.clock.keys.rows, room.session.document),
         min,  max, left,  min.y + theme.px(kRuler),   theme.px(kRow)};
  checkSelection(r);
  scrollRows(r);
  r.draw->PushClipRect(min, max, true);
  drawBackground(r);
  drawPlayhead(r);  // below the keys, so that those at this frame are seen
  if (!r.rows.empty())
    drawNames(r), drawKeys(r);
  else
    drawText(r.draw, theme.small, {left + theme.space(4), r.top + theme.space(3)}, palette::kTextDim,
             room.session.document.selection().empty()
                 ? "Nothing is animated yet. Press I over a parameter to set a key at this frame."
                 : "The selection is not animated. Press I over a parameter to set a key at this frame.",
             max.x - left - theme.space(6));
  ruler(r);
  keyGestures(r);
  r.draw->PopClipRect();
}

}  // namespace pileus::editor
