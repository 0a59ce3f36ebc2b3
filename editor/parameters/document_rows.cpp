#include "editor/parameters/document_rows.h"

#include <fmt/core.h>

#include "editor/document/session.h"
#include "editor/parameters/param_row.h"
#include "editor/parameters/param_widgets.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/parameters/variation_rows.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using Apply = void (*)(nodes::Settings&, double);

void edit(Session& session, Shown& shown, const nodes::Settings& settings, const std::string& label,
          const std::string& mergeKey) {
  nodes::Graph graph = session.document.graph();
  graph.settings = settings;
  session.document.edit(std::move(graph), label, mergeKey);
  shown.preview.touch();
}

void rowHelp(const Theme& theme, const Parameters& parameters, const RowFrame& f, const char* help) {
  const float right = f.at.x + f.widget;
  if (parameters.rest.short_ && ImGui::IsWindowHovered() && !ImGui::IsAnyItemActive() &&
      ImGui::IsMouseHoveringRect(f.at, {right, f.at.y + f.height}))
    tooltip(theme, help);
}

void number(Ui& ui, Session& session, Shown& shown, Parameters& parameters, const char* id, const char* label,
            const char* help, double value, double fallback, const NumberField& field, Apply apply) {
  Parameters& panel = parameters;
  ImGui::PushID(id);
  const RowFrame f = rowFrame(ui.theme, false);
  const bool reset = value != fallback && modifiedDot(ui, id, "Changed; click to reset", f);
  rowLabel(ui.theme, f, label, value != fallback);
  toWidget(f);
  const NumberEdit n = numberField(ui.fields.number, ui.theme, id, value, field, f.width);
  ui.trace.item(std::string("setting/") + id);
  const std::string merge = std::string("setting ") + id, step = std::string("Set ") + label;
  nodes::Settings settings = session.document.graph().settings;
  if (n.dragging && !panel.settingsBefore) panel.settingsBefore = settings;
  if (n.changed) {
    apply(settings, value);
    edit(session, shown, settings, step, n.dragging ? merge : "");
  }
  if (n.cancelled && panel.settingsBefore) edit(session, shown, *panel.settingsBefore, step, merge);
  if (n.finished) panel.settingsBefore.reset(), session.document.endMerge();
  if (n.refused) panel.refusedKey = merge, panel.refusedAt = ImGui::GetTime();
  if ((n.changed || n.finished) && !n.refused && panel.refusedKey == merge) panel.refusedKey.clear();
  if (reset) {
    apply(settings, fallback);
    edit(session, shown, settings, std::string("Reset ") + label, "");
  }
  rowHelp(ui.theme, parameters, f, help);
  drawRefusal(ui, parameters, merge);
  ImGui::PopID();
}

NumberField field(double softMin, double softMax, double hardMin, double hardMax, bool integer,
                  const char* unit) {
  NumberField f;
  f.softMin = softMin, f.softMax = softMax, f.hardMin = hardMin, f.hardMax = hardMax;
  f.integer = integer;
  f.unit = unit;
  return f;
}

void setColours(Session& session, Shown& shown, const std::string& path) {
  nodes::Settings settings = session.document.graph().settings;
  settings.ocio = path;
  edit(session, shown, settings, "Set colour configuration", "");
}

void colourFile(const ParameterRoom& room) {
  const std::string current = room.session.document.graph().settings.ocio;
  const std::vector<std::string> kinds = {"ocio"};
  ImGui::PushID("ocio");
  const RowFrame f = rowFrame(room.ui.theme, false);
  if (!current.empty() && modifiedDot(room.ui, "ocio", "Changed; click to reset", f))
    setColours(room.session, room.shown, "");
  rowLabel(room.ui.theme, f, "Colour config", !current.empty());
  toWidget(f);
  std::string text = current;
  const float button = ImGui::GetFrameHeight() + room.ui.theme.px(2);
  if (textField(room.session, room.parameters, "setting.ocio", text, f.width - button, "$OCIO, or shipped",
                &kinds))
    setColours(room.session, room.shown, expandedHome(text));
  room.ui.trace.item("setting/ocio");
  ImGui::SameLine(0, room.ui.theme.px(2));
  ImGui::PushStyleColor(ImGuiCol_Button, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  if (ImGui::Button(icon::kFolderOpen, {button - room.ui.theme.px(2), 0})) {
    BrowserRequest request;
    request.title = "Colour configuration";
    request.button = "Choose";
    request.kinds = kinds;
    request.start = absoluteFile(room.session, current);
    request.done = [room](const std::filesystem::path& path) {
      setColours(room.session, room.shown, path.string());
    };
    room.ui.modals.browser.open(room.settings, std::move(request));
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  room.ui.trace.item("browse/setting ocio");
  rowHelp(room.ui.theme, room.parameters, f,
          "The OpenColorIO file whose displays and views pictures are shown with.");
  ImGui::PopID();
}

void note(const Theme& theme, const std::string& text) {
  ImGui::PushFont(theme.small);
  ImGui::PushTextWrapPos();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextFaint);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

}  // namespace

void drawDocumentRows(const ParameterRoom& room) {
  const nodes::Settings s = room.session.document.graph().settings;
  const nodes::Settings plain;
  const NumberField pixels = field(64, 4096, 1, 65536, true, "px"), frames = field(0, 0, -1e6, 1e6, true, "");
  number(room.ui, room.session, room.shown, room.parameters, "width", "Picture width",
         "Pixels of what is rendered to files.", s.size.x, plain.size.x, pixels,
         [](nodes::Settings& t, double v) { t.size.x = static_cast<int>(v); });
  number(room.ui, room.session, room.shown, room.parameters, "height", "Picture height",
         "Pixels of what is rendered to files.", s.size.y, plain.size.y, pixels,
         [](nodes::Settings& t, double v) { t.size.y = static_cast<int>(v); });
  number(room.ui, room.session, room.shown, room.parameters, "first", "First frame",
         "Where the animation begins.", s.frames.x, plain.frames.x, frames, [](nodes::Settings& t, double v) {
           t.frames.x = static_cast<int>(v);
           t.frames.y = std::max(t.frames.y, t.frames.x);
         });
  number(room.ui, room.session, room.shown, room.parameters, "last", "Last frame",
         "Where the animation ends.", s.frames.y, plain.frames.y, frames, [](nodes::Settings& t, double v) {
           t.frames.y = static_cast<int>(v);
           t.frames.x = std::min(t.frames.x, t.frames.y);
         });
  number(room.ui, room.session, room.shown, room.parameters, "fps", "Frame rate",
         "Frames a second, for playing and for files.", s.fps, plain.fps,
         field(1, 120, 0.01, 1000, false, "fps"), [](nodes::Settings& t, double v) { t.fps = v; });
  colourFile(room);
  ImGui::Dummy({0, room.ui.theme.space(1)});
  note(room.ui.theme, "Working space " + s.workingSpace);
  if (room.shown.displayed.colors)
    note(room.ui.theme, "Shown with " + room.shown.displayed.colors->description());
  note(room.ui.theme, fmt::format("{} nodes, {} links", room.session.document.graph().nodes.size(),
                                  room.session.document.graph().links.size()));
  drawVariationRows(room);
}

}  // namespace pileus::editor
