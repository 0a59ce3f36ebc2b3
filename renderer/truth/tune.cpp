#include "renderer/truth/tune.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "renderer/base/profile.h"
#include "renderer/truth/tune_model.h"

namespace pileus::truth {
namespace {

using shadow::ShadowSpec;
using Kind = ShadowSpec::Kind;

constexpr int kDispatches = 3;
constexpr int kTries = 16;        ///< for a first one that meets the bound
constexpr int kCheaperTries = 8;  ///< for a better one
constexpr int kCurvePoints = 8;
constexpr int kLastTries = 4;     ///< before it is said that none will do
constexpr double kSlowMs = 2000;  ///< a map of the curve may take this long to build
constexpr double kSafe = 0.9, kHopeful = 1.2, kLastHope = 2.0;  ///< expected p95 over the bound
constexpr double kDensePart = 0.01;  ///< of the points behind the horizon that make one worth trying

bool hasMetric(const ShadowSpec& s) {
  return s.kind == Kind::Extinction && s.metric.metric != shadow::Metric::None;
}

double costOf(const TuneCandidate& c, TuneBound bound) {
  return bound == TuneBound::Milliseconds ? c.ms() : double(c.bytes) / (1 << 20);
}

TunePoint pointOf(const TuneCandidate& c) {
  return {c.spec, c.p95, c.buildMs, c.nsPerLookup, double(c.bytes)};
}

/// Of an interval metric.
std::vector<shadow::MetricOptions> metricConfigurations(const shadow::MetricOptions& like, bool horizon) {
  std::vector<shadow::MetricOptions> out;
  shadow::MetricOptions m = like;
  m.metric = shadow::Metric::Interval;
  for (const bool compact : {false, true})
    for (const double depth : {0.0, shadow::kUsualHorizon})
      for (const shadow::Weighting weighting : {shadow::Weighting::None, shadow::Weighting::Root})
        for (const int intervals : {1, 2, 4, 8}) {
          if ((depth > 0 && !horizon) || (weighting == shadow::Weighting::Root && intervals == 1)) continue;
          m.compact = compact;
          m.horizon = depth;
          m.weighting = weighting;
          m.intervals = intervals;
          out.push_back(m);
        }
  return out;
}

std::vector<ShadowSpec> extinctionConfigurations(const ShadowSpec& like, bool horizon) {
  std::vector<ShadowSpec> out;
  const auto metrics =
      hasMetric(like) ? metricConfigurations(like.metric, horizon) : std::vector{like.metric};
  for (const shadow::Storage storage : {shadow::Storage::Half, shadow::Storage::Float})
    for (const shadow::MetricOptions& metric : metrics)
      for (const shadow::Basis basis : {shadow::Basis::Cosine, shadow::Basis::Slab, shadow::Basis::Piecewise})
        for (const int n : {4, 8, 12, 16, 24, 32}) {
          // Cosines of each interval need no weights, but intervals, and one coefficient for each.
          if (basis == shadow::Basis::Piecewise &&
              (!hasMetric(like) || metric.intervals == 1 || n < metric.intervals ||
               metric.weighting != shadow::Weighting::None))
            continue;
          ShadowSpec s = like;
          s.metric = metric;
          s.metric.storage = s.extinction.storage = storage;
          s.extinction.basis = basis;
          s.extinction.coefficients = n;
          s.extinction.damping = false;
          out.push_back(s);
        }
  return out;
}

}  // namespace

bool meets(const TuneCandidate& c, const TuneGoal& goal) {
  return (goal.bound == TuneBound::P95 ? c.p95 : costOf(c, goal.bound)) <= goal.limit;
}

std::vector<ShadowSpec> tuneConfigurations(const ShadowSpec& like, bool horizon) {
  if (like.kind == Kind::Extinction) return extinctionConfigurations(like, horizon);
  std::vector<ShadowSpec> out;
  ShadowSpec s = like;
  s.damping = false;
  if (like.kind == Kind::Deep) {
    for (const double bound : {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001})
      s.errorBound = bound, out.push_back(s);
  } else if (like.kind != Kind::RayMarch) {
    for (const int n : {3, 7, 11, 15, 23, 31})
      for (const bool other : {false, true}) {
        s.coefficients = n;
        if (like.kind == Kind::FourierOpacity)
          s.range = other;
        else
          s.basis = other ? shadow::Basis::Cosine : shadow::Basis::Fourier;
        out.push_back(s);
      }
  }
  return out;
}

struct Tuner::Impl {
  std::vector<Caster> casters;
  ShadowSpec like;
  TuneGoal goal;
  TuneOptions options;
  std::unique_ptr<SampleJob> sampling;
  std::vector<ShadowSamples> samples;
  std::vector<TuneCandidate> measured;

