#include "renderer/truth/shootout.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/profile.h"
#include "renderer/image/metrics.h"
#include "renderer/view/volume_render.h"

namespace pileus::truth {
namespace {

using shadow::ShadowSpec;

constexpr double kBudgetBytes =
    32;  ///< a texel of the improved map: K = 4 in 16 bits and 8 cosines, or in 8 bits and 12 cosines
constexpr int kMaxResolution = 8192;
constexpr int kFits = 8;  ///< tries to meet the bytes of a map whose size depends on the scene
constexpr double kFitTolerance = 0.005;

ShadowSpec extinction(shadow::Metric metric, int metricCount, shadow::Basis basis, int coefficients) {
  ShadowSpec s;
  s.metric.metric = metric;
  (metric == shadow::Metric::Interval ? s.metric.intervals : s.metric.coefficients) = metricCount;
  s.metric.storage = s.extinction.storage = shadow::Storage::Half;
  s.extinction.basis = basis;
  s.extinction.coefficients = coefficients;
  return s;
}

ShadowSpec series(ShadowSpec::Kind kind, int coefficients, bool range = false) {
  ShadowSpec s;
  s.kind = kind;
  s.coefficients = coefficients;
  s.range = range;
  return s;
}

struct Task {
  ShootoutGroup group;
  Contender contender;
};

}  // namespace

std::vector<Contender> shootoutContenders() {
  using K = ShadowSpec::Kind;
  using shadow::Basis;
  using shadow::Metric;
  ShadowSpec compact = extinction(Metric::Interval, 4, Basis::Cosine, 12),
             pieces = extinction(Metric::Interval, 4, Basis::Piecewise, 12);
  compact.metric.compact = pieces.metric.compact = true;
  ShadowSpec dense = compact;
  dense.metric.weighting = shadow::Weighting::Root;
  dense.metric.horizon = shadow::kUsualHorizon;
  return {{"Fourier opacity 3", series(K::FourierOpacity, 3)},
          {"Fourier opacity 7", series(K::FourierOpacity, 7)},
          {"Fourier opacity 11", series(K::FourierOpacity, 11)},
          {"Fourier opacity 15", series(K::FourierOpacity, 15)},
          {"Fourier opacity 7, near-far", series(K::FourierOpacity, 7, true)},
          {"Transmittance function 7", series(K::TransmittanceFunction, 7)},
          {"Deep shadow map", series(K::Deep, 7)},
          {"Paper, Fourier 4 + Fourier 8", extinction(Metric::Fourier, 4, Basis::Fourier, 8)},
          {"Paper, cosine 4 + cosine 8", extinction(Metric::Cosine, 4, Basis::Cosine, 8)},
          {"Interval 4 + cosine 8", extinction(Metric::Interval, 4, Basis::Cosine, 8)},
          {"Interval 4 in 8 bits + cosine 12", compact},
          {"Interval 4 in 8 bits, weighted, horizon", dense},
          {"Interval 4 in 8 bits + 3 cosines each", pieces},
          {"Interval 8 + cosine 8", extinction(Metric::Interval, 8, Basis::Cosine, 8)},
          {"Interval 4 + cosine 16", extinction(Metric::Interval, 4, Basis::Cosine, 16)},
          {"Interval 4 + slabs 8", extinction(Metric::Interval, 4, Basis::Slab, 8)}};
}

const ShadowMeasure& ShootoutEntry::worst() const {
  return *std::max_element(lights.begin(), lights.end(),
                           [](const auto& a, const auto& b) { return a.error.mean < b.error.mean; });
}

double ShootoutEntry::buildMs() const {
  double ms = 0;
  for (const ShadowMeasure& l : lights) ms += l.buildMs;
  return ms;
}

std::size_t ShootoutEntry::bytes() const {
  std::size_t sum = 0;
  for (const ShadowMeasure& l : lights) sum += l.bytes;
  return sum;
}

struct Shootout::Impl {
  view::RenderScene scene;
  ShootoutOptions options;
  std::vector<Caster> casters;
  std::vector<Task> tasks;
  std::size_t contenders = 0;  ///< of one group
  std::unique_ptr<SampleJob> sampling;
  std::vector<ShadowSamples> samples;
  std::vector<ShootoutEntry> entries;
  // The entry at work: its lights one after the other, then its picture.
  ShootoutEntry entry;
  std::vector<shadow::ShadowedLight> shadowed;
  std::unique_ptr<shadow::ShadowPass> fit;  ///< looks for the resolution that meets the bytes
  int fitResolution = 0, fits = 0;
  std::unique_ptr<MeasurePass> measuring;
  std::unique_ptr<AnyPass> rendering;
  std::unique_ptr<AnyPass> judge;  ///< kept for its halves

