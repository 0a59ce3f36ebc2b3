#include "editor/viewport/snapshot_strip.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/picture/displayed.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"
#include "editor/viewport/wipe_line.h"

namespace pileus::editor {
namespace {

ImTextureID textureId(unsigned texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

std::string nameOf(const Snapshots& s, int side) {
  return side == Snapshots::kPicture ? "Picture" : s.all[static_cast<std::size_t>(side)].name;
}

void wipeAgainst(Snapshots& s, int right) {
  const bool same = s.wiping && s.right == right;
  if (s.left == right) s.left = Snapshots::kPicture;
  s.right = right;
  s.wiping = !same;
}

void menu(Ui& ui, Session& session, Shown& shown, std::size_t index) {
  Snapshots& s = shown.snapshots;
  const auto i = static_cast<int>(index);
  if (ImGui::MenuItem("Wipe Against the Picture"))
    s.left = Snapshots::kPicture, s.right = i, s.wiping = true, shown.compare.on = false;
  if (ImGui::MenuItem("Put on the Left Side", nullptr, s.wiping && s.left == i)) {
    if (s.right == i) s.right = s.left;
    s.left = i;
    s.wiping = s.right != s.left;
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Restore Graph")) restoreSnapshot(ui.messages, session, shown, index);
  ui.trace.item("still/restore");
  if (ImGui::MenuItem("Delete")) {
    deleteSnapshot(ui.messages, shown, index);
    ImGui::CloseCurrentPopup();
  }
  ui.trace.item("still/delete");
}

/// A small mark in the thumbnail's corner: which side of the wipe it is.
void sideMark(const Theme& theme, vec2 at, const char* side) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float edge = theme.px(16);
  draw->AddRectFilled(im(at), {at.x + edge, at.y + edge}, palette::kAccentDim, theme.px(3));
  drawText(
      draw, theme.small,
      {at.x + 0.5f * (edge - textWidth(theme.small, side)), at.y + 0.5f * (edge - theme.small->FontSize)},
      palette::kTextStrong, side, edge);
}

bool cornerButton(const Theme& theme, const char* id, const char* mark, const char* help, vec2 at) {
  const float edge = theme.px(18);
  ImGui::SetCursorScreenPos(im(at));
  const bool clicked = ImGui::InvisibleButton(id, {edge, edge});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(at), {at.x + edge, at.y + edge}, palette::kChip, theme.px(3));
  drawText(
      draw, theme.small,
      {at.x + 0.5f * (edge - textWidth(theme.small, mark)), at.y + 0.5f * (edge - theme.small->FontSize)},
      hovered ? palette::kTextStrong : palette::kTextDim, mark, edge);
  if (hovered) tooltip(theme, help);
  return clicked;
}

void drawThumbnail(Ui& ui, Session& session, const Clock& clock, Shown& shown, std::size_t index, vec2 at,
                   vec2 size) {
  const Theme& theme = ui.theme;
  Snapshots& s = shown.snapshots;
  const Snapshot snapshot = s.all[index];
  const auto i = static_cast<int>(index);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImGui::PushID(static_cast<int>(snapshot.slot));
  const bool hovered = ImGui::IsMouseHoveringRect(im(at), im(at + size)) && ImGui::IsWindowHovered();
  const unsigned texture = displayTexture(ui.messages, session, clock, shown, snapshot.picture, ivec2(size),
                                          Displayed::kStills + snapshot.slot);
  draw->AddRectFilled(im(at), im(at + size), palette::kPictureEmpty);
  if (texture) draw->AddImage(textureId(texture), im(at), im(at + size));
  const bool side = s.wiping && (s.left == i || s.right == i);
  if (side || hovered)
    draw->AddRect(im(at), im(at + size), side ? palette::kAccent : palette::kTextDim, 0, 0,
                  theme.px(side ? 2 : 1));
  if (side) sideMark(theme, at + vec2(theme.px(3)), s.left == i ? "A" : "B");
  bool onButton = false;
  if (hovered) {
    const vec2 corner(at.x + size.x - theme.px(21), at.y + theme.px(3));
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    onButton = mouse.x >= corner.x - theme.px(21) && mouse.y < corner.y + theme.px(18);
    if (cornerButton(ui.theme, "delete", icon::kTrash, "Delete this still", corner))
      deleteSnapshot(ui.messages, shown, index);
    if (cornerButton(ui.theme, "restore", icon::kHistory, "Restore the graph of this still",
                     corner - vec2(theme.px(21), 0)))
      restoreSnapshot(ui.messages, session, shown, index);
  }
  ImGui::SetCursorScreenPos(im(at));
  if (!onButton) {
    if (ImGui::InvisibleButton("still", im(size))) {
      wipeAgainst(s, i);
      if (s.wiping) shown.compare.on = false;
    }
    if (ImGui::IsItemHovered())
      tooltip(theme, fmt::format("{}, {}\nClick: wipe against it. Right click: more.", snapshot.name,
                                 snapshot.time));
    if (ImGui::BeginPopupContextItem("menu")) {
      menu(ui, session, shown, index);
      ImGui::EndPopup();
    }
  }
  ui.trace.rect(fmt::format("still/{}", index), im(at), im(at + size));
  drawText(draw, theme.small, {at.x, at.y + size.y + theme.px(3)},
           side ? palette::kTextStrong : palette::kTextDim, snapshot.name, size.x);
  ImGui::PopID();
}

void label(const Theme& theme, vec2 lo, vec2 hi, const std::string& text, bool right) {
  const vec2 pad(theme.space(2), theme.px(4));
  const float room = hi.x - lo.x - 2 * theme.space(2) - 2 * pad.x;
  if (room < theme.px(40)) return;
  const vec2 size(std::min(textWidth(theme.small, text), room), theme.small->FontSize);
  const vec2 at(right ? hi.x - theme.space(2) - 2 * pad.x - size.x : lo.x + theme.space(2),
                hi.y - theme.space(2) - size.y - 2 * pad.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(at), im(at + size + 2.0f * pad), palette::kChip, theme.px(4));
  drawText(draw, theme.small, at + pad, palette::kText, text, size.x + 1);
}

}  // namespace

float snapshotStripHeight(const Theme& theme, const Shown& shown) {
  return shown.snapshots.all.empty() ? 0 : theme.px(84);
}

void drawSnapshotStrip(Ui& ui, Session& session, const Clock& clock, Shown& shown, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  const Snapshots& s = shown.snapshots;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(lo), im(hi), palette::kPanel);
  const std::string memory = fmt::format("{} of {}, {:.1f} MiB", s.all.size(), Snapshots::kMost,
                                         static_cast<double>(s.bytes()) / (1 << 20));
  const float width = textWidth(theme.small, memory), right = hi.x - theme.space(3) - width;
  drawText(draw, theme.small, {right, lo.y + theme.px(8)}, palette::kTextDim, memory, width + 1);
  ui.trace.note("stills", memory);
  // Where they do not fit side by side they become narrower, down to what can still be hit.
  const vec2 settings = vec2(glm::max(session.document.graph().settings.size, ivec2(1)));
  const float height = theme.px(54), gap = theme.space(2);
  const auto count = static_cast<float>(s.all.size());
  const float natural = std::round(height * settings.x / settings.y),
              room = right - theme.space(4) - lo.x - theme.space(3);
  const float each =
      std::clamp((room - gap * (count - 1)) / count, theme.px(28), std::min(natural, theme.px(120)));
  const vec2 size(std::floor(each), std::floor(std::min(height, each * settings.y / settings.x)));
  vec2 at(lo.x + theme.space(3), std::round(lo.y + theme.px(7) + 0.5f * (height - size.y)));
  for (std::size_t i = 0; i < s.all.size(); ++i, at.x += size.x + gap)
    drawThumbnail(ui, session, clock, shown, i, at, size);
}

