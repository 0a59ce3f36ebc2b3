#include "editor/app/app.h"

#include <imgui.h>
#include <imgui_internal.h>  // ClosePopupToLevel: menus close with Esc without keyboard navigation

#include <algorithm>

#include "editor/app/crash_log.h"
#include "editor/app/editor.h"
#include "editor/app/end_signals.h"
#include "editor/app/look.h"
#include "editor/app/panels.h"
#include "editor/commands/actions.h"
#include "editor/document/files.h"
#include "editor/picture/shadow_place.h"
#include "editor/picture/shown_camera.h"
#include "editor/time/playback.h"
#include "editor/viewport/region_view.h"
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
  const bool ours = editor.dialogs.anyOpen() || editor.browser.isOpen() || editor.start.open;
  if (popup && !ours && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
    ImGui::ClosePopupToLevel(0, false);
  if (popup || editor.dialogs.anyOpen() || editor.canvas.search.opening || editor.canvas.find.opening) return;
  for (const KeyPress& key : editor.window->keys()) {
    // Esc ends what is going on before it pauses anything.
    if (editor.canvas.interaction.busy() || editor.canvas.interaction.armed ||
        editor.timeline.drag != Timeline::Drag::None || keysAreTaken(editor.parameters) || editor.tour.on())
      continue;
    if (editor.parameters.help.open() && key.key == kEscape) continue;
    if (key.key == kEscape && (cancelRegion(editor) || escapeViewport(editor))) continue;
    if (viewportHoldsKeys(editor)) continue;
    runShortcut(editor, key);
  }
}

PreviewRequest previewRequest(const Editor& editor) {
  PreviewRequest request;
  request.graph = editor.document.root();
  request.revision = editor.document.revision();
  request.view = shownView(editor);
  request.size = editor.viewport.renderSize;
  if (linkedCamera(editor, request.view).empty()) request.freeCamera = editor.viewport.freeCamera;
  request.folder = editor.document.path().parent_path();
  applyLightView(editor, request);
  request.frame = editor.frame;
  request.layer = editor.viewport.mode.layer;
  request.region = wantedRegion(editor);
  request.draftMs = editor.settings.draftMs;
  return request;
}

void evaluate(Editor& editor) {
  // Several steps a frame, so that drawing the window costs a refinement little; but input comes first: while
  // events wait, the picture does.
  const Stopwatch clock;
  while (!editor.window->inputPending()) {
    editor.preview.step(previewRequest(editor));
    if (editor.preview.complete() || !editor.preview.wantsFrame() || clock.ms() > kSliceMs) break;
    editor.window->waitEvents(0);
  }
  if (editor.window->inputPending()) return;
  if (const double left = kSliceMs - clock.ms(); left > 0)
    labWantsFrame(editor) ? stepLab(editor, left) : stepCompare(editor, left);
  if (auto outcome = editor.exporter.step()) {
    if (*outcome)
      editor.messages.info("Exported " + outcome->value().string());
    else
      editor.messages.error("Not exported: " + outcome->error().message);
  }
}

void drawFrame(Editor& editor) {
  editor.trace.begin();
  handleKeys(editor);
  stepPlayback(editor);
  drawPanels(editor);
  editor.browser.draw(editor);
  drawStart(editor);
  drawDialogs(editor);
  drawCommandPalette(editor);
  drawTour(editor);
}

/// What a crash report would list.
void noteEvents(const Editor& editor) {
  static std::string step;
  for (const KeyPress& key : editor.window->keys())
    crash::note(fmt::format("key {}{}{}{}", key.ctrl ? "Ctrl+" : "", key.shift ? "Shift+" : "",
                            key.alt ? "Alt+" : "", key.key));
  const ImGuiIO& io = ImGui::GetIO();
  for (int b = 0; b < 3; ++b)
    if (ImGui::IsMouseClicked(b))
      crash::note(fmt::format("button {} at {:.0f}, {:.0f}", b, static_cast<double>(io.MousePos.x),
                              static_cast<double>(io.MousePos.y)));
  if (const std::string label = editor.document.undoLabel(); label != step) {
    step = label;
    crash::note("step: " + label);
    crash::setGraph(editor.document.path().string());
  }
}

