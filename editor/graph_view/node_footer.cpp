#include "editor/graph_view/node_footer.h"

#include <fmt/core.h>

#include <algorithm>
#include <deque>

#include "editor/graph_view/canvas_draw.h"
#include "editor/graph_view/move_gesture.h"
#include "editor/graph_view/node_status.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"

namespace pileus::editor {
namespace {

constexpr float kFooter = 24, kGap = 5, kLine = 15, kIcon = 21, kPad = 7;
constexpr int kMostLines = 3;

struct FooterLook {
  ImU32 ink, back, edge;
  const char* icon;
};
FooterLook lookOf(FooterKind kind) {
  switch (kind) {
    case FooterKind::Failed:
      return {palette::kError, palette::kErrorBack, faded(palette::kError, 0.7f), icon::kError};
    case FooterKind::Follower:
      return {palette::kTextDim, palette::kCanvas, faded(palette::kError, 0.45f), icon::kUnlink};
    case FooterKind::Warning:
      return {palette::kWarning, palette::kWarningBack, 0, icon::kWarning};
    default:
      return {palette::kTextDim, palette::kBar, 0, icon::kClock};
  }
}

/// The message without the node's own name, which stands above it.
std::string_view shortened(const std::string& message, const std::string& node) {
  std::string_view text = message;
  if (!text.starts_with(node)) return text;
  const std::string_view rest = text.substr(node.size());
  if (rest.starts_with(": ")) text.remove_prefix(node.size() + 2);
  if (rest.starts_with(".")) text.remove_prefix(node.size() + 1);
  return text;
}

/// What is wrong; "" = nothing is.
std::string_view faultText(const nodes::NodeStatus& status, const std::string& node) {
  const FooterKind kind = footerKind(status);
  if (kind == FooterKind::Failed) return shortened(status.error.message, node);
  return kind == FooterKind::Warning ? std::string_view(status.warnings.front()) : std::string_view();
}

std::vector<std::string_view> footerLines(const CanvasView& view, const NodePlace& place,
                                          std::string_view text) {
  return linesOf(view.level.text, text, view.px(place.max.x - place.min.x - kIcon - 2 * kPad), kMostLines);
}

float footerHeight(const CanvasView& view, const NodePlace& place, const nodes::NodeStatus& status) {
  const std::string_view fault = faultText(status, place.name);
  if (fault.empty()) return kFooter;
  return kFooter + kLine * static_cast<float>(footerLines(view, place, fault).size() - 1);
}

}  // namespace

FooterKind footerKind(const nodes::NodeStatus& s) {
  using State = nodes::NodeState;
  if (s.state == State::Failed) return FooterKind::Failed;
  if (s.state == State::Skipped) return FooterKind::Follower;
  // Only the node that works says so; those downstream of it merely wait.
  if (s.state == State::Pending && !s.what.empty() && !s.what.starts_with("Waiting for"))
    return FooterKind::Working;
  return !s.warnings.empty() && s.state != State::Idle ? FooterKind::Warning : FooterKind::None;
}

FooterRect footerRect(const CanvasView& view, const NodePlace& place, const nodes::NodeStatus& status) {
  if (footerKind(status) == FooterKind::None || !view.level.text) return {};
  return {glm::round(view.screen({place.min.x, place.max.y + kGap})),
          glm::round(view.screen({place.max.x, place.max.y + kGap + footerHeight(view, place, status)}))};
}

void drawFooter(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  const nodes::NodeStatus& status = *look.status;
  const FooterKind kind = footerKind(status);
  if (kind == FooterKind::None) return;
  const FooterLook ink = lookOf(kind);
  ImDrawList* draw = view.draw;
  if (!view.level.text) {  // a mark that is seen from afar
    if (kind != FooterKind::Failed && kind != FooterKind::Warning) return;
    const vec2 at = view.screen({place.max.x, place.min.y});
    const float r = theme.px(kind == FooterKind::Failed ? 5 : 3.5f);
    draw->AddCircleFilled(im(at), r + theme.scale, palette::kCanvas);
    draw->AddCircleFilled(im(at), r, ink.ink);
    return;
  }
  const FooterRect r = footerRect(view, place, status);
  const float round = view.px(4);
  draw->AddRectFilled(im(r.min), im(r.max),
                      look.hoveredFooter ? mixed(ink.back, palette::kHighlight, 0.08f) : ink.back, round);
  if (ink.edge) draw->AddRect(im(r.min), im(r.max), ink.edge, round, 0, theme.scale);
  ImFont* font = view.level.text;
  float y = r.min.y + (view.px(kFooter) - font->FontSize) * 0.5f;
  float x = r.min.x + view.px(kPad);
  drawText(draw, font, {x, y}, ink.ink, ink.icon, view.px(30));
  x += view.px(kIcon);
  const float room = r.max.x - x - view.px(kPad);
  if (const std::string_view fault = faultText(status, place.name); !fault.empty()) {
    for (const std::string_view line : footerLines(view, place, fault)) {
      drawText(draw, font, {x, y}, ink.ink, line, room + 1);
      y += view.px(kLine);
    }
    return;
  }
  char text[160];
  const auto out =
      kind == FooterKind::Follower
          ? fmt::format_to_n(text, sizeof text, "waits for {}",
                             look.source.empty() ? "another node" : look.source)
          : fmt::format_to_n(text, sizeof text, "{} {:.0f} %", status.what, 100 * status.fraction);
  drawText(draw, font, {x, y}, ink.ink, {text, std::min(out.size, sizeof text)}, room);
}

void drawCosts(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look) {
  const nodes::NodeStatus& s = *look.status;
  if (!view.level.text || s.evaluations == 0 || s.state == nodes::NodeState::Idle) return;
  char text[96];
  char* end = text;
  const auto add = [&](const char* format, auto... args) {
    end = fmt::format_to_n(end, static_cast<std::size_t>(text + sizeof text - end), fmt::runtime(format),
                           args...)
              .out;
    end = std::min(end, text + sizeof text);
  };
  const auto ms = [&](const char* name, double value) {
    if (end != text) add("  ");
    if (value < 9.95)
      add("{} {:.1f}", name, value);
    else
      add("{} {:.0f}", name, value);
  };
  if (s.cpuMs >= 0.05 || s.gpuMs < 0.05) ms("cpu", s.cpuMs);
  if (s.gpuMs >= 0.05) ms("gpu", s.gpuMs);
  add(" ms");
  const double mib = static_cast<double>(s.bytes) / 1048576.0;
  if (mib >= 0.05) add(mib < 9.95 ? "  {:.1f} MiB" : "  {:.0f} MiB", mib);
  const std::string_view shown(text, static_cast<std::size_t>(end - text));
  ImFont* font = view.level.text;
  const bool footer = footerKind(s) != FooterKind::None;
  const float top =
      view.screen(place.max).y + view.px(footer ? 2 * kGap + footerHeight(view, place, s) : kGap);
  const float right = view.screen(place.max).x, left = view.screen(place.min).x;
  const float bar = std::max(2 * theme.scale, std::round(view.px(3)));
  // Its share of all the time, as a bar from the right; then the figures.
  view.draw->AddRectFilled({left, top}, {right, top + bar}, faded(palette::kTrack, 0.6f), bar);
  view.draw->AddRectFilled({right - (right - left) * static_cast<float>(look.share), top}, {right, top + bar},
                           mixed(palette::kAccentDim, palette::kWarning, static_cast<float>(look.share)),
                           bar);
  drawText(view.draw, font, {right - textWidth(font, shown), top + bar + view.px(2)}, palette::kTextDim,
           shown, 1e4f);
}

std::string sourceOfError(const Session& session, const Shown& shown, const Canvas& canvas,
                          const Layout& layout, const std::string& node) {
  const std::vector<nodes::Link>& links = shownGraph(session, canvas).links;
  std::deque<std::string_view> open{node};
  std::set<std::string_view> seen{node};
  for (; !open.empty(); open.pop_front()) {
    if (open.front() != node &&
        statusOf(session, shown, std::string(open.front())).state == nodes::NodeState::Failed)
      return std::string(open.front());
    for (const LinkPlace& l : layout.links) {
      const NodePlace& from = layout.nodes[static_cast<std::size_t>(l.from)];
      if (layout.nodes[static_cast<std::size_t>(l.to)].name == open.front() &&
          !links[static_cast<std::size_t>(l.link)].muted && seen.insert(from.name).second)
        open.push_back(from.name);
    }
  }
  return {};
}

}  // namespace pileus::editor
