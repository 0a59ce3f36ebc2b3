#include "editor/cli/judge.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "editor/cli/render_target.h"
#include "editor/cli/scene_file.h"
#include "nodes/file/still_metadata.h"
#include "renderer/base/profile.h"
#include "renderer/image/exr.h"
#include "renderer/truth/judge.h"
#include "renderer/truth/truth_picture.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

/// Everything that stands in the way of the file is found before any work is done.
Result<void> checkOut(const JudgeArguments& a) {
  if (a.out.empty()) return {};
  const auto kind = targetKind(a.out.string());
  if (!kind || *kind != TargetKind::Exr)
    return fail(Code::Arguments, "{}: the layers are written to an .exr", a.out.string());
  PILEUS_CHECK(checkTarget(a.out));
  std::error_code ec;
  if (!a.overwrite && fs::is_regular_file(a.out, ec))
    return fail(Code::Input, "{}: exists; add --overwrite to replace it", a.out.string());
  return {};
}

std::string bouncesText(int bounces) {
  if (bounces < 0) return "all orders of scattering";
  if (bounces == 0) return "single scattering";
  return fmt::format("up to {} bounces", bounces);
}

void print(const JudgeArguments& a, const PictureFile& file, int bounces, const truth::JudgePass& pass,
           double seconds) {
  const truth::JudgeFigures& f = pass.figures();
  const ivec2 size = file.picture->size;
  fmt::print("{}: {} ({} x {}) against {}\n", a.file.string(), file.output, size.x, size.y,
             bouncesText(bounces));
  fmt::print("scaled relMSE   {:.6g} +- {:.2g} ({} pixels; the judge's noise adds about {:.1g})\n",
             f.scaled.value, f.scaled.standardError, f.scaled.pixels, f.noiseBias);
  fmt::print("ratio of means  {:.6g} +- {:.2g}\n", f.scaled.ratio, f.ratioError);
  fmt::print("judge           {} samples{}, standard error of a pixel {:.3g} %, of the mean {:.2g} %\n",
             f.samples, f.endedByTime ? " (ended by time)" : "", 100 * f.noise,
             f.judge.value > 0 ? 100 * f.judge.standardError / f.judge.value : 0);
  fmt::print("{:<8}  {:>12}  {:>12}  {:>8}\n", "means", "radiance", "std. error", "of judge");
  fmt::print("{:<8}  {:>12.6g}\n{:<8}  {:>12.6g}  {:>12.2g}\n", "picture", f.scaled.meanA, "judge",
             f.judge.value, f.judge.standardError);
  for (const truth::JudgedOrder& o : pass.orders())
    fmt::print("{:<8}  {:>12.6g}  {:>12.2g}  {:>6.2f} %\n", o.label == "more" ? "beyond" : "order " + o.label,
               o.mean.value, o.mean.standardError,
               f.judge.value > 0 ? 100 * o.mean.value / f.judge.value : 0);
  if (!a.out.empty()) fmt::print("{} ({:.1f} s)\n", a.out.string(), seconds);
}