void drawSnapshotWipe(const ViewportRoom& room, vec2 lo, vec2 hi, bool hovered) {
  Snapshots& s = room.shown.snapshots;
  moveWipeLine(room.ui.theme, room.viewport, s.line, lo, hi, hovered);
  const ivec2 size(hi - lo);
  const auto texture = [&](int side, std::size_t slot) {
    return side == Snapshots::kPicture
               ? room.shown.displayed.texture
               : displayTexture(room.ui.messages, room.session, room.clock, room.shown,
                                s.all[static_cast<std::size_t>(side)].picture, size, slot);
  };
  const unsigned left = texture(s.left, 2), right = texture(s.right, 3);
  const auto t = static_cast<float>(s.line.at);
  const float x = glm::mix(lo.x, hi.x, t);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (left) draw->AddImage(textureId(left), im(lo), {x, hi.y}, {0, 0}, {t, 1});
  if (right) draw->AddImage(textureId(right), {x, lo.y}, im(hi), {t, 0}, {1, 1});
  drawWipeLine(room.ui, s.line, lo, hi, "stills/line");
  label(room.ui.theme, lo, {x, hi.y}, "A  " + nameOf(s, s.left), false);
  label(room.ui.theme, {x, lo.y}, hi, "B  " + nameOf(s, s.right), true);
  room.ui.trace.note("stills wipe", nameOf(s, s.left) + " | " + nameOf(s, s.right));
}

}  // namespace pileus::editor