  enum class Stage { Resolution, Configurations, Search, Curve, Done } stage = Stage::Resolution;
  std::vector<ShadowSpec> configurations, queue;  ///< the queue is worked off from the back
  std::vector<int> resolutions;
  TuneModel model;
  int coarse = 256, tries = 0, cheaperTries = 0, lastTries = 0;
  double hoped = 0;  ///< p95 the model expects of the candidate
  double skew = 1;   ///< what came of it, over what was expected
  double failedBytes = 0;
  std::size_t planned = 0;

  TuneCandidate candidate;  ///< at work: its lights one after the other
  std::size_t light = 0;
  std::unique_ptr<MeasurePass> measuring;

  bool tried(const ShadowSpec& spec) const {
    return std::any_of(measured.begin(), measured.end(),
                       [&](const TuneCandidate& c) { return c.spec == spec; });
  }

  /// The accurate end of the grid, and what the model compares the rest with: half, even weights, no horizon.
  bool accurate(const ShadowSpec& c) const {
    if (c.kind != Kind::Extinction) return c == configurations.back();
    const shadow::MetricOptions& m = c.metric;
    const bool plain = !hasMetric(c) || (m.intervals == 8 && m.weighting == shadow::Weighting::None &&
                                         m.horizon == 0 && !m.compact);
    return plain && c.extinction.storage == shadow::Storage::Half &&
           c.extinction.basis == shadow::Basis::Cosine && c.extinction.coefficients == 32;
  }

  /// Configurations the model needs measured; the others lie between them, or borrow (tune_model.h).
  bool anchors(ShadowSpec c) const {
    if (c.kind != Kind::Extinction || accurate(c)) return true;
    if (std::exchange(c.metric.compact, false)) return accurate(c);
    if (c.extinction.storage == shadow::Storage::Float) {
      c.extinction.storage = c.metric.storage = shadow::Storage::Half;
      return accurate(c);
    }
    const int n = c.extinction.coefficients;
    if (n != 4 && n != 8 && n != 32) return false;
    if (!hasMetric(c) || c.metric.intervals == 8 || c.extinction.basis == shadow::Basis::Piecewise)
      return true;
    return n == 32 && c.extinction.basis == shadow::Basis::Cosine && c.metric.horizon == 0;
  }

  Result<void> plan(const shadow::Gpu& gpu) {
    bool dense = false;
    for (const ShadowSamples& s : samples)
      dense |= double(std::count_if(s.transmittance.begin(), s.transmittance.end(), [](double t) {
                 return t < std::exp(-shadow::kUsualHorizon);
               })) > kDensePart * double(s.transmittance.size());
    configurations = tuneConfigurations(like, dense);
    if (configurations.empty()) return fail(Code::Input, "a ray-marched shadow has no parameters to tune");
    for (int r = options.minResolution; r <= options.maxResolution; r *= 2) resolutions.push_back(r);
    const int affordable = (gpu.device.software ? 256 : 512) / (like.kind == Kind::Deep ? 2 : 1);
    coarse = std::clamp(affordable, options.minResolution, options.maxResolution);
    const auto reference = std::find_if(configurations.begin(), configurations.end(),
                                        [&](const auto& c) { return accurate(c); });
    for (const int r : {coarse / 2, coarse, coarse * 2})
      if (r <= options.maxResolution) queue.push_back(shadow::withResolution(*reference, r));
    planned = queue.size() +
              std::size_t(std::count_if(configurations.begin(), configurations.end(),
                                        [&](const auto& c) { return anchors(c); })) +
              kCheaperTries + kCurvePoints;
    return {};
  }

  /// Every configuration at every resolution that is left to try, as expected.
  std::vector<TunePoint> expected() const {
    std::vector<TunePoint> out;
    for (const ShadowSpec& c : configurations)
      for (const int r : resolutions) {
        const ShadowSpec spec = shadow::withResolution(c, r);
        if (tried(spec)) continue;
        if (const auto p = model.expect(spec)) out.push_back(*p);
      }
    return out;
  }

