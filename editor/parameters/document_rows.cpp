#include "editor/parameters/document_rows.h"

#include <fmt/core.h>

#include "editor/app/editor.h"
#include "editor/parameters/param_row.h"
#include "editor/parameters/param_widgets.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using Apply = void (*)(nodes::Settings&, double);

void edit(Editor& editor, const nodes::Settings& settings, const std::string& label,
          const std::string& mergeKey) {
  nodes::Graph graph = editor.document.graph();
  graph.settings = settings;
  editor.document.edit(std::move(graph), label, mergeKey);
  editor.preview.touch();
}

void rowHelp(Editor& editor, const RowFrame& f, const char* help) {
  const float right = f.at.x + f.widget;
  if (editor.parameters.rest.short_ && ImGui::IsWindowHovered() && !ImGui::IsAnyItemActive() &&
      ImGui::IsMouseHoveringRect(f.at, {right, f.at.y + f.height}))
    tooltip(editor.theme, help);
}

void number(Editor& editor, const char* id, const char* label, const char* help, double value,
            double fallback, const NumberField& field, Apply apply) {
  Parameters& panel = editor.parameters;
  ImGui::PushID(id);
  const RowFrame f = rowFrame(editor, false);
  rowLabel(editor, f, label, value != fallback);
  toWidget(f);
  const NumberEdit n = numberField(panel.numbers, editor.theme, id, value, field, f.width);
  editor.trace.item(std::string("setting/") + id);
  const std::string merge = std::string("setting ") + id, step = std::string("Set ") + label;
  nodes::Settings settings = editor.document.graph().settings;
  if (n.dragging && !panel.settingsBefore) panel.settingsBefore = settings;
  if (n.changed) {
    apply(settings, value);
    edit(editor, settings, step, n.dragging ? merge : "");
  }
  if (n.cancelled && panel.settingsBefore) edit(editor, *panel.settingsBefore, step, merge);
  if (n.finished) panel.settingsBefore.reset(), editor.document.endMerge();
  if (n.refused) panel.refusedKey = merge, panel.refusedAt = ImGui::GetTime();
  if ((n.changed || n.finished) && !n.refused && panel.refusedKey == merge) panel.refusedKey.clear();
  rowHelp(editor, f, help);
  drawRefusal(editor, merge);
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

void setColours(Editor& editor, const std::string& path) {
  nodes::Settings settings = editor.document.graph().settings;
  settings.ocio = path;
  edit(editor, settings, "Set colour configuration", "");
}

void colourFile(Editor& editor) {
  const std::string current = editor.document.graph().settings.ocio;
  const std::vector<std::string> kinds = {"ocio"};
  ImGui::PushID("ocio");
  const RowFrame f = rowFrame(editor, false);
  const bool clipped = rowLabel(editor, f, "Colour config", !current.empty());
  (void)clipped;
  toWidget(f);
  std::string text = current;
  const float button = ImGui::GetFrameHeight() + editor.theme.px(2);
  if (textField(editor, "setting.ocio", text, f.width - button, "$OCIO, else the shipped one", &kinds))
    setColours(editor, expandedHome(text));
  editor.trace.item("setting/ocio");
  ImGui::SameLine(0, editor.theme.px(2));
  ImGui::PushStyleColor(ImGuiCol_Button, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  if (ImGui::Button(icon::kFolderOpen, {button - editor.theme.px(2), 0})) {
    BrowserRequest request;
    request.title = "Colour configuration";
    request.button = "Choose";
    request.kinds = kinds;
    request.start = absoluteFile(editor, current);
    request.done = [&editor](const std::filesystem::path& path) { setColours(editor, path.string()); };
    editor.browser.open(editor, std::move(request));
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  editor.trace.item("browse/setting ocio");
  rowHelp(editor, f, "The OpenColorIO file whose displays and views pictures are shown with.");
  ImGui::PopID();
}

void note(Editor& editor, const std::string& text) {
  ImGui::PushFont(editor.theme.small);
  ImGui::PushTextWrapPos();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextFaint);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

}  // namespace

void drawDocumentRows(Editor& editor) {
  const nodes::Settings s = editor.document.graph().settings;
  const nodes::Settings plain;
  const NumberField pixels = field(64, 4096, 1, 65536, true, "px"), frames = field(0, 0, -1e6, 1e6, true, "");
  number(editor, "width", "Picture width", "Pixels of what is rendered to files.", s.size.x, plain.size.x,
         pixels, [](nodes::Settings& t, double v) { t.size.x = static_cast<int>(v); });
  number(editor, "height", "Picture height", "Pixels of what is rendered to files.", s.size.y, plain.size.y,
         pixels, [](nodes::Settings& t, double v) { t.size.y = static_cast<int>(v); });
  number(editor, "first", "First frame", "Where the animation begins.", s.frames.x, plain.frames.x, frames,
         [](nodes::Settings& t, double v) {
           t.frames.x = static_cast<int>(v);
           t.frames.y = std::max(t.frames.y, t.frames.x);
         });
  number(editor, "last", "Last frame", "Where the animation ends.", s.frames.y, plain.frames.y, frames,
         [](nodes::Settings& t, double v) {
           t.frames.y = static_cast<int>(v);
           t.frames.x = std::min(t.frames.x, t.frames.y);
         });
  number(editor, "fps", "Frame rate", "Frames a second, for playing and for files.", s.fps, plain.fps,
         field(1, 120, 0.01, 1000, false, "fps"), [](nodes::Settings& t, double v) { t.fps = v; });
  colourFile(editor);
  ImGui::Dummy({0, editor.theme.space(1)});
  note(editor, "Working space " + s.workingSpace);
  if (editor.viewport.colors) note(editor, "Shown with " + editor.viewport.colors->description());
  note(editor, fmt::format("{} nodes, {} links", editor.document.graph().nodes.size(),
                           editor.document.graph().links.size()));
}

}  // namespace pileus::editor
