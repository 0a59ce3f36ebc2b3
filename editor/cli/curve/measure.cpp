#include "editor/cli/curve/measure.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include <tbb/parallel_for.h>

#include "editor/cli/scene_file.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/base/profile.h"
#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/compare.h"
#include "renderer/truth/shadow_probe.h"
#include "renderer/view/volume_render.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

constexpr int kPoints = 20000;
constexpr int kSteps = 512;  ///< in which a camera ray's optical depth is tabulated

Result<image::Image> rendered(const shadow::Gpu& gpu, const view::RenderScene& scene) {
  view::VolumeRenderPass pass(scene);
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, 1e12));
  }
  return view::readBack(*pass.picture());
}

/// One free flight from the eye; nothing where it leaves the media.
std::optional<dvec3> flight(const view::RenderScene& scene, const Box3& bounds, dvec2 uv, double uniform) {
  const view::RenderOptions& o = scene.options;
  const dvec3 eye = o.camera.eye, direction = scene::rayDirection(o.camera, double(o.size.x) / o.size.y, uv);
  const auto hit = intersectBox(eye, direction, bounds.min, bounds.max);
  if (!hit || hit->y <= 0) return std::nullopt;
  const double from = std::max(hit->x, 0.0), length = hit->y - from;
  std::array<double, kSteps> at{};
  for (int i = 0; i < kSteps; ++i) at[std::size_t(i)] = double(i + 1) / kSteps;
  const std::vector<double> depth =
      shadow::cumulativeOpticalDepth(scene.volumes, eye + from * direction, eye + hit->y * direction, at);
  const double wanted = -std::log1p(-uniform);
  const auto end = std::upper_bound(depth.begin(), depth.end(), wanted);
  if (end == depth.end()) return std::nullopt;
  const std::size_t i = std::size_t(end - depth.begin());
  const double before = i > 0 ? depth[i - 1] : 0;
  const double t = (double(i) + (wanted - before) / (depth[i] - before)) / kSteps;
  return eye + (from + t * length) * direction;
}

