#include "editor/cli/ray_families.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/shaders/shared/bindings.h"
#include "renderer/volume/brick_builder.h"

namespace pileus::cli {
namespace {

constexpr int kSamples = 4096;   ///< midpoint samples on [0,1]; one voxel each, one metre

/// Five octaves of linear value noise over [0,1]; octave o has 4 * 2^o random knots.
class ValueNoise {
 public:
  explicit ValueNoise(std::mt19937_64& rng) {
    std::uniform_real_distribution<double> knot(-0.5, 0.5);
    for (int o = 1; o <= 5; ++o) {
      auto& k = octaves_.emplace_back(std::size_t(4) << o);
      for (double& v : k) v = knot(rng);
    }
  }
  double at(double v) const {
    double sum = 0;
    for (std::size_t o = 0; o < octaves_.size(); ++o) {
      const auto& k = octaves_[o];
      const double x = std::clamp(v, 0.0, 1.0) * double(k.size() - 1);
      const auto i = std::min(std::size_t(x), k.size() - 2);
      const double f = x - double(i);
      sum += std::exp2(-0.7 * double(o + 1)) * ((1 - f) * k[i] + f * k[i + 1]);
    }
    return sum;
  }

 private:
  std::vector<std::vector<double>> octaves_;
};

/// Extinction per voxel of one interval, summing to its tau.
std::vector<float> profile(const RayInterval& r, int first, int count, std::mt19937_64& rng) {
  const ValueNoise noise(rng);
  std::vector<double> values;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double v = ((first + i + 0.5) / kSamples - r.begin) / (r.end - r.begin);
    values.push_back(std::max(0.0, std::pow(std::sin(kPi * std::clamp(v, 0.0, 1.0)), 0.7) * (1 + 2 * noise.at(v)) - 0.15));
    sum += values.back();
  }
  std::vector<float> out;
  for (const double v : values) out.push_back(float(v * r.tau / sum));
  return out;
}

}  // namespace

RayFamily rayFamily(const std::string& name) {
  if (name == "one") return {name, {{0.02, 0.98, 3}}};
  if (name == "two") return {name, {{0.05, 0.12, 1.5}, {0.85, 0.95, 2}}};
  if (name == "three") return {name, {{0.05, 0.10, 1}, {0.40, 0.45, 1}, {0.90, 0.97, 1}}};
  return {"thin+thick", {{0.1, 0.3, 0.4}, {0.70, 0.72, 6}}};
}

Result<RayScene> makeRayScene(const RayFamily& family, int rays, std::uint64_t seed) {
  RayScene scene;
  scene.rays = rays;
  scene.light.towards = dvec3(0, 1, 0);
  std::mt19937_64 rng(seed);
  struct Column {
    double tau = 0;  ///< in front of the interval at hand
  };
  std::vector<Column> columns(std::size_t(rays), Column{});
  double near = 1e9, far = -1e9;
  for (const RayInterval& r : family.intervals) {
    const int first = int(std::ceil(r.begin * kSamples - 0.5)), last = int(std::floor(r.end * kSamples - 0.5)), count = last - first + 1;
    std::vector<std::vector<float>> values;
    for (int i = 0; i < rays; ++i) values.push_back(profile(r, first, count, rng));
    volume::VoxelSource source;
    source.name = family.name;
    // Index y counts down the ray: world y = -(index + 0.5).
    source.worldFromIndex = glm::translate(dmat4(1), dvec3(0, -0.5, 0)) * glm::scale(dmat4(1), dvec3(1, -1, 1));
    source.activeMin = ivec3(0, first, 0);
    source.activeMax = ivec3(rays - 1, last, 0);
    source.fill = [&](ivec3 lo, float* out) {
      for (int z = 0; z < volume::kStoredSize; ++z)
        for (int y = 0; y < volume::kStoredSize; ++y)
          for (int x = 0; x < volume::kStoredSize; ++x) {
            const ivec3 p = lo + ivec3(x, y, z);
            const bool inside = p.x >= 0 && p.x < rays && p.y >= first && p.y <= last && p.z == 0;
            *out++ = inside ? values[std::size_t(p.x)][std::size_t(p.y - first)] : 0.0f;
          }
      return volume::Fill::Voxels;
    };
    JobControl control;
    PILEUS_TRY(const volume::BuildResult built, volume::buildBricks(source, control));
    volume::Instance medium;
    medium.shape = volume::Shape::Grid;
    medium.grid = built.grid;
    medium.worldFromLocal = built.grid->worldFromIndex;
    scene.volumes.push_back(medium);
    for (int i = 0; i < rays; ++i) {
      double& tau = columns[std::size_t(i)].tau;
      float before = 0;
      for (int y = first - 1; y <= last + 1; ++y) {  // linear between voxels: trapezoids are exact
        const float here = volume::voxelAt(*built.grid, ivec3(i, y, 0));
        if (y >= first) tau += 0.5 * (double(before) + double(here));
        before = here;
        if (y < first || y > last) continue;
        scene.positions.push_back(vec4(float(i), -(float(y) + 0.5f), 0.0f, float(i)));
        scene.transmittance.push_back(std::exp(-tau));
      }
    }
    near = std::min(near, double(first) - 0.5);
    far = std::max(far, double(last) + 1.5);
  }
  // u along x and v along z, a texel a metre, texel i centred on ray i; x down the ray.
  scene.frustum.worldFromLight = dmat4(dvec4(scene.resolution, 0, 0, 0), dvec4(0, 0, scene.resolution, 0), dvec4(0, -(far - near), 0, 0), dvec4(-0.5, -near, -0.5, 1));
  return scene;
}

