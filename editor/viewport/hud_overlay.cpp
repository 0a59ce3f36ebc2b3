#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/corner_widgets.h"
#include "editor/viewport/picture_overlays.h"
#include "editor/viewport/viewport_room.h"
#include "renderer/view/render_scene.h"

namespace pileus::editor {
namespace {

std::string ms(double value) {
  return value < 99.95    ? fmt::format("{:.1f} ms", value)
         : value < 9999.5 ? fmt::format("{:.0f} ms", value)
                          : fmt::format("{:.1f} s", value / 1000);
}

std::string mib(std::size_t bytes) {
  return fmt::format("{:.0f} MiB", static_cast<double>(bytes) / (1 << 20));
}

/// Of the evaluation that is shown: what makes pictures, and all that comes before.
std::pair<double, double> mapsAndPicture(const Session& session, const Shown& shown) {
  double maps = 0, picture = 0;
  for (const auto& [name, node] : session.document.root().nodes) {
    const nodes::NodeType* type = nodes::findNodeType(node->type);
    const nodes::NodeStatus& status = shown.preview.evaluator().status(name);
    if (!type || status.state == nodes::NodeState::Idle) continue;
    if (type->uses & nodes::UsesLayers)
      picture += status.cpuMs;
    else if (type->uses & nodes::UsesQuality)
      maps += status.cpuMs;
  }
  return {maps, picture};
}

/// "; 20,123 MiB free" where the driver tells.
std::string freeText() {
  static const bool tells = epoxy_has_gl_extension("GL_NVX_gpu_memory_info");
  if (!tells) return {};
  GLint kib = 0;
  glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &kib);
  return fmt::format(", {} MiB free", kib / 1024);
}

std::size_t pictureBytes(const Shown& shown) {
  std::size_t sum = shown.snapshots.bytes();
  if (const auto& p = shown.preview.picture()) sum += p->color.bytes();
  return sum;
}

std::vector<std::pair<std::string, std::string>> rowsOf(const ViewportRoom& room) {
  std::vector<std::pair<std::string, std::string>> rows;
  const auto [maps, picture] = mapsAndPicture(room.session, room.shown);
  const bool draft = room.shown.preview.draft();
  rows.emplace_back(draft ? "This draft" : "Final", fmt::format("maps {}, render {}", ms(maps), ms(picture)));
  if (const DraftTimes& t = room.shown.preview.draftTimes(); t.total > 0)
    rows.emplace_back("Last draft", fmt::format("{} of {:.0f}: maps {}, render {}", ms(t.total),
                                                room.settings.draftMs, ms(t.maps), ms(t.picture)));
  const DraftPace& pace = room.shown.preview.pace();
  const ivec2 size = room.shown.renderSize;
  const double by =
      std::max(1.0, std::sqrt(static_cast<double>(size.x) * size.y / std::max(pace.pixels(), 1)));
  rows.emplace_back("Draft scale", fmt::format("1 : {:.1f}, {} pixels, maps {} texels", by,
                                               std::min(pace.pixels(), size.x * size.y), pace.texels()));
  rows.emplace_back("Display",
                    fmt::format("{}, frame {}", ms(room.shown.displayed.ms), ms(room.ui.now.frameMs)));
  if (const auto& p = room.shown.preview.picture()) {
    const int all = p->scene ? p->scene->options.samples : p->samples;
    rows.emplace_back("Picture",
                      fmt::format("{} \xc3\x97 {}, {} of {} samples", p->size.x, p->size.y, p->samples, all));
    if (p->scene)
      rows.emplace_back("Scene", fmt::format("{} lights, {} volumes, {} solids", p->scene->lights.size(),
                                             p->scene->volumes.size(), p->scene->solids.size()));
  }
  view::Renderer& r = room.shown.renderer;
  rows.emplace_back("Bricks", fmt::format("{} resident, {} of {}", r.bricks().residentBricks(),
                                          mib(r.bricks().bytes()), mib(r.bricks().budget())));
  rows.emplace_back("Memory", fmt::format("maps {}, pictures {}, budget {}{}", mib(r.shadows().bytes()),
                                          mib(pictureBytes(room.shown)), mib(r.gpuMemory()), freeText()));
  return rows;
}

}  // namespace

void drawHud(const ViewportRoom& room, vec2 lo, vec2 hi, float below) {
  const Theme& theme = room.ui.theme;
  const auto rows = rowsOf(room);
  const float line = theme.px(19), head = theme.px(84);
  float widest = 0;
  for (const auto& [name, text] : rows) widest = std::max(widest, textWidth(theme.mono, text));
  const vec2 pad(theme.space(2), theme.px(6));
  const float left = lo.x + toolStripWidth(room.ui.theme, lo, hi) + theme.space(2);
  const vec2 a(left, below), size(std::min(head + widest + 2 * pad.x, hi.x - left - theme.space(2)),
                                  line * static_cast<float>(rows.size()) + 2 * pad.y);
  if (size.x < theme.px(160)) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(a), im(a + size), palette::kChip, theme.px(4));
  vec2 at = a + pad;
  for (const auto& [name, text] : rows) {
    drawText(draw, theme.small, {at.x, at.y + 0.5f * (line - theme.small->FontSize)}, palette::kTextDim, name,
             head);
    drawText(draw, theme.mono, {at.x + head, at.y + 0.5f * (line - theme.mono->FontSize)}, palette::kText,
             text, size.x - 2 * pad.x - head);
    room.ui.trace.note("hud " + name, text);
    at.y += line;
  }
  room.ui.trace.rect("hud", im(a), im(a + size));
}

}  // namespace pileus::editor
