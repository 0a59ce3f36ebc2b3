#include "editor/cli/shootout.h"

#include <algorithm>
#include <cstdio>

#include "editor/cli/graph_file.h"
#include "editor/cli/scene_file.h"
#include "renderer/base/file.h"
#include "renderer/base/profile.h"
#include "renderer/image/png.h"
#include "renderer/truth/contact_sheet.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

/// Refused unless absent, empty or to be overwritten; made otherwise.
Result<void> prepareFolder(const fs::path& folder, bool overwrite) {
  std::error_code ec;
  if (fs::exists(folder, ec) && !fs::is_directory(folder, ec))
    return fail(Code::Input, "{}: is no folder", folder.string());
  if (fs::is_directory(folder, ec) && !fs::is_empty(folder, ec) && !overwrite)
    return fail(Code::Input, "{}: is not empty; --overwrite writes into it", folder.string());
  fs::create_directories(folder, ec);
  if (ec) return fail(Code::Input, "{}: {}", folder.string(), ec.message());
  return {};
}

std::string label(const truth::ShootoutEntry& e, const truth::ShadowMeasure& m) {
  return e.lights.size() > 1 ? fmt::format("{}, light {}", e.name, m.light + 1) : e.name;
}

void printTable(const std::vector<truth::ShootoutEntry>& entries) {
  std::optional<truth::ShootoutGroup> group;
  std::size_t width = 0;
  for (const truth::ShootoutEntry& e : entries) width = std::max(width, label(e, e.lights.back()).size());
  for (const truth::ShootoutEntry& e : entries) {
    if (group != e.group) {
      fmt::print("{}{}\n", group ? "\n" : "",
                 e.group == truth::ShootoutGroup::Truth      ? "Truth"
                 : e.group == truth::ShootoutGroup::Defaults ? "Defaults"
                                                             : "Equal memory");
      fmt::print("{:<{}} {:>9} {:>9} {:>9} {:>10} {:>10} {:>8} {:>6} {:>9} {:>10}\n", "representation", width,
                 "mean |dT|", "p95", "max", "build ms", "ns/lookup", "B/texel", "texels", "MiB", "relMSE");
      group = e.group;
    }
    for (const truth::ShadowMeasure& m : e.lights)
      fmt::print("{:<{}} {:>9.5f} {:>9.4f} {:>9.3f} {:>10.2f} {:>10.1f} {:>8.1f} {:>6} {:>9.3f} {:>10.3e}\n",
                 label(e, m), width, m.error.mean, m.error.p95, m.error.maximum, m.buildMs, m.nsPerLookup,
                 m.bytesPerTexel, shadow::resolutionOf(m.spec), double(m.bytes) / (1 << 20), e.relMse);
  }
}

Result<void> run(const ShootoutArguments& a) {
  const fs::path folder = a.out.empty() ? fs::path(a.file.stem().string() + "-shootout") : a.out;
  PILEUS_TRY(const SceneFile file, openScene(a.file, a.render));
  PILEUS_CHECK(prepareFolder(folder, a.overwrite));
  const Stopwatch clock;
  truth::Shootout shootout(file.scene, {a.resolution, a.size, a.samples, {.count = a.points}, a.truth});
  const shadow::Gpu gpu = file.renderer->gpu();
  MeasureProgress progress;
  for (double done = 0; done < 1;) {
    if (interrupted()) return fail(Code::Cancelled, "cancelled");
    const auto step = shootout.step(gpu, 250);
    if (!step) return fail(step.error().code, "{}: {}", a.file.string(), step.error().message);
    progress.show(done = *step, shootout.doing());
  }
  progress.finish();
  PILEUS_CHECK(writeFileAtomic(folder / "shootout.csv", truth::shootoutCsv(shootout.entries())));
  PILEUS_TRY(const auto config, colorConfigOf(file.graph, fs::absolute(a.file).parent_path()));
  const DisplayChoice choice = displayOf(file.graph);
  truth::SheetOptions sheet;
  sheet.display = choice.display;
  sheet.view = choice.view;
  sheet.exposure = choice.exposure;
  sheet.title = a.file.stem().string();
  const std::size_t lights = file.scene.lights.size();
  sheet.subtitle = fmt::format(
      "{} light{}, {} points in the media against exact transmittance; {} x {} pixels, {} samples; {}",
      lights, lights == 1 ? "" : "s (the worst one's error is shown)", shootout.pointCount(), a.size.x,
      a.size.y, a.samples, file.renderer->device().renderer);
  PILEUS_TRY(const image::Canvas canvas, truth::contactSheet(shootout.entries(), *config, sheet));
  PILEUS_CHECK(image::writePng(folder / "contact-sheet.png", canvas.size, canvas.rgba.data()));
  printTable(shootout.entries());
  fmt::print("\n{} points, {}; {} and contact-sheet.png ({:.1f} s)\n", shootout.pointCount(),
             file.renderer->device().renderer, (folder / "shootout.csv").string(), clock.ms() * 1e-3);
  std::fflush(stdout);
  return {};
}

}  // namespace

int shootoutMain(const ShootoutArguments& arguments) {
  const Result<void> r = run(arguments);
  if (r) return 0;
  fmt::print(stderr, "pileus: {}\n", r.error().message);
  return static_cast<int>(r.error().code);
}

}  // namespace pileus::cli
