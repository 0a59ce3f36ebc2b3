#include "editor/cli/compare.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "renderer/image/exr.h"
#include "renderer/image/metrics.h"

namespace pileus::cli {
namespace {

Result<int> run(const CompareOptions& options) {
  const bool halves = !options.b2.empty();
  PILEUS_TRY(const image::Image a, image::readExr(options.a));
  PILEUS_TRY(const image::Image b, image::readExr(options.b));
  std::optional<image::Image> other;
  if (halves) {
    PILEUS_TRY(other, image::readExr(options.b2));
  }
  const auto difference = image::compare(a, b);
  if (!difference)
    return fail(difference.error().code, "{} and {}: {}", options.a, options.b, difference.error().message);
  const auto scaled = image::scaledRelMse(a, b, other ? *other : b);
  if (!scaled && (halves || options.maxScaledRelMse))
    return fail(scaled.error().code, "{} and {}: {}", options.a, halves ? options.b2 : options.b,
                scaled.error().message);

  fmt::print("{} against {} ({} x {})\n", options.a, options.b, b.size.x, b.size.y);
  fmt::print("RMSE   {:.6g}\nrelMSE {:.6g}\nmax    {:.6g}\n", difference->rmse, difference->relMse,
             difference->maximum);
  if (scaled)
    fmt::print("scaled relMSE {:.6g} +- {:.2g} ({}), ratio of means {:.6g}, {} pixels\n", scaled->value,
               scaled->standardError,
               halves ? "halves " + options.b + " and " + options.b2 : options.b + " is both halves",
               scaled->ratio, scaled->pixels);
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
  if (options.maxScaledRelMse) {
    if (!(scaled->value <= *options.maxScaledRelMse))
      return fail(Code::Bound, "scaled relMSE {:.6g} exceeds the bound {:.6g}", scaled->value,
                  *options.maxScaledRelMse);
    // A bound that noise could hide is not held.
    if (halves && *options.maxScaledRelMse > 0 && !(scaled->standardError <= *options.maxScaledRelMse / 4))
      return fail(Code::Bound,
                  "scaled relMSE {:.6g}: its standard error {:.2g} is above a quarter of the bound {:.6g}",
                  scaled->value, scaled->standardError, *options.maxScaledRelMse);
  }
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
