#include "editor/cli/compare.h"

#include <algorithm>
#include <cstdio>

#include "renderer/image/exr.h"
#include "renderer/image/metrics.h"

namespace pileus::cli {
namespace {

Result<int> run(const CompareOptions& options) {
  PILEUS_TRY(const image::Image a, image::readExr(options.a));
  PILEUS_TRY(const image::Image b, image::readExr(options.b));
  const auto difference = image::compare(a, b);
  if (!difference)
    return fail(difference.error().code, "{} and {}: {}", options.a, options.b, difference.error().message);

  fmt::print("{} against {} ({} x {})\n", options.a, options.b, b.size.x, b.size.y);
  fmt::print("RMSE   {:.6g}\nrelMSE {:.6g}\nmax    {:.6g}\n", difference->rmse, difference->relMse,
             difference->maximum);
  const std::string notFinite = difference->notFinite == 1
                                    ? "1 pixel is not finite"
                                    : fmt::format("{} pixels are not finite", difference->notFinite);
  if (difference->notFinite > 0) fmt::print("{}\n", notFinite);
  std::size_t widest = 7;
  for (const auto& channel : difference->channels) widest = std::max(widest, channel.channel.size());
  fmt::print("{:<{}}  {:>12}  {:>12}  {:>12}\n", "channel", widest, "RMSE", "mean", "max");
  for (const auto& channel : difference->channels)
    fmt::print("{:<{}}  {:>12.6g}  {:>12.6g}  {:>12.6g}\n", channel.channel, widest, channel.rmse,
               channel.mean, channel.maximum);
  std::fflush(stdout);

  if (options.maxRelMse && difference->notFinite > 0)
    return fail(Code::Bound, "{}: no bound holds", notFinite);
  // Written so that a bound is exceeded by everything that is not below it.
  if (options.maxRelMse && !(difference->relMse <= *options.maxRelMse))
    return fail(Code::Bound, "relMSE {:.6g} exceeds the bound {:.6g}", difference->relMse,
                *options.maxRelMse);
  return 0;
}

}  // namespace

int compareMain(const CompareOptions& options) {
  const auto status = run(options);
  if (status) return *status;
  fmt::print(stderr, "pileus: {}\n", status.error().message);
  return static_cast<int>(status.error().code);
}

}  // namespace pileus::cli