/// The child's processor time in seconds; Error where it fails.
Result<double> childSeconds(const fs::path& graph, const fs::path& out, ivec2 size) {
  const std::string self = executablePath().string(), shape = fmt::format("{}x{}", size.x, size.y);
  const pid_t child = ::fork();
  if (child < 0) return fail(Code::Internal, "no process could be started");
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, 1);
    ::dup2(nowhere, 2);
    ::execl(self.c_str(), self.c_str(), "render", graph.c_str(), "-o", out.c_str(), "--size", shape.c_str(),
            "--overwrite", nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return fail(Code::Internal, "pileus render {} failed", graph.string());
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

truth::ShadowSamples seenSamples(const view::RenderScene& scene, int count, std::uint64_t seed) {
  constexpr int kBatch = 4096, kMostBatches = 256;
  const Box3 bounds = volume::worldBounds(scene.volumes);
  const scene::Light& light = scene.lights.front().light;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  truth::ShadowSamples samples;
  samples.origin = bounds.center();
  for (int batch = 0; batch < kMostBatches && samples.positions.size() < std::size_t(count); ++batch) {
    std::vector<dvec3> numbers(kBatch);
    for (dvec3& n : numbers) n.x = uniform(random), n.y = uniform(random), n.z = uniform(random);
    std::vector<std::optional<std::pair<vec3, double>>> found(kBatch);
    tbb::parallel_for(std::size_t(0), numbers.size(), [&](std::size_t i) {
      const auto met = flight(scene, bounds, dvec2(numbers[i]), numbers[i].z);
      if (!met) return;
      const vec3 at(*met - samples.origin);  // as the lookup has it
      found[i].emplace(
          at, std::exp(-shadow::opticalDepthToLight(scene.volumes, light, samples.origin + dvec3(at))));
    });
    for (const auto& f : found) {
      if (!f || samples.positions.size() == std::size_t(count)) continue;
      samples.positions.push_back(vec4(f->first, 0));
      samples.transmittance.push_back(f->second);
    }
  }
  return samples;
}

Result<CurveTruth> curveTruth(view::Renderer& renderer, const CurveScene& scene, ivec2 size) {
  CurveTruth out;
  PILEUS_TRY(const view::RenderScene mapped, sceneOf(renderer, scene.graph, kCurveRender, scene.name));
  out.scene = truth::truthOf(mapped);
  out.scene.options.size = size;
  PILEUS_TRY(out.picture, rendered(renderer.gpu(), out.scene));
  out.seen = seenSamples(out.scene, kPoints, 1);
  if (out.seen.positions.empty()) return fail(Code::Internal, "{}: nothing is seen", scene.name);
  return out;
}

Result<CurveMeasure> measureCurve(view::Renderer& renderer, const CurveTruth& truth,
                                  const shadow::ShadowSpec& spec) {
  const shadow::Gpu gpu = renderer.gpu();
  const shadow::ShadowedLight& light = truth.scene.lights.front();
  const auto milliseconds = [&](const Stopwatch& clock, const CpuStopwatch& cpu) {
    glFinish();
    return gpu.device.software ? cpu.ms() : clock.ms();
  };
  view::RenderScene scene = truth.scene;
  CurveMeasure out;
  image::Image picture;
  for (const bool timed : {false, true}) {
    const Stopwatch clock;
    const CpuStopwatch cpu;
    PILEUS_TRY(scene.lights.front().shadow, shadow::buildShadow(gpu, spec, light.light, scene.volumes));
    out.mapMs = milliseconds(clock, cpu);
    if (!timed) scene.options.size = ivec2(16, 9);  // compiles
    PILEUS_TRY(picture, rendered(gpu, scene));
    out.pictureMs = milliseconds(clock, cpu) - out.mapMs;
    scene.options.size = truth.scene.options.size;
  }
  const shadow::ShadowMap& map = *scene.lights.front().shadow;
  out.radiance = relativeRms(picture, truth.picture);
  PILEUS_TRY(const std::vector<float> looked,
             truth::lookupTransmittance(gpu, map, truth.seen.positions, truth.seen.origin));
  double square = 0, sum = 0;
  for (std::size_t i = 0; i < looked.size(); ++i) {
    const double exact = std::pow(truth.seen.transmittance[i], kScatteredPower);
    const double d = std::pow(double(looked[i]), kScatteredPower) - exact;
    square += d * d;
    sum += exact;
  }
  out.scattered = std::sqrt(square * double(looked.size())) / sum;
  out.bytesPerTexel = map.bytesPerTexel();
  out.bytes = map.bytes();
  return out;
}

Result<double> renderSeconds(const nodes::Graph& graph, ivec2 size) {
  std::string pattern = (fs::temp_directory_path() / "pileus-curve-XXXXXX").string();
  if (!::mkdtemp(pattern.data())) return fail(Code::Input, "{}: cannot be made", pattern);
  const fs::path folder = pattern;
  std::array<double, 3> seconds{};
  const auto run = [&]() -> Result<void> {
    PILEUS_CHECK(nodes::saveGraph(folder / "graph.json", graph));
    for (double& s : seconds) {
      PILEUS_TRY(s, childSeconds(folder / "graph.json", folder / "out.exr", size));
    }
    return {};
  };
  const Result<void> ran = run();
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  PILEUS_CHECK(ran);
  std::sort(seconds.begin(), seconds.end());
  return seconds[1];
}

double relativeRms(const image::Image& a, const image::Image& b) {
  double square = 0, sum = 0;
  std::size_t count = 0;
  const auto& pa = a.layers.front().pixels;
  const auto& pb = b.layers.front().pixels;
  for (std::size_t i = 0; i < pb.size(); i += 4) {
    if (pb[i + 3] <= 0.01f) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = double(pa[i + c]) - double(pb[i + c]);
      square += d * d;
      sum += double(pb[i + c]);
    }
    count += 3;
  }
  return sum > 0 ? std::sqrt(square * double(count)) / sum : 0;
}

}  // namespace pileus::cli
