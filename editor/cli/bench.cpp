#include "editor/cli/bench.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "editor/cli/bench_tables.h"
#include "renderer/gl/context.h"

namespace pileus::cli {
namespace {

struct Table {
  const char* name;
  const char* title;
  Result<void> (*run)(const BenchSetup&);
};

constexpr Table kTables[] = {
    {"first-picture", "First lit picture after start (default preset)", benchFirstPicture},
    {"editor", "The editor's window, 1280 x 720", benchEditor},
    {"figure2", "Ray families through the real maps (figure 2 of the paper and beyond)", benchFigure2},
    {"clouds", "Every representation on 76 clouds", benchCloudField},
    {"three-clouds", "Picture and lookup: three clouds one behind the other", benchThreeClouds},
    {"silhouette", "Silhouettes: a slanted box edge over another box", benchSilhouette},
    {"curve", "Defaults: errors and costs of extinction maps", benchCurve},
    {"deep", "Deep shadow maps of smoke1.vdb", benchDeep},
    {"environments", "Light from everywhere: a cloud under five skies, 64 samples, against paths",
     benchEnvironments},
    {"scattering", "Light that was scattered more than once, against the judge (WDAS cloud, three views)",
     benchScattering},
    {"judge", "render.volume against the judge (four scenes, 320 x 180)", benchJudge},
    {"judge-speed", "The judge's own speed: a cloud under sun and sky", benchJudgeSpeed},
    {"speed", "Extinction map against a converged ray march (smoke1.vdb, 640 x 360)", benchSpeed},
};

}  // namespace

int benchMain(const BenchOptions& options, const std::function<int()>& window) {
  if (options.only == kEditorChild) return window();
  if (options.only == kFirstPictureChild) return firstPictureChild();
  BenchSetup setup;
  setup.data = options.data;
  if (const char* data = std::getenv("PILEUS_TEST_DATA"); setup.data.empty() && data) setup.data = data;
  setup.plot = options.plot;
  const auto context = gl::HeadlessContext::create();
  if (!context) {
    std::fprintf(stderr, "pileus: %s\n", context.error().message.c_str());
    return static_cast<int>(context.error().code);
  }
  auto renderer = view::Renderer::create();
  if (!renderer) {
    std::fprintf(stderr, "pileus: %s\n", renderer.error().message.c_str());
    return static_cast<int>(renderer.error().code);
  }
  setup.renderer = renderer->get();
  std::printf("Device: %s, %s\n", setup.renderer->device().renderer.c_str(),
              setup.renderer->device().version.c_str());
  int status = 0, ran = 0;
  for (const Table& table : kTables) {
    if (std::string_view(table.name).find(options.only) == std::string_view::npos) continue;
    ++ran;
    std::printf("\n## %s\n\n", table.title);
    std::fflush(stdout);
    if (const Result<void> r = table.run(setup); !r) {
      std::printf("not measured: %s\n", r.error().message.c_str());
      if (r.error().code != Code::Input) status = static_cast<int>(r.error().code);
    }
    std::fflush(stdout);
  }
  if (ran == 0) {
    std::fprintf(stderr, "pileus: bench: no table is named '%s'\n", options.only.c_str());
    return static_cast<int>(Code::Arguments);
  }
  return status;
}

}  // namespace pileus::cli