  const Task& task() const { return tasks[entries.size()]; }
  const Caster& caster() const { return casters[entry.lights.size()]; }

  double targetBytes() const {
    const int faces = caster().source.kind == scene::LightKind::Point ? 6 : 1;
    return kBudgetBytes * options.resolution * options.resolution * faces;
  }

  /// Begins the measurement of the next light, or of a resolution for it.
  void startLight() {
    if (task().group != ShootoutGroup::EqualMemory) return startMeasure(options.resolution);
    // What a texel took at the defaults. Of a deep map that is a guess: texels of another size see other
    // media.
    const ShadowMeasure& before = entries[entries.size() - contenders].lights[entry.lights.size()];
    const int resolution =
        int(std::lround(options.resolution * std::sqrt(kBudgetBytes / std::max(before.bytesPerTexel, 1.0))));
    if (shadow::bytesPerTexel(task().contender.spec) > 0)
      startMeasure(resolution);
    else
      startFit(resolution);
  }
  void startFit(int resolution) {
    fitResolution = std::clamp(resolution, 16, kMaxResolution);
    fit = std::make_unique<shadow::ShadowPass>(shadow::withResolution(task().contender.spec, fitResolution),
                                               caster().source, caster().volumes, caster().solids);
  }
  void startMeasure(int resolution) {
    measuring = std::make_unique<MeasurePass>(shadow::withResolution(task().contender.spec, resolution),
                                              caster(), samples[std::size_t(caster().light)], 5);
  }

  /// The bytes of a deep map grow with the square of its resolution, nearly.
  Result<void> stepFit(const shadow::Gpu& gpu, double ms) {
    PILEUS_TRY(const double done, fit->step(gpu, ms));
    if (done < 1) return {};
    const double ratio = targetBytes() / double(std::max<std::size_t>(fit->map()->bytes(), 1));
    const int next = std::clamp(int(std::lround(fitResolution * std::sqrt(ratio))), 16, kMaxResolution);
    fit.reset();
    if (std::abs(ratio - 1) < kFitTolerance || next == fitResolution || ++fits == kFits) {
      fits = 0;
      startMeasure(next);
    } else {
      startFit(next);
    }
    return {};
  }

  Result<void> stepMeasure(const shadow::Gpu& gpu, double ms) {
    PILEUS_TRY(const double done, measuring->step(gpu, ms));
    if (done < 1) return {};
    entry.lights.push_back(measuring->measure());
    const Caster& c = casters[shadowed.size()];
    const scene::Light& light = scene.lights[std::size_t(c.light)].light;
    const bool environment = light.kind == scene::LightKind::Environment;
    shadowed.push_back(
        {light, environment ? shadow::describedShadow(entry.lights.back().spec, light, c.volumes, c.solids)
                            : measuring->map()});
    measuring.reset();
    return {};
  }

  Result<void> stepPicture(const shadow::Gpu& gpu, double ms) {
    if (!rendering) {
      view::RenderScene picture = scene;
      picture.options.size = options.size;
      picture.options.samples = options.samples;
      picture.lights = shadowed;
      // Other pictures of paths than the truth are of no use here: no shadow changes them.
      picture.bounces.reset();
      const bool paths = entries.empty() && options.truth == TruthKind::Judge;
      rendering =
          std::make_unique<AnyPass>(paths ? truthPicture(picture, TruthKind::Judge) : AnyPass(picture));
    }
    PILEUS_TRY(const double done, rendering->step(gpu, ms));
    if (done < 1) return {};
    PILEUS_TRY(entry.picture, view::readBack(*rendering->picture()));
    if (judge) {
      PILEUS_TRY(const std::optional<double> scaled, judged(entry.picture, *judge->paths()));
      entry.relMse = scaled.value_or(0);
    } else if (!entries.empty()) {
      PILEUS_TRY(const image::Difference d, image::compare(entry.picture, entries.front().picture));
      entry.relMse = d.relMse;
    }
    entry.group = task().group;
    entry.name = task().contender.name;
    entries.push_back(std::move(entry));
    entry = {};
    shadowed.clear();
    if (rendering->paths()) judge = std::move(rendering);
    rendering.reset();
    return {};
  }

