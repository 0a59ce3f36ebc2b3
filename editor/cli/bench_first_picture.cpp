#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "editor/cli/bench_tables.h"
#include "embedded_presets.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/base/profile.h"
#include "renderer/image/color.h"
#include "renderer/view/display.h"
#include "renderer/view/picture.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

/// What the editor does between its start and its first picture, less the window: context, preset, draft,
/// display transform.
Result<double> firstLitPicture() {
  const Stopwatch clock;
  PILEUS_TRY(const auto context, gl::HeadlessContext::create());
  PILEUS_TRY(const auto renderer, view::Renderer::create());
  std::string text;
  for (const EmbeddedFile& f : embedded_presets())
    if (f.path == "default.json") text = f.bytes;
  PILEUS_TRY(const nodes::Loaded loaded, nodes::parseGraph(text));
  nodes::Evaluator evaluator(renderer.get());
  std::string target;
  for (const std::string& n : nodes::outputNodes(loaded.graph))
    if (nodes::findNode(loaded.graph, n)->type == "output.view") target = n;
  nodes::EvalSettings settings;
  settings.size = loaded.graph.settings.size;
  settings.quality = nodes::Quality::Draft;
  for (;;) {
    const nodes::EvalReport r = evaluator.evaluate(loaded.graph, {target}, settings);
    const nodes::SocketValue* value = evaluator.input(target, "image");
    const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
    if (image && image->picture && image->picture->samples >= 1) {
      PILEUS_TRY(const auto config, image::ColorConfig::load(""));
      view::Display display(renderer->shaders());
      PILEUS_TRY([[maybe_unused]] const unsigned shown,
                 display.draw(image->picture->color, image->picture->size, settings.size, *config, {}));
      PILEUS_TRY(const image::Image picture, view::readBack(*image->picture));
      float brightest = 0;
      for (const float v : picture.layers[0].pixels) brightest = std::max(brightest, v);
      if (brightest > 0) return clock.ms();
      return fail(Code::Internal, "the first picture is black");
    }
    if (r.complete) return fail(Code::Internal, "the default preset gives no picture");
    if (r.waitingForJobs) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

double childSeconds(const fs::path& caches) {
  const Stopwatch clock;
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("XDG_CACHE_HOME", caches.c_str(), 1);
    ::setenv("MESA_SHADER_CACHE_DIR", caches.c_str(), 1);
    const std::string self = executablePath().string();
    ::execl(self.c_str(), self.c_str(), "bench", "--only", kFirstPictureChild, nullptr);
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? clock.ms() * 1e-3 : -1;
}

}  // namespace

int firstPictureChild() {
  const Result<double> r = firstLitPicture();
  if (!r) std::fprintf(stderr, "pileus: %s\n", r.error().message.c_str());
  return r ? 0 : static_cast<int>(r.error().code);
}

Result<void> benchFirstPicture(const BenchSetup&) {
  std::string pattern = (fs::temp_directory_path() / "pileus-bench-XXXXXX").string();
  const fs::path caches = ::mkdtemp(pattern.data());
  const double cold = childSeconds(caches), warm = childSeconds(caches);
  std::error_code ec;
  fs::remove_all(caches, ec);
  if (cold < 0 || warm < 0) return fail(Code::Internal, "the child process failed");
  std::printf("| start | seconds, process start to first lit picture | bound |\n|---|---|---|\n");
  std::printf("| cold (no bricks, no compiled shaders) | %.2f | 6 |\n| warm | %.2f | 3 |\n", cold, warm);
  return {};
}

}  // namespace pileus::cli
