#include "renderer/truth/judge.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/profile.h"

namespace pileus::truth {
namespace {

/// Far from the paths of any picture that is judged: one that was path-traced itself shares no noise.
constexpr int kFirstPath = 1 << 28;

struct Order {
  const char *layer, *label;
  int from, to;  ///< vertices that scatter behind the first
};
constexpr Order kOrders[] = {{"order1", "1", 0, 0},
                             {"order2", "2", 1, 1},
                             {"order3_4", "3-4", 2, 3},
                             {"order5_8", "5-8", 4, 7},
                             {"order_more", "more", 8, 1 << 30}};

/// As scaled relMSE has it.
bool counts(const image::Layer& beauty, std::size_t pixel) {
  return beauty.channels != 4 || !(beauty.pixels[4 * pixel + 3] <= 0.01f);
}

}  // namespace

JudgePass::JudgePass(image::Image picture, view::RenderScene scene, const JudgeOptions& options)
    : picture_(std::move(picture)), scene_(std::move(scene)), options_(options) {
  picture_.layers.resize(1);
  scene_.options.region = {};
  for (const Order& o : kOrders)
    if (options_.bounces < 0 || o.from <= options_.bounces) orders_.push_back({o.layer, o.label, {}, 0, {}});
}

void JudgePass::begin() {
  view::PathOptions paths;
  paths.firstPath = kFirstPath;
  paths.bounces = options_.bounces;
  paths.seconds = options_.seconds * (orders_.size() == 1 ? 1.0 : 0.5);
  view::RenderScene scene = scene_;
  scene.options.samples = options_.samples;
  if (at_ > 0) {
    // The judge's own paths: what they bring by these vertices. What would come behind need not be traced.
    const Order& o = kOrders[at_ - 1];
    paths.orders = {o.from, o.to};
    if (o.to < (1 << 30)) paths.bounces = paths.bounces < 0 ? o.to : std::min(paths.bounces, o.to);
    paths.seconds /= double(orders_.size());
    scene.options.samples = figures_.samples;
  }
  pass_.emplace(std::move(scene), paths);
  part_ = 0;
}

double JudgePass::fraction() const {
  if (done()) return 1;
  const double all = orders_.size() == 1 ? 1 : 1 + double(orders_.size());
  return std::min((double(at_) + part_) / all, 0.9999);
}

std::string JudgePass::doing() const {
  if (at_ == 0 || done()) return "Tracing the judge";
  return "Tracing order " + orders_[at_ - 1].label;
}

Result<double> JudgePass::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  do {
    if (done()) break;
    if (!pass_) begin();
    PILEUS_TRY(part_, pass_->step(gpu, std::max(ms - clock.ms(), 0.0)));
    if (part_ < 1) continue;
    PILEUS_CHECK(take());
    pass_.reset();
    part_ = 0, ++at_;
  } while (clock.ms() < ms);
  return fraction();
}

/// What the pass has made.
Result<void> JudgePass::take() {
  const view::PathStatistics statistics = pass_->statistics();
  PILEUS_TRY(image::Image made, view::readBack(*pass_->picture()));
  PILEUS_TRY(const auto variances, pass_->variance());
  PILEUS_TRY(image::Image variance, view::readBack(*variances));
  figures_.violations += statistics.violations, figures_.endless += statistics.endless;
  if (at_ > 0) {
    JudgedOrder& order = orders_[at_ - 1];
    order.samples = statistics.samples;
    order.mean = meanOf(made.layers[0], variance.layers[0]);
    order.pixels = std::move(made.layers[0]);
    order.pixels.name = order.layer;
    return {};
  }
  figures_.samples = statistics.samples;
  figures_.endedByTime = pass_->endedByTime();
  figures_.noise = statistics.mean > 0 ? statistics.standardError / statistics.mean : 0;
  judge_ = std::move(made.layers[0]), variance_ = std::move(variance.layers[0]);
  judge_.name = "judge", variance_.name = "variance";
  variance_.data = true;
  PILEUS_CHECK(measure());
  if (orders_.size() > 1) return {};
  orders_[0].samples = figures_.samples, orders_[0].mean = figures_.judge;
  orders_[0].pixels = judge_;
  orders_[0].pixels.name = orders_[0].layer;
  return {};
}

Result<void> JudgePass::measure() {
  if (figures_.samples < 2)
    return fail(Code::Input,
                "the judge had time for a single sample, and compares two: give it more than {} s",
                options_.seconds);
  PILEUS_TRY(const auto halves, pass_->halves());
  PILEUS_TRY(figures_.scaled, image::scaledRelMse(picture_, halves[0], halves[1]));
  figures_.judge = meanOf(judge_, variance_);
  if (figures_.judge.value > 0)
    figures_.ratioError = figures_.scaled.ratio * figures_.judge.standardError / figures_.judge.value;
  // 1.5 s^4 (image::scaledRelMse), the variance of a half being twice that of both.
  const double floor = 0.01 * figures_.scaled.meanB * figures_.scaled.meanB;
  const double terms = 3 * double(figures_.scaled.pixels);
  for (std::size_t i = 0; i < judge_.pixels.size(); ++i) {
    if (i % 4 == 3 || !counts(picture_.layers[0], i / 4)) continue;
    const double b = double(judge_.pixels[i]),
                 s = double(variance_.pixels[i]) / std::max(b * b + floor, 1e-300);
    figures_.noiseBias += 6 * s * s / terms;
  }
  return {};
}

JudgedMean JudgePass::meanOf(const image::Layer& pixels, const image::Layer& variance) const {
  JudgedMean out;
  double squares = 0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < pixels.pixels.size() / 4; ++i) {
    if (!counts(picture_.layers[0], i)) continue;
    double deviation = 0;  // the channels of a sample are rarely independent, so they are added up
    for (std::size_t c = 0; c < 3; ++c) {
      out.value += double(pixels.pixels[4 * i + c]) / 3;
      deviation += std::sqrt(double(variance.pixels[4 * i + c])) / 3;
    }
    squares += deviation * deviation;
    ++number;
  }
  if (number == 0) return {};
  out.value /= double(number);
  out.standardError = std::sqrt(squares) / double(number);
  return out;
}

image::Image JudgePass::picture() const {
  image::Image out = picture_;
  const image::Layer& beauty = picture_.layers[0];
  image::Layer difference{"difference", 3, {}, true};
  for (std::size_t i = 0; i < judge_.pixels.size() / 4; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      difference.pixels.push_back(beauty.pixels[4 * i + c] - judge_.pixels[4 * i + c]);
  out.layers.push_back(judge_);
  out.layers.push_back(std::move(difference));
  out.layers.push_back(variance_);
  for (const JudgedOrder& order : orders_) out.layers.push_back(order.pixels);
  return out;
}

}  // namespace pileus::truth