  std::optional<TuneCandidate> best() const {
    std::optional<TuneCandidate> out;
    const auto better = [&](const TuneCandidate& a, const TuneCandidate& b) {
      return goal.bound == TuneBound::P95
                 ? std::pair(double(a.bytes), a.p95) < std::pair(double(b.bytes), b.p95)
                 : std::pair(a.p95, double(a.bytes)) < std::pair(b.p95, double(b.bytes));
    };
    for (const TuneCandidate& c : measured)
      if (meets(c, goal) && (!out || better(c, *out))) out = c;
    return out;
  }

  /// The least that is expected to do; then, between what failed and what did, halving the list of what might
  /// do for less.
  std::optional<TunePoint> nextForP95() {
    const auto found = best();
    auto all = expected();
    for (TunePoint& p : all) p.p95 *= skew;
    const auto least = [&](double upTo, auto value) {
      const TunePoint* pick = nullptr;
      for (const TunePoint& p : all)
        if (p.p95 <= upTo * goal.limit && (!pick || value(p) < value(*pick))) pick = &p;
      return pick ? std::optional(*pick) : std::nullopt;
    };
    if (!found) {
      if (tries++ < kTries)
        if (auto pick = least(kSafe, [](const TunePoint& p) { return std::pair(p.bytes, p.p95); }))
          return pick;
      return lastTries++ < kLastTries
                 ? least(kLastHope, [](const TunePoint& p) { return std::pair(p.p95, p.bytes); })
                 : std::nullopt;
    }
    std::sort(all.begin(), all.end(), [](const TunePoint& a, const TunePoint& b) {
      return std::pair(a.bytes, a.p95) < std::pair(b.bytes, b.p95);
    });
    std::vector<TunePoint> front;
    for (const TunePoint& p : all)
      if (p.bytes > failedBytes && p.bytes < double(found->bytes) && p.p95 <= kHopeful * goal.limit &&
          (front.empty() || p.p95 < front.back().p95))
        front.push_back(p);
    if (front.empty() || cheaperTries++ == kCheaperTries) return std::nullopt;
    return front[front.size() / 2];
  }

  std::optional<TunePoint> nextForCost() {
    if (tries++ == kTries) return std::nullopt;
    const auto found = best();
    const auto all = expected();
    const TunePoint* pick = nullptr;
    for (const TunePoint& p : all) {
      const double cost =
          goal.bound == TuneBound::Milliseconds ? p.buildMs + p.nsPerLookup : p.bytes / (1 << 20);
      if (cost <= goal.limit && (!pick || std::pair(p.p95, p.bytes) < std::pair(pick->p95, pick->bytes)))
        pick = &p;
    }
    if (!pick || (found && pick->p95 > kHopeful * found->p95)) return std::nullopt;
    return *pick;
  }

  /// The expected front at every doubling of memory, up to 8 times what the goal takes, without what is slow
  /// to build.
  void queueCurve() {
    auto all = expected();
    for (const TuneCandidate& c : measured) all.push_back(pointOf(c));
    std::sort(all.begin(), all.end(), [](const TunePoint& a, const TunePoint& b) {
      return std::pair(a.bytes, a.p95) < std::pair(b.bytes, b.p95);
    });
    const auto found = best();
    const double largest = found ? 8.0 * double(found->bytes) : 64.0 * (1 << 20);
    double least = std::numeric_limits<double>::infinity(), before = 0;
    for (const TunePoint& p : all) {
      if (p.p95 >= 0.98 * least || p.bytes > largest) continue;
      least = p.p95;
      if (tried(p.spec)) before = p.bytes;
      if (tried(p.spec) || p.bytes < 1.6 * before || p.buildMs > kSlowMs || queue.size() == kCurvePoints)
        continue;
      before = p.bytes;
      queue.push_back(p.spec);
    }
    std::reverse(queue.begin(), queue.end());
  }

  /// What to measure next; nothing: finished.
  std::optional<ShadowSpec> next() {
    if (stage == Stage::Resolution && queue.empty()) {
      std::vector<TunePoint> points;
      for (const TuneCandidate& c : measured) points.push_back(pointOf(c));
      model.fitResolution(points);
      for (const TunePoint& p : points) model.add(p);
      for (const ShadowSpec& c : configurations)
        if (anchors(c) && !tried(shadow::withResolution(c, coarse)))
          queue.push_back(shadow::withResolution(c, coarse));
      stage = Stage::Configurations;
    }
    if (stage == Stage::Configurations && queue.empty()) stage = Stage::Search;
    if (stage == Stage::Search) {
      if (const auto p = goal.bound == TuneBound::P95 ? nextForP95() : nextForCost()) {
        hoped = p->p95 / skew;
        return p->spec;
      }
      queueCurve();
      stage = Stage::Curve;
    }
    if (stage == Stage::Curve && queue.empty()) stage = Stage::Done;
    if (queue.empty()) return std::nullopt;
    const ShadowSpec spec = queue.back();
    queue.pop_back();
    return spec;
  }

