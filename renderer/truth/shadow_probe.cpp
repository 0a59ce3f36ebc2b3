#include "renderer/truth/shadow_probe.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/view/light_set.h"

namespace pileus::truth {
namespace {

constexpr int kGroup = 64;
constexpr int kChunk = 4096;        ///< points of an untimed dispatch: a march may be long
constexpr double kDispatchMs = 20;  ///< a timed dispatch takes at least this
constexpr int kMaxRepeats = 1 << 15;

/// Everything bound for lookups of one map at given points.
class Lookups {
 public:
  static Result<Lookups> create(const shadow::Gpu& gpu, const shadow::ShadowMap& map,
                                std::span<const vec4> positions, const dvec3& origin) {
    Lookups l(map, positions, origin);
    PILEUS_CHECK(l.in_.assign(positions));
    PILEUS_CHECK(l.out_.reserve(std::max<std::size_t>(positions.size(), 1) * sizeof(float)));
    for (double done = 0; done < 1;) {
      PILEUS_TRY(const residency::Residency r,
                 l.volumes_.prepare(gpu.bricks, l.lights_.volumes(), 1e9, origin));
      done = r.fraction;
    }
    gl::Defines defines = l.lights_.defines();
    defines.emplace_back("SHAPES", l.volumes_.shapes());
    PILEUS_TRY(l.program_, gpu.shaders.program({"shadow/lookup.comp.glsl"}, defines));
    return l;
  }

  Result<void> bind(const shadow::Gpu& gpu) {
    program_->use();
    volumes_.bind(gpu.bricks, table_, *program_);
    PILEUS_CHECK(lights_.bind(gpu.store, table_, origin_));
    PILEUS_CHECK(table_.bind(*program_));
    in_.bindStorage(BIND_TEST_IN);
    out_.bindStorage(BIND_TEST_OUT);
    return {};
  }
  /// Waits.
  void dispatch(int first, int end, int repeats = 1) {
    program_->set("first", first);
    program_->set("end", end);
    glDispatchCompute(GLuint(repeats), GLuint((end - first + kGroup - 1) / kGroup), 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glFinish();
  }
  std::vector<float> all() {
    if (count_ == 0) return {};
    dispatch(0, std::min(kGroup, count_));  // a CPU compiles the program when it first runs
    const Stopwatch clock;
    for (int first = 0; first < count_; first += kChunk) dispatch(first, std::min(first + kChunk, count_));
    onceMs_ = clock.ms();
    std::vector<float> transmittance(std::size_t(count_), 0.0f);
    glGetNamedBufferSubData(out_.id(), 0, GLsizeiptr(transmittance.size() * sizeof(float)),
                            transmittance.data());
    return transmittance;
  }
  /// On a CPU its own time shared out over the cores, so that other programs' work does not count; on a GPU
  /// the time that passes.
  double nanoseconds(int dispatches, bool software) {
    if (count_ == 0) return 0;
    if (onceMs_ > kDispatchMs * dispatches * 2)
      return 1e6 * onceMs_ / count_;  // long enough to be its own measurement
    const auto time = [&](int repeats) {
      const Stopwatch clock;
      const CpuStopwatch cpu;
      dispatch(0, count_, repeats);
      return software ? cpu.ms() / std::max(1u, std::thread::hardware_concurrency()) : clock.ms();
    };
    int repeats = 1;
    double ms = time(repeats);
    while (ms < kDispatchMs && repeats < kMaxRepeats) {
      repeats =
          std::min(kMaxRepeats, std::max(repeats * 2, int(1.2 * repeats * kDispatchMs / std::max(ms, 0.1))));
      ms = time(repeats);
    }
    std::vector<double> times;
    for (int i = 0; i < dispatches; ++i) times.push_back(time(repeats));
    std::nth_element(times.begin(), times.begin() + dispatches / 2, times.end());
    return 1e6 * times[std::size_t(dispatches / 2)] / repeats / count_;
  }

 private:
  Lookups(const shadow::ShadowMap& map, std::span<const vec4> positions, const dvec3& origin)
      : lights_(
            {{map.light, std::shared_ptr<const shadow::ShadowMap>(&map, [](const shadow::ShadowMap*) {})}},
            {}, {}),
        origin_(origin),
        count_(int(positions.size())) {}
  view::LightSet lights_;
  dvec3 origin_;
  residency::SceneTable table_;
  residency::VolumeSet volumes_;
  gl::Program* program_ = nullptr;
  gl::Buffer in_{"lookup positions"}, out_{"lookup results"};
  int count_;
  double onceMs_ = 0;
};

}  // namespace

Result<std::vector<float>> lookupTransmittance(const shadow::Gpu& gpu, const shadow::ShadowMap& map,
                                               std::span<const vec4> positions, const dvec3& origin) {
  PILEUS_TRY(Lookups lookups, Lookups::create(gpu, map, positions, origin));
  PILEUS_CHECK(lookups.bind(gpu));
  return lookups.all();
}

ShadowError shadowError(std::span<const float> mapped, std::span<const double> transmittance) {
  ShadowError e;
  std::vector<double> errors;
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    const double d = double(mapped[i]) - transmittance[i];
    e.bias += d / double(mapped.size());
    e.mean += std::abs(d) / double(mapped.size());
    errors.push_back(std::abs(d));
  }
  if (errors.empty()) return e;
  e.maximum = *std::max_element(errors.begin(), errors.end());
  const auto at = errors.begin() + std::ptrdiff_t(0.95 * double(errors.size() - 1));
  std::nth_element(errors.begin(), at, errors.end());
  e.p95 = *at;
  return e;
}

Result<ProbeResult> probe(const shadow::Gpu& gpu, const shadow::ShadowMap& map, const ShadowSamples& samples,
                          int dispatches) {
  PILEUS_TRY(Lookups lookups, Lookups::create(gpu, map, samples.positions, samples.origin));
  PILEUS_CHECK(lookups.bind(gpu));
  ProbeResult r;
  r.error = shadowError(lookups.all(), samples.transmittance);
  if (dispatches > 0) r.nsPerLookup = lookups.nanoseconds(dispatches, gpu.device.software);
  return r;
}

}  // namespace pileus::truth
