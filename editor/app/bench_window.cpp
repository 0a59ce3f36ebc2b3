#include "editor/app/bench_window.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <vector>

#include "editor/app/app.h"
#include "editor/cli/big_graph.h"
#include "editor/commands/files.h"
#include "editor/document/environment_scene.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/graph_view/canvas.h"
#include "editor/picture/compare_mode.h"
#include "editor/picture/light_mixer.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/window.h"
#include "renderer/base/file.h"
#include "renderer/base/log.h"
#include "renderer/image/exr.h"

namespace pileus::editor {
namespace {

constexpr int kFrames = 60, kDragSteps = 16;
constexpr double kRestSeconds = 5;

using Kind = InputEvent::Kind;

struct Costs {
  double uiMs = 0, frameMs = 0;  ///< medians
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Draws until nothing more will come, `seconds` at most.
void settle(Editor& editor, double seconds) {
  const Stopwatch clock;
  for (int frames = 0;
       clock.ms() < 1e3 * seconds && (frames < kSettlingFrames || !editor.shown.preview.settled());
       ++frames) {
    int settling = kSettlingFrames;  // never sleeps here
    runFrame(editor, settling);
  }
}

bool middleOf(const Editor& editor, const char* name, dvec2& at) {
  const std::vector<float>* r = editor.trace.find(name);
  if (r) at = {0.5F * ((*r)[0] + (*r)[2]), 0.5F * ((*r)[1] + (*r)[3])};
  return r != nullptr;
}

/// Frames while the pointer wanders over the canvas.
Costs wander(Editor& editor) {
  dvec2 middle{640, 500};
  middleOf(editor, "canvas", middle);
  editor.trace.collect(false);
  std::vector<double> ui, frame;
  int settling = kSettlingFrames;
  for (int i = 0; i < kFrames; ++i) {
    editor.window.push({Kind::Move, middle + dvec2(7 * (i % 30) - 100, 3 * (i % 20) - 30)});
    runFrame(editor, settling);
    ui.push_back(editor.now.uiMs);
    frame.push_back(editor.now.frameMs);
  }
  editor.trace.collect(true);
  return {median(ui), median(frame)};
}

int canvasRow(int nodes, double fps) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("pileus-bench-" + std::to_string(nodes) + ".json");
  if (!writeFileAtomic(file, cli::bigGraph(nodes))) return 1;
  const int code = withEditor({file}, [&](Editor& editor) {
    editor.trace.collect(true);
    settle(editor, 60);
    editor.canvas.frameAll = true;
    settle(editor, 5);
    const Costs costs = wander(editor);
    std::printf("| interface with %d nodes in view, CPU time | %.2f ms a frame | %s |\n", nodes, costs.uiMs,
                nodes == 500 ? "4 ms" : "");
    std::printf("| whole frames with %d nodes in view | %.0f a second | %.0f |\n", nodes, 1e3 / costs.frameMs,
                fps);
  });
  std::error_code ec;
  std::filesystem::remove(file, ec);
  return code;
}

/// What is dragged, how far a step, and whether that edits the document.
struct Drag {
  dvec2 at;
  double step = 4;  ///< pixels
  bool edits = true;
};

/// From a move of the pointer to the swap of a frame with a picture of the new value.
std::vector<double> dragTimes(Editor& editor, const Drag& drag) {
  std::vector<double> times;
  int settling = kSettlingFrames;
  editor.window.push({Kind::Move, drag.at});
  runFrame(editor, settling);
  editor.window.push({Kind::Button, drag.at, 0, true});
  runFrame(editor, settling);
  for (int i = 1; i <= kDragSteps; ++i) {
    const auto before = editor.shown.preview.picture();
    const std::uint64_t revision = editor.session.document.revision();
    editor.window.push({Kind::Move, drag.at + dvec2(drag.step * i, 0)});
    const Stopwatch clock;
    while (clock.ms() < 3000 && (editor.shown.preview.picture() == before ||
                                 (drag.edits && editor.session.document.revision() == revision))) {
      settling = kSettlingFrames;
      runFrame(editor, settling);
    }
    if (!drag.edits) runFrame(editor, settling);  // a mix is drawn by the frame behind
    times.push_back(clock.ms());
  }
  editor.window.push({Kind::Button, drag.at + dvec2(drag.step * kDragSteps, 0), 0, false});
  runFrame(editor, settling);
  return times;
}

/// From the command to a frame that shows something of the truth, from the state that the window is in.
double truthTime(Editor& editor) {
  int settling = kSettlingFrames;
  const Stopwatch clock;
  toggleWipe(editor.messages, editor.shown);
  while (clock.ms() < 60000 && !editor.shown.compare.shownTruth()) {
    settling = kSettlingFrames;
    runFrame(editor, settling);
  }
  runFrame(editor, settling);  // it is drawn by the next one
  const double ms = clock.ms();
  toggleWipe(editor.messages, editor.shown);
  runFrame(editor, settling);
  return ms;
}

/// A gradient with a bright side, as a file that an environment reads.
Result<std::filesystem::path> environmentFile() {
  image::Image picture;
  picture.size = {256, 128};
  std::vector<float> texels;
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x) {
      const float up = 1 - static_cast<float>(y) / 128, side = std::exp2(-static_cast<float>(x) / 16);
      texels.insert(texels.end(), {0.1f + 2 * side, 0.1f + 0.3f * up + 2 * side, 0.1f + up + 2 * side, 1});
    }
  picture.layers.push_back({"", 4, std::move(texels)});
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "pileus-bench-environment.exr";
  PILEUS_CHECK(image::writeExr(file, picture));
  return file;
}

/// The default preset under an environment beside its own lights, turned by a drag over the picture.
int turnRow() {
  const Result<std::filesystem::path> file = environmentFile();
  if (!file) return static_cast<int>(file.error().code);
  bool measured = false;
  const int code = withEditor({}, [&](Editor& editor) {
    editor.trace.collect(true);
    settle(editor, 120);
    Result<EnvironmentScene> scene = addEnvironment(editor.session.document.root(), *file);
    if (!scene) return log::error("bench: {}", scene.error().message);
    tryEditRoot(editor.session, editor.messages, scene->graph, "Add the environment");
    editor.session.document.endMerge();
    editor.session.document.select({scene->node});
    settle(editor, 120);
    dvec2 at;
    if (!middleOf(editor, "viewport", at)) return log::error("bench: there is no viewport");
    const std::vector<double> times = dragTimes(editor, {.at = at});
    std::printf(
        "| drag that turns an environment to new picture, default preset | %.0f ms (worst %.0f) | 150 ms |\n",
        median(times), *std::max_element(times.begin(), times.end()));
    measured = true;
  });
  std::error_code ec;
  std::filesystem::remove(*file, ec);
  return code == 0 && !measured ? static_cast<int>(Code::Internal) : code;
}

/// A scene of two groups of lights, whose picture fills a window of 1280 x 720.
int mixRow() {
  bool measured = false;
  const int code = withEditor({}, [&](Editor& editor) {
    editor.trace.collect(true);
    openPreset(editor, "two-lights.json");
    editor.settings.showGraph = editor.settings.showParameters = false;
    editor.settings.showLights = true;
    editor.shown.mixer.on = true;
    for (int i = 0; i < 20; ++i) settle(editor, 120);
    const std::vector<LightAt> lights = lightsOf(editor.session.document.root());
    dvec2 at;
    if (lights.empty() || editor.shown.mixer.layers.empty() ||
        !middleOf(editor, ("mixer/exposure/" + lights.front().channel).c_str(), at))
      return log::error("bench: the mixer has no layers: {}", editor.shown.mixer.error);
    const ivec2 size = editor.shown.preview.rendered()->size;
    const std::vector<double> times = dragTimes(editor, {.at = at, .step = 3, .edits = false});
    std::printf(
        "| drag of a group's exposure in the light mixer to the new picture, %d x %d | %.0f ms (worst "
        "%.0f) | 33 ms |\n",
        size.x, size.y, median(times), *std::max_element(times.begin(), times.end()));
    measured = true;
  });
  return code == 0 && !measured ? static_cast<int>(Code::Internal) : code;
}

/// Share of one processor while nothing happens.
double restShare(Editor& editor) {
  int settling = 0;
  const Stopwatch clock;
  const CpuStopwatch cpu;
  std::thread alarm([] {
    std::this_thread::sleep_for(std::chrono::duration<double>(kRestSeconds));
    Window::wake();
  });
  while (clock.ms() < 1e3 * kRestSeconds) runFrame(editor, settling);
  const double share = cpu.ms() / clock.ms();
  alarm.join();
  return share;
}

int defaultRows() {
  bool measured = false;
  const int code = withEditor({}, [&](Editor& editor) {
    editor.trace.collect(true);
    settle(editor, 120);
    editor.session.document.select({"Sky"});
    settle(editor, 5);
    dvec2 at;
    if (!middleOf(editor, "param/elevation", at)) {
      log::error("bench: the default preset has no Sky.elevation in view");
      return;
    }
    const std::vector<double> times = dragTimes(editor, {.at = at});
    std::printf("| slider drag to new picture, default preset | %.0f ms (worst %.0f) | 100 ms |\n",
                median(times), *std::max_element(times.begin(), times.end()));
    const double refining = truthTime(editor);
    settle(editor, 120);
    std::printf(
        "| compare mode to a draft of the truth, default preset | %.0f ms, while it refines %.0f | 1000 ms "
        "|\n",
        truthTime(editor), refining);
    settle(editor, 120);
    std::printf("| processor at rest | %.1f %% | 3 %% |\n", 100 * restShare(editor));
    measured = true;
  });
  return code == 0 && !measured ? static_cast<int>(Code::Internal) : code;
}

}  // namespace

int benchWindow() {
  std::printf("| what | measured | bound |\n|---|---|---|\n");
  int code = canvasRow(40, 60);
  if (code == 0) code = canvasRow(500, 30);
  if (code == 0) code = defaultRows();
  if (code == 0) code = turnRow();
  if (code == 0) code = mixRow();
  return code;
}

}  // namespace pileus::editor