/// Unsaved work is kept while nothing moves; a program that is ended from outside keeps it at once.
void protectWork(Editor& editor) {
  const nodes::Document& d = editor.document;
  const bool resting = !ImGui::IsAnyMouseDown() && !editor.canvas.interaction.busy();
  editor.recovery.watch(d.root(), d.revision(), d.path(), d.dirty(), resting);
  if (const std::string error = editor.recovery.takeError(); !error.empty())
    editor.messages.warn("Unsaved work could not be kept for recovery: " + error);
  if (endSignal() == 0) return;
  if (d.dirty())
    if (const Result<void> saved = editor.recovery.saveNow(d.root(), d.path()); !saved)
      log::error("{}", saved.error().message);
  editor.quit = true;
}

void handleWindow(Editor& editor) {
  if (editor.window->closeRequested()) {
    editor.window->cancelClose();
    if (!editor.dialogs.afterUnsaved) withSavedDocument(editor, [](Editor& e) { e.quit = true; });
  }
  editor.drops.take(editor.window->takeDroppedFiles());
  editor.drops.step(editor);
  editor.window->setTitle(std::string(editor.document.dirty() ? "\xe2\x80\xa2 " : "") + documentName(editor) +
                          " \xe2\x80\x93 Pileus");
}

/// Is there work that can go on at once?
bool busy(const Editor& editor) {
  return editor.preview.wantsFrame() || editor.exporter.wantsFrame() || compareWantsFrame(editor) ||
         labWantsFrame(editor);
}

/// Seconds until the next frame is due when nothing happens; 0 = at once.
double idleSeconds(const Editor& editor, int settling) {
  if (settling > 0 || editor.window->inputPending()) return 0;
  if (busy(editor)) return 0;
  if (displayWantsFrame(editor)) return 0.004;
  if (const double due = playbackDueIn(editor); due >= 0) return due;
  if (editor.preview.waiting() || editor.exporter.active()) return 0.1;  // progress of a job
  if (ImGui::GetIO().WantTextInput) return 0.4;                          // the caret blinks
  if (editor.viewport.wheelEdit) return 0.25;
  for (const PointerRest* rest : {&editor.parameters.rest, &editor.timeline.rest})
    if (const double due = helpDueIn(*rest); due > 0) return due;
  double due = 60;
  // A notice is drawn while it fades, and once more when it is gone.
  if (const double left = editor.messages.msLeft(); left >= 0)
    due = std::clamp((left - 300) / 1000, 0.05, 30.0);
  if (const double recovery = editor.recovery.dueSeconds(); recovery >= 0)
    due = std::min(due, recovery + 0.05);
  return due;
}

}  // namespace

void runFrame(Editor& editor, int& settling) {
  editor.window->waitEvents(idleSeconds(editor, settling));
  const Stopwatch clock;
  const ThreadStopwatch cpu;
  followLook(editor);
  editor.window->beginFrame();
  settling = editor.window->hadInput() ? kSettlingFrames : std::max(0, settling - 1);
  editor.pictures.beginFrame();
  drawFrame(editor);
  editor.window->finishUi();
  editor.uiMs = cpu.ms() - editor.trace.ms;
  noteEvents(editor);
  if (editor.pictures.wantsFrame()) settling = std::max(settling, 1);
  const bool worked = busy(editor), unfinished = !editor.preview.complete();
  evaluate(editor);
  // What the last step of some work has changed is drawn by one frame more.
  if (worked || (unfinished && editor.preview.complete())) settling = std::max(settling, 1);
  handleWindow(editor);
  protectWork(editor);
  editor.window->endFrame(palette::kBackground);
  editor.trace.end(editor);
  editor.frameMs = clock.ms();
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
    Editor editor(**window, std::move(*renderer), std::move(theme));
    editor.settings = settings;
    editor.uiScale = chosen;
    if (options.file.empty())
      openPreset(editor, "default.json");
    else
      openFile(editor, options.file);
    const gl::DeviceInfo& device = editor.renderer->device();
    crash::setDevice(device.renderer + ", " + device.version);
    beginStart(editor, options.file.empty() && editor.settings.showStart);
    use(editor);
    // Saved or given up, unless somebody else ended the program.
    if (endSignal() == 0) editor.recovery.discard();
    editor.settings.window = (*window)->size();
    if (const Result<void> saved = saveSettings(folder, editor.settings); !saved)
      log::warn("{}", saved.error().message);
    setJobNotifier(nullptr);
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
