#include "editor/app/app.h"

#include <imgui.h>
#include <imgui_internal.h>  // ClosePopupToLevel: menus close with Esc without keyboard navigation

#include <algorithm>

#include "editor/app/panels.h"
#include "editor/app/trace_report.h"
#include "editor/commands/actions.h"
#include "editor/commands/carry_out.h"
#include "editor/commands/command_palette.h"
#include "editor/commands/drop_commands.h"
#include "editor/commands/files.h"
#include "editor/commands/library/presets.h"
#include "editor/commands/look.h"
#include "editor/dialogs/dialogs.h"
#include "editor/document/crash_log.h"
#include "editor/document/drops.h"
#include "editor/document/end_signals.h"
#include "editor/document/graph_pictures.h"
#include "editor/document/preset_shelf.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/graph_view/canvas.h"
#include "editor/lab/lab.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/exporter.h"
#include "editor/picture/light_mixer.h"
#include "editor/picture/light_view.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/preferences/settings_file.h"
#include "editor/start/start_view.h"
#include "editor/start/tour.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/timeline_view/timeline_state.h"
#include "editor/toolkit/modals.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/widgets.h"
#include "editor/toolkit/window.h"
#include "editor/viewport/region_view.h"
#include "editor/viewport/viewport.h"
#include "renderer/base/file.h"
#include "renderer/base/jobs.h"