Result<RayError> measure(const shadow::Gpu& gpu, const RayScene& scene, const shadow::MetricOptions& metricOptions, const shadow::ExtinctionOptions& extinctionOptions) {
  shadow::MetricOptions m = metricOptions;
  shadow::ExtinctionOptions e = extinctionOptions;
  m.resolution = e.resolution = scene.resolution;
  shadow::PseudometricPass metric(m, scene.light, scene.volumes, scene.frustum);
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, metric.step(gpu, 1e12));
  }
  shadow::ExtinctionPass extinction(e, metric.map());
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, extinction.step(gpu, 1e12));
  }
  const std::vector<shadow::ShadowedLight> lights{{scene.light, extinction.map()}};
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"test/lookup.comp.glsl"}, shadow::lookupDefines(lights)));
  const gpu::LightRecord record = shadow::makeRecord(scene.light, extinction.map().get());
  gl::Buffer light, in, out;
  light.reserve(MAX_LIGHTS * sizeof record);
  light.assign(&record, sizeof record);
  in.assign(std::span<const vec4>(scene.positions));
  out.reserve(scene.positions.size() * sizeof(float));
  program->use();
  gpu.store.bind();
  light.bindUniform(BIND_LIGHTS);
  in.bindStorage(BIND_TEST_IN);
  out.bindStorage(BIND_TEST_OUT);
  program->set("count", int(scene.positions.size()));
  glDispatchCompute(GLuint((scene.positions.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<float> tau(scene.positions.size());
  glGetNamedBufferSubData(out.id(), 0, GLsizeiptr(tau.size() * sizeof(float)), tau.data());

  struct Sum {
    double square = 0, worst = 0;
    std::size_t n = 0;
  };
  std::vector<Sum> perRay(std::size_t(scene.rays), Sum{});
  RayError error;
  for (std::size_t i = 0; i < tau.size(); ++i) {
    const double d = std::abs(std::exp(-double(tau[i])) - scene.transmittance[i]);
    Sum& s = perRay[std::size_t(scene.positions[i].w)];
    s.square += d * d;
    s.worst = std::max(s.worst, d);
    ++s.n;
    error.mean += d / double(tau.size());
  }
  std::vector<double> worst;
  for (const Sum& s : perRay) {
    error.rms += std::sqrt(s.square / double(std::max<std::size_t>(s.n, 1))) / scene.rays;
    worst.push_back(s.worst);
  }
  std::sort(worst.begin(), worst.end());
  error.p95Max = worst[std::size_t(0.95 * double(worst.size() - 1))];
  return error;
}

}  // namespace pileus::cli