  Result<void> stepOnce(const shadow::Gpu& gpu, double ms) {
    if (rendering || entry.lights.size() == casters.size()) return stepPicture(gpu, ms);
    if (!fit && !measuring) startLight();
    return fit ? stepFit(gpu, ms) : stepMeasure(gpu, ms);
  }
};

Shootout::Shootout(view::RenderScene scene, const ShootoutOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->scene = std::move(scene);
  impl_->options = options;
  impl_->casters = casters(impl_->scene);
  ShadowSpec march;
  march.kind = ShadowSpec::Kind::RayMarch;
  const bool judge = options.truth == TruthKind::Judge;
  impl_->tasks.push_back({ShootoutGroup::Truth, {judge ? "Judge" : "Ray march", march}});
  impl_->contenders = shootoutContenders().size();
  for (const ShootoutGroup group : {ShootoutGroup::Defaults, ShootoutGroup::EqualMemory})
    for (Contender& c : shootoutContenders()) impl_->tasks.push_back({group, std::move(c)});
}

Shootout::~Shootout() = default;

Result<double> Shootout::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  Impl& s = *impl_;
  if (s.casters.empty()) return fail(Code::Input, "the scene has no lights");
  if (s.samples.empty()) {
    if (!s.sampling) s.sampling = startSampling(s.casters, s.options.points);
    PILEUS_TRY(const bool there, takeSamples(s.sampling, s.samples, ms));
    if (!there) return 0.0;
  }
  do {
    PILEUS_CHECK(s.stepOnce(gpu, std::max(ms - clock.ms(), 1.0)));
  } while (s.entries.size() < s.tasks.size() && clock.ms() < ms);
  const double inEntry = double(s.entry.lights.size()) / double(s.casters.size() + 1);
  return s.entries.size() == s.tasks.size() ? 1.0
                                            : (double(s.entries.size()) + inEntry) / double(s.tasks.size());
}

const std::vector<ShootoutEntry>& Shootout::entries() const { return impl_->entries; }
const view::RenderScene& Shootout::scene() const { return impl_->scene; }
const ShootoutOptions& Shootout::options() const { return impl_->options; }

int Shootout::pointCount() const {
  std::size_t sum = 0;
  for (const ShadowSamples& s : impl_->samples) sum += s.positions.size();
  return int(sum);
}

std::string Shootout::doing() const {
  const Impl& s = *impl_;
  if (s.samples.empty()) return "Sampling light rays";
  if (s.entries.size() == s.tasks.size()) return "Done";
  const Task& t = s.task();
  return t.contender.name + (t.group == ShootoutGroup::Truth      ? ""
                             : t.group == ShootoutGroup::Defaults ? " at its defaults"
                                                                  : " at equal memory");
}

std::string shootoutCsv(const std::vector<ShootoutEntry>& entries) {
  std::string csv =
      "group,representation,light,resolution,bytes_per_texel,bytes,build_ms,ns_per_lookup,mean_abs_dt,p95_"
      "abs_dt,max_abs_dt,mean_dt,picture_relmse\n";
  for (const ShootoutEntry& e : entries)
    for (const ShadowMeasure& m : e.lights)
      csv += fmt::format("{},\"{}\",{},{},{:.2f},{},{:.3f},{:.2f},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n",
                         enumId(e.group), e.name, m.light + 1, shadow::resolutionOf(m.spec), m.bytesPerTexel,
                         m.bytes, m.buildMs, m.nsPerLookup, m.error.mean, m.error.p95, m.error.maximum,
                         m.error.bias, e.relMse);
  return csv;
}

}  // namespace pileus::truth