  Result<void> stepMeasure(const shadow::Gpu& gpu, double ms) {
    if (!measuring)
      measuring = std::make_unique<MeasurePass>(candidate.spec, casters[light], samples[light], kDispatches);
    PILEUS_TRY(const double done, measuring->step(gpu, ms));
    if (done < 1) return {};
    const ShadowMeasure& m = measuring->measure();
    candidate.bytes += m.bytes;
    candidate.p95 = std::max(candidate.p95, m.error.p95);
    candidate.mean = std::max(candidate.mean, m.error.mean);
    candidate.buildMs += m.buildMs;
    candidate.nsPerLookup += m.nsPerLookup;
    measuring.reset();
    if (++light < casters.size()) return {};
    light = 0;
    measured.push_back(candidate);
    if (stage == Stage::Search && hoped > 0) {
      skew = std::clamp(0.5 * (skew + candidate.p95 / hoped), 0.5, 2.0);
      if (!meets(candidate, goal)) failedBytes = std::max(failedBytes, double(candidate.bytes));
    }
    if (stage != Stage::Resolution) model.add(pointOf(candidate));
    busy = false;
    return {};
  }
  bool busy = false;  ///< `candidate` is being measured
};

Tuner::Tuner(std::vector<Caster> casters, const ShadowSpec& like, const TuneGoal& goal,
             const TuneOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->casters = std::move(casters);
  impl_->like = like;
  impl_->goal = goal;
  impl_->options = options;
}

Tuner::~Tuner() = default;

Result<double> Tuner::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  Impl& s = *impl_;
  if (s.casters.empty()) return fail(Code::Input, "there is no light to tune");
  if (s.samples.empty()) {
    if (!s.sampling) s.sampling = startSampling(s.casters, s.options.points);
    PILEUS_TRY(const bool there, takeSamples(s.sampling, s.samples, ms));
    if (!there) return 0.0;
    PILEUS_CHECK(s.plan(gpu));
  }
  do {
    if (!s.busy) {
      const auto spec = s.next();
      if (!spec) return 1.0;
      s.candidate = {.spec = *spec};
      s.busy = true;
    }
    PILEUS_CHECK(s.stepMeasure(gpu, std::max(ms - clock.ms(), 1.0)));
  } while (clock.ms() < ms);
  return std::min(double(s.measured.size()) / double(s.planned + 1), 0.99);
}

const std::vector<TuneCandidate>& Tuner::measured() const { return impl_->measured; }

std::vector<TuneCandidate> Tuner::curve() const {
  std::vector<TuneCandidate> all = impl_->measured, out;
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::pair(a.bytes, a.p95) < std::pair(b.bytes, b.p95);
  });
  for (const TuneCandidate& c : all)
    if (out.empty() || c.p95 < out.back().p95) out.push_back(c);
  return out;
}

std::optional<TuneCandidate> Tuner::best() const { return impl_->best(); }

std::optional<TuneCandidate> Tuner::nearest() const {
  const auto measure = [this](const TuneCandidate& c) {
    return impl_->goal.bound == TuneBound::P95 ? c.p95 : costOf(c, impl_->goal.bound);
  };
  const auto& all = impl_->measured;
  const auto least = std::min_element(all.begin(), all.end(),
                                      [&](const auto& a, const auto& b) { return measure(a) < measure(b); });
  return least == all.end() ? std::nullopt : std::optional(*least);
}

std::string Tuner::doing() const {
  const Impl& s = *impl_;
  if (s.samples.empty()) return "Sampling light rays";
  if (s.stage == Impl::Stage::Done) return "Done";
  if (!s.busy && s.measured.empty()) return "Starting";
  const ShadowSpec& at = s.busy ? s.candidate.spec : s.measured.back().spec;
  return fmt::format("{}, {} texels", shadow::describe(at), shadow::resolutionOf(at));
}

}  // namespace pileus::truth