void printJson(const JudgeArguments& a, const PictureFile& file, int bounces, const truth::JudgePass& pass,
               double seconds) {
  const truth::JudgeFigures& f = pass.figures();
  nlohmann::json orders = nlohmann::json::array();
  for (const truth::JudgedOrder& o : pass.orders())
    orders.push_back({{"order", o.label},
                      {"layer", o.layer},
                      {"mean", o.mean.value},
                      {"standardError", o.mean.standardError},
                      {"samples", o.samples}});
  const ivec2 size = file.picture->size;
  const nlohmann::json out{{"file", a.file.string()},
                           {"output", file.output},
                           {"size", {size.x, size.y}},
                           {"bounces", bounces},
                           {"scaledRelMse",
                            {{"value", f.scaled.value},
                             {"standardError", f.scaled.standardError},
                             {"noiseBias", f.noiseBias},
                             {"pixels", f.scaled.pixels}}},
                           {"ratioOfMeans", {{"value", f.scaled.ratio}, {"standardError", f.ratioError}}},
                           {"picture", {{"mean", f.scaled.meanA}}},
                           {"judge",
                            {{"mean", f.judge.value},
                             {"standardError", f.judge.standardError},
                             {"noise", f.noise},
                             {"samples", f.samples},
                             {"endedByTime", f.endedByTime}}},
                           {"orders", orders},
                           {"seconds", seconds}};
  fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

Result<void> write(const JudgeArguments& a, const PictureFile& file, int bounces,
                   const truth::JudgePass& pass) {
  image::Image picture = pass.picture();
  const truth::JudgeFigures& f = pass.figures();
  picture.metadata.merge(nodes::stillMetadata(file.graph, a.out, fs::absolute(a.file).parent_path()));
  picture.metadata["judge:bounces"] = std::to_string(bounces);
  picture.metadata["judge:samples"] = std::to_string(f.samples);
  picture.metadata["judge:scaledRelMse"] = fmt::format("{:.6g}", f.scaled.value);
  picture.metadata["judge:standardError"] = fmt::format("{:.6g}", f.scaled.standardError);
  picture.metadata["judge:ratioOfMeans"] = fmt::format("{:.6g}", f.scaled.ratio);
  return image::writeExr(a.out, picture, {image::PixelType::Float, image::Compression::Zip});
}

Result<void> run(const JudgeArguments& a) {
  const Stopwatch clock;
  PILEUS_CHECK(checkOut(a));
  PILEUS_TRY(const PictureFile file, openPicture(a.file, a.output, a.size));
  const int bounces = a.bounces.value_or(truth::claimedBounces(*file.picture->scene));
  PILEUS_TRY(image::Image picture, view::readBack(*file.picture));
  truth::JudgePass pass(std::move(picture), *file.picture->scene, {bounces, a.samples, a.seconds});
  MeasureProgress progress;
  for (double done = 0; done < 1;) {
    if (interrupted()) return fail(Code::Cancelled, "cancelled");
    progress.show(done, pass.doing());
    const auto step = pass.step(file.renderer->gpu(), 250);
    if (!step)
      return fail(step.error().code, "{}: {}: {}", a.file.string(), file.output, step.error().message);
    done = *step;
  }
  progress.finish();
  const truth::JudgeFigures& f = pass.figures();
  if (f.violations > 0)
    fmt::print(stderr, "pileus: warning: {} collisions were denser than their bound\n", f.violations);
  if (f.endless > 0)
    fmt::print(stderr,
               "pileus: warning: {} paths did not end and were cut off: is something closed that absorbs "
               "nothing?\n",
               f.endless);
  if (!a.out.empty()) PILEUS_CHECK(write(a, file, bounces, pass));
  (a.json ? printJson : print)(a, file, bounces, pass, clock.ms() * 1e-3);
  std::fflush(stdout);
  if (!a.maxRelMse) return {};
  if (!(f.scaled.value <= *a.maxRelMse))
    return fail(Code::Bound, "scaled relMSE {:.6g} exceeds the bound {:.6g}", f.scaled.value, *a.maxRelMse);
  // A bound that noise could hide is not held.
  if (!(f.scaled.standardError <= *a.maxRelMse / 4))
    return fail(
        Code::Bound,
        "scaled relMSE {:.6g}: its standard error {:.2g} is above a quarter of the bound {:.6g}; give it "
        "more --samples",
        f.scaled.value, f.scaled.standardError, *a.maxRelMse);
  return {};
}

}  // namespace

int judgeMain(const JudgeArguments& arguments) {
  const Result<void> r = run(arguments);
  if (r) return 0;
  fmt::print(stderr, "pileus: {}\n", r.error().message);
  return static_cast<int>(r.error().code);
}

}  // namespace pileus::cli