namespace pileus::editor {
namespace {

constexpr int kEscape = 256;     // GLFW's code
constexpr double kSliceMs = 70;  // of refinement between two frames when nothing else happens

/// Keys go to the panel under the pointer, unless a dialog or a text field has them. Esc closes menus and
/// lists.
void handleKeys(Editor& editor) {
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  const bool ours = editor.modals.anyOpen() || editor.modals.browser.isOpen() || editor.start.open;
  if (popup && !ours && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
    ImGui::ClosePopupToLevel(0, false);
  if (popup || editor.modals.anyOpen() || editor.canvas.search.opening || editor.canvas.find.opening) return;
  for (const KeyPress& key : editor.window.keys()) {
    // Esc ends what is going on before it pauses anything.
    if (editor.canvas.interaction.busy() || editor.canvas.interaction.armed ||
        editor.timeline.drag != Timeline::Drag::None || keysAreTaken(editor.fields, editor.parameters) ||
        editor.tour.on())
      continue;
    if (editor.parameters.help.open() && key.key == kEscape) continue;
    if (key.key == kEscape &&
        (cancelRegion(editor.shown) || escapeViewport(editor.session, editor.shown, editor.viewport)))
      continue;
    if (viewportHoldsKeys(editor.viewport)) continue;
    runShortcut(editor, key);
  }
}

PreviewRequest previewRequest(const Editor& editor) {
  PreviewRequest request;
  request.graph = editor.session.document.root();
  request.generation = editor.session.generation;
  request.revision = editor.session.document.revision();
  request.view = shownView(editor.session, editor.shown);
  request.size = editor.shown.renderSize;
  if (linkedCamera(editor.session, request.view).empty()) request.freeCamera = editor.shown.freeCamera;
  request.folder = editor.session.document.path().parent_path();
  applyLookAround(editor.session, editor.shown, request);
  applyLightView(editor.session, editor.clock, editor.shown, request);
  request.frame = editor.clock.frame;
  request.layer = editor.shown.mode.layer;
  request.region = wantedRegion(editor.shown);
  request.draftMs = editor.settings.draftMs;
  applyLights(editor.shown, request);
  return request;
}

/// The draft of the truth, which one waits for: longer frames, and no refinement beside it.
void stepTruthFirst(Editor& editor) {
  Shown& shown = editor.shown;
  const Stopwatch clock;
  while (clock.ms() < 2 * kSliceMs && compareGoesFirst(shown) && !editor.window.inputPending()) {
    stepCompare(editor.messages, shown, 0.25 * kSliceMs);
    editor.window.waitEvents(0);
  }
  shown.preview.hold(compareGoesFirst(shown));
}

void evaluate(Editor& editor) {
  // Several steps a frame, so that drawing the window costs a refinement little; but input comes first: while
  // events wait, the picture does.
  const Stopwatch clock;
  editor.shown.preview.watchFiles();
  Shown& shown = editor.shown;
  shown.preview.hold(false);
  if (!editor.window.inputPending() && !labWantsFrame(shown, editor.lab)) {
    if (compareGoesFirst(shown))
      stepTruthFirst(editor);
    else if (!shown.preview.complete() && compareWantsFrame(shown))
      // Otherwise it would be left to what a refinement spares: that is nothing.
      stepCompare(editor.messages, shown, kSliceMs * (shown.compare.shownTruth() ? 0.25 : 0.6));
  }
  while (!editor.window.inputPending()) {
    shown.preview.step(previewRequest(editor));
    if (shown.preview.complete() || !shown.preview.wantsFrame() || clock.ms() > kSliceMs) break;
    editor.window.waitEvents(0);
  }
  stepMixer(editor.session, editor.shown);
  if (editor.window.inputPending()) return;
  if (const double left = kSliceMs - clock.ms(); left > 0)
    labWantsFrame(shown, editor.lab) ? stepLab(editor.ui, shown, editor.lab, left)
                                     : stepCompare(editor.messages, shown, left);
  if (auto outcome = editor.exporter.step()) {
    if (editor.quitAfterExport && *outcome) editor.quit = true;
    if (*outcome)
      editor.messages.info("Exported " + outcome->value().string());
    else
      editor.messages.error("Not exported: " + outcome->error().message);
  }
  if (!editor.exporter.active()) editor.quitAfterExport = false;
}

/// Input that would leave a field, or that a field which is only now asked for shall have, waits.
bool holdsInput(Editor& editor, const InputEvent& e, bool moved) {
  const bool pressed = e.kind == InputEvent::Kind::Key && e.down;
  return editor.fields.holds(e, moved, pressed && actsWhileTyping(editor, keyPressOf(e)));
}

/// The whole of a cut text, once the pointer rests on it.
void drawCutText(Editor& editor) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  FrameState& now = editor.now;
  updateRest(now.rest, {0, 0}, size);
  if (now.rest.short_)
    if (const std::string text = tellCutText(editor.theme); !text.empty())
      editor.trace.note("cut text", text);
  for (std::size_t i = 0; i < now.cut.texts.size(); ++i)
    editor.trace.note(fmt::format("cut/{}", i), now.cut.texts[i]);
}

void drawFrame(Editor& editor) {
  editor.trace.begin();
  editor.now.cut.beginFrame();
  editor.now.cut.all = editor.trace.on();
  ImGui::GetIO().UserData = &editor.now.cut;
  editor.fields.beginFrame();
  handleKeys(editor);
  pollPresets(editor);
  stepPlayback(editor.session, editor.clock, editor.shown.preview.answered());
  drawPanels(editor);
  drawStart(editor.startRoom);
  drawDialogs(editor);
  drawCommandPalette(editor);
  drawTour(editor.ui, editor.settings, editor.tour);
  drawCutText(editor);
  if (const std::string lost = editor.fields.endFrame(); !lost.empty()) editor.messages.hint(lost);
}

/// What a crash report would list.
void noteEvents(const Editor& editor) {
  static std::string step;
  for (const KeyPress& key : editor.window.keys())
    crash::note(fmt::format("key {}{}{}{}", key.ctrl ? "Ctrl+" : "", key.shift ? "Shift+" : "",
                            key.alt ? "Alt+" : "", key.key));
  const ImGuiIO& io = ImGui::GetIO();
  for (int b = 0; b < 3; ++b)
    if (ImGui::IsMouseClicked(b))
      crash::note(fmt::format("button {} at {:.0f}, {:.0f}", b, static_cast<double>(io.MousePos.x),
                              static_cast<double>(io.MousePos.y)));
  if (const std::string label = editor.session.document.undoLabel(); label != step) {
    step = label;
    crash::note("step: " + label);
    crash::setGraph(editor.session.document.path().string());
  }
}

/// Unsaved work and settings are kept while nothing moves; a program that is ended from outside keeps it at
/// once.
void protectWork(Editor& editor) {
  const nodes::Document& d = editor.session.document;
  const bool resting = !ImGui::IsAnyMouseDown() && !editor.canvas.interaction.busy();
  editor.session.recovery.watch(d.root(), d.revision(), d.path(), d.dirty(), resting);
  if (const std::string error = editor.session.recovery.takeError(); !error.empty())
    editor.messages.warn("Unsaved work could not be kept for recovery: " + error);
  if (const Result<void> kept = editor.settingsFile.watch(editor.settings); !kept)
    editor.messages.warn("The settings could not be kept: " + kept.error().message);
  if (endSignal() == 0) return;
  if (d.dirty())
    if (const Result<void> saved = editor.session.recovery.saveNow(d.root(), d.path()); !saved)
      log::error("{}", saved.error().message);
  editor.quit = true;
}

/// Returns whether there is something new to draw.
bool handleWindow(Editor& editor) {
  if (editor.window.closeRequested() && editor.fields.leave()) return true;
  if (editor.window.closeRequested()) {
    editor.window.cancelClose();
    if (!editor.modals.afterUnsaved) quit(editor);
  }
  editor.drops.take(editor.window.takeDroppedFiles());
  // A gesture that began with one graph ends with it, and so does typing: what arrives meanwhile comes after.
  const bool gesture = ImGui::IsAnyMouseDown() || ImGui::GetIO().WantTextInput ||
                       editor.canvas.interaction.busy() || editor.timeline.drag != Timeline::Drag::None;
  const bool read = !gesture && takeDrops(editor);
  editor.window.setTitle(std::string(editor.session.document.dirty() ? "\xe2\x80\xa2 " : "") +
                         documentName(editor.session) + " \xe2\x80\x93 Pileus");
  return read;
}

/// Is there work that can go on at once?
bool busy(const Editor& editor) {
  return editor.shown.preview.wantsFrame() || editor.exporter.wantsFrame() ||
         compareWantsFrame(editor.shown) || labWantsFrame(editor.shown, editor.lab);
}

/// Seconds until the next frame is due when nothing happens; 0 = at once.
double idleSeconds(const Editor& editor, int settling) {
  if (settling > 0 || editor.window.inputPending()) return 0;
  if (busy(editor)) return 0;
  if (displayWantsFrame(editor.shown, editor.settings, editor.viewport)) return 0.004;
  if (const double due = playbackDueIn(editor.clock); due >= 0) return due;
  if (editor.shown.preview.waiting() || editor.exporter.active()) return 0.1;  // progress of a job
  if (ImGui::GetIO().WantTextInput) return 0.4;                                // the caret blinks
  if (editor.viewport.wheelEdit) return 0.25;
  for (const PointerRest* rest : {&editor.parameters.rest, &editor.timeline.rest})
    if (const double due = helpDueIn(*rest); due > 0) return due;
  if (!editor.now.cut.under.empty() && !editor.now.rest.short_)
    if (const double due = helpDueIn(editor.now.rest); due > 0) return due;
  double due = 60;
  if (const double files = editor.shown.preview.filesDueIn(); files >= 0) due = std::min(due, files + 0.01);
  // A notice is drawn while it fades, and once more when it is gone.
  if (const double left = editor.messages.msLeft(); left >= 0)
    due = std::clamp((left - 300) / 1000, 0.05, 30.0);
  for (const double keep : {editor.session.recovery.dueSeconds(), editor.settingsFile.dueSeconds()})
    if (keep >= 0) due = std::min(due, keep + 0.05);
  return due;
}

}  // namespace

void runFrame(Editor& editor, int& settling) {
  editor.window.waitEvents(idleSeconds(editor, settling));
  const Stopwatch clock;
  const ThreadStopwatch cpu;
  followLook(editor);
  editor.window.beginFrame();
  settling = editor.window.hadInput() ? kSettlingFrames : std::max(0, settling - 1);
  editor.pictures.beginFrame();
  drawFrame(editor);
  editor.window.finishUi();
  editor.now.uiMs = cpu.ms() - editor.trace.ms;
  noteEvents(editor);
  if (editor.pictures.wantsFrame()) settling = std::max(settling, 1);
  const bool worked = busy(editor), unfinished = !editor.shown.preview.complete();
  evaluate(editor);
  // What the last step of some work has changed is drawn by one frame more.
  if (worked || (unfinished && editor.shown.preview.complete())) settling = std::max(settling, 1);
  protectWork(editor);
  editor.window.endFrame(palette::kBackground);
  // Nothing that was drawn with is replaced before it is on the screen.
  const bool asked = carryOutRequests(editor), read = handleWindow(editor);
  if (asked || read) settling = kSettlingFrames;
  if (asked) editor.fields.await(kSettlingFrames);  // they may have opened something to type into
  editor.report.write(editor);
  editor.now.frameMs = clock.ms();
}

int withEditor(const EditorOptions& options, const std::function<void(Editor&)>& use) {
  watchEndSignals();
  crash::install();
  const std::filesystem::path folder = configFolder();
  const Settings settings = loadSettings(folder);
  Result<std::unique_ptr<Window>> window = Window::create("Pileus", settings.window);
  if (!window) {
    log::error("{}", window.error().message);
    return static_cast<int>(Code::Gpu);
  }
  Result<std::unique_ptr<view::Renderer>> renderer = view::Renderer::create();
  if (!renderer) {
    log::error("{}", renderer.error().message);
    return static_cast<int>(Code::Gpu);
  }
  const float forced = Window::forcedScale();
  const float chosen = forced > 0 ? forced : static_cast<float>(settings.uiScale);
  Theme theme = makeTheme(chosen > 0 ? chosen : (*window)->screenScale(), settings.theme);
  (*window)->fontsChanged(theme.scale);
  (*window)->startUi();
  setJobNotifier([] { Window::wake(); });
  {
    Editor editor(**window, std::move(*renderer), std::move(theme), settings);
    editor.now.uiScale = chosen;
    if (options.file.empty())
      openPreset(editor, "default.json");
    else
      openFile(editor, options.file);
    const gl::DeviceInfo& device = editor.shown.renderer.device();
    crash::setDevice(device.renderer + ", " + device.version);
    editor.window.holds = [&editor](const InputEvent& e, bool moved) { return holdsInput(editor, e, moved); };
    editor.presets.refresh(presetFolders(editor.settings));
    beginStart(editor.settings, editor.start, !options.file.empty());
    use(editor);
    // Saved or given up, unless somebody else ended the program.
    if (endSignal() == 0) editor.session.recovery.discard();
    editor.settings.window = (*window)->size();
    if (const Result<void> saved = editor.settingsFile.save(editor.settings); !saved)
      log::warn("{}", saved.error().message);
    setJobNotifier(nullptr);
    editor.window.holds = {};
  }
  return 0;
}

int runEditor(const EditorOptions& options) {
  return withEditor(options, [](Editor& editor) {
    int settling = kSettlingFrames;
    while (!editor.quit) runFrame(editor, settling);
  });
}

}  // namespace pileus::editor
