#include "editor/cli/ray_families.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/shadow/reference.h"
#include "renderer/volume/brick_builder.h"

namespace pileus::cli {
namespace {

double uniform(std::mt19937_64& rng, double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(rng);
}

/// Five octaves of linear value noise over [0,1]; octave o has 4 * 2^o random knots.
class ValueNoise {
 public:
  explicit ValueNoise(std::mt19937_64& rng) {
    for (int o = 1; o <= 5; ++o) {
      auto& k = octaves_.emplace_back(std::size_t(4) << o);
      for (double& v : k) v = uniform(rng, -0.5, 0.5);
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

/// Where a medium lies on [0,1], and its optical depth.
struct Interval {
  double begin = 0, end = 1, tau = 1;
};

/// The samples inside [begin, end] of profile(v), v in [0,1].
template <class Profile>
RayMedium sampled(double begin, double end, const Profile& profile) {
  RayMedium m;
  m.first = int(std::ceil(begin * kRaySamples - 0.5));
  const int last = int(std::floor(end * kRaySamples - 0.5));
  for (int i = m.first; i <= last; ++i)
    m.sigma.push_back(
        float(profile(std::clamp(((i + 0.5) / kRaySamples - begin) / (end - begin), 0.0, 1.0))));
  return m;
}

double depthOf(const RayMedium& m) {
  double sum = 0;
  for (const float s : m.sigma) sum += double(s);
  return sum;
}

void scaleBy(RayMedium& m, double factor) {
  for (float& s : m.sigma) s = float(double(s) * factor);
}

RayMedium noisy(const Interval& r, std::mt19937_64& rng) {
  const ValueNoise noise(rng);
  RayMedium m = sampled(r.begin, r.end, [&](double v) {
    return std::max(0.0, std::pow(std::sin(kPi * v), 0.7) * (1 + 2 * noise.at(v)) - 0.15);
  });
  scaleBy(m, r.tau / depthOf(m));
  return m;
}

std::vector<RayMedium> drawEight(std::mt19937_64& rng) {
  std::vector<RayMedium> media;
  for (int i = 0; i < 8; ++i) {
    const double begin = 0.02 + 0.12 * i + uniform(rng, 0, 0.05);
    media.push_back(noisy({begin, begin + 0.03, 0.5}, rng));
  }
  return media;
}

std::vector<RayMedium> drawThreeBoxes(double tau, std::mt19937_64& rng) {
  constexpr int kBoxes = 3;
  double widths[kBoxes], gaps[kBoxes + 1], covered = 0, free = 0;
  for (double& w : widths) covered += w = uniform(rng, 0.5, 1.5);
  for (double& g : gaps) free += g = uniform(rng, 0.05, 1);
  std::vector<RayMedium> media;
  double at = 0, total = 0;
  for (int b = 0; b < kBoxes; ++b) {
    const double begin = at + gaps[b] * 0.9 / free, end = begin + widths[b] * 0.1 / covered;
    at = end;
    const double weight = uniform(rng, 0.3, 1);
    double phase[4];
    for (double& p : phase) p = uniform(rng, 0, 2 * kPi);
    media.push_back(sampled(begin, end, [&](double v) {
      double n = 0;
      for (int k = 0; k < 4; ++k)
        n += std::pow(0.6, k) * std::sin(2 * kPi * 1.7 * std::exp2(k) * v + phase[k]);
      return weight * std::max(0.0, 0.35 + 0.5 * n) * std::min(1.0, 8 * std::min(v, 1 - v));
    }));
    total += depthOf(media.back());
  }
  for (RayMedium& m : media) scaleBy(m, tau / total);
  return media;
}

/// Lattice column and map texel i where `across` stand in a row, `spacing` apart.
ivec2 place(int i, int across, int spacing = 1) { return {i % across * spacing, i / across}; }

/// Rays with volumes of their own stand this far apart in a row. A software rasteriser runs eight texels of a
/// row in step, so that neighbours would all go through each other's loops; llvmpipe ends a shader's loops
/// after 65535 rounds in all.
constexpr int kSpacing = 8;

/// The media `media[i]` of all rays i side by side, each from index y = 0 on.
Result<volume::GridPtr> columnGrid(const std::string& name, std::span<const RayMedium* const> media,
                                   int edge) {
  const int rays = int(media.size());
  std::size_t longest = 0;
  for (const RayMedium* m : media) longest = std::max(longest, m->sigma.size());
  volume::VoxelSource source;
  source.name = name;
  source.activeMax = ivec3(std::min(rays, edge) - 1, int(longest) - 1, (rays - 1) / edge);
  source.fill = [&](ivec3 lo, float* out) {
    for (int z = 0; z < volume::kStoredSize; ++z)
      for (int y = 0; y < volume::kStoredSize; ++y)
        for (int x = 0; x < volume::kStoredSize; ++x) {
          const ivec3 p = lo + ivec3(x, y, z);
          const int i = p.z * edge + p.x;
          const bool inside = p.x >= 0 && p.x < edge && p.z >= 0 && i < rays && p.y >= 0 &&
                              p.y < int(media[std::size_t(i)]->sigma.size());
          *out++ = inside ? media[std::size_t(i)]->sigma[std::size_t(p.y)] : 0.0f;
        }
    return volume::Fill::Voxels;
  };
  JobControl control;
  PILEUS_TRY(const volume::BuildResult built, volume::buildBricks(source, control));
  return built.grid;
}

/// The same voxels within narrower bounds: one column, half a voxel to each side, so that no other ray meets
/// it. It keeps the content key: the bricks are shared.
volume::GridPtr onlyColumn(const volume::GridPtr& grid, ivec2 at, std::size_t length) {
  auto view = std::make_shared<volume::BrickGrid>(*grid);
  view->indexBounds = {dvec3(at.x - 0.5, -1, at.y - 0.5), dvec3(at.x + 0.5, double(length), at.y + 0.5)};
  return view;
}

/// Index y counts down the ray from voxel `first` of it: world y = -(first + index + 0.5). `shift` leads from
/// columns to texels.
volume::Instance placed(const volume::GridPtr& grid, ivec2 shift, int first) {
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = grid;
  i.worldFromLocal =
      glm::translate(dmat4(1), dvec3(shift.x, -0.5 - first, shift.y)) * glm::scale(dmat4(1), dvec3(1, -1, 1));
  return i;
}

/// Medium number m of all rays: one volume if it lies at the same place on each, else one a ray. ofRay: those
/// on each ray.
Result<void> addMedium(RayScene& scene, const std::string& name,
                       const std::vector<std::vector<RayMedium>>& drawn, std::size_t m, bool shared,
                       std::vector<volume::InstanceList>& ofRay) {
  std::vector<const RayMedium*> media;
  for (const auto& ray : drawn) media.push_back(&ray[m]);
  const int across = shared ? scene.resolution : volume::kBrickSize;
  PILEUS_TRY(const volume::GridPtr grid, columnGrid(name, media, across));
  if (shared) scene.volumes.push_back(placed(grid, ivec2(0), media[0]->first));
  for (int i = 0; i < scene.rays; ++i) {
    const RayMedium& medium = *media[std::size_t(i)];
    const ivec2 column = place(i, across);
    if (!shared)
      scene.volumes.push_back(placed(onlyColumn(grid, column, medium.sigma.size()),
                                     scene.texels[std::size_t(i)] - column, medium.first));
    ofRay[std::size_t(i)].push_back(scene.volumes.back());
  }
  return {};
}

/// Adds the voxels of one ray and T there.
void addTruth(RayScene& scene, int ray, const std::vector<RayMedium>& media,
              const volume::InstanceList& volumes) {
  std::vector<double> at;
  const ivec2 texel = scene.texels[std::size_t(ray)];
  const dvec3 top(texel.x, 0, texel.y);
  for (const RayMedium& m : media)
    for (std::size_t y = 0; y < m.sigma.size(); ++y) {
      const double depth = m.first + double(y) + 0.5;
      at.push_back(depth / kRaySamples);
      scene.positions.push_back(vec4(vec3(top - dvec3(0, depth, 0)), float(ray)));
    }
  for (const double tau : shadow::cumulativeOpticalDepth(volumes, top, top - dvec3(0, kRaySamples, 0), at))
    scene.transmittance.push_back(std::exp(-tau));
}

bool samePlaces(const std::vector<RayMedium>& a, const std::vector<RayMedium>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RayMedium& x, const RayMedium& y) {
    return x.first == y.first && x.sigma.size() == y.sigma.size();
  });
}

}  // namespace

RayFamily rayFamily(const std::string& name) {
  const auto fixed = [&](std::vector<Interval> intervals) {
    return RayFamily{name, [intervals](std::mt19937_64& rng) {
                       std::vector<RayMedium> media;
                       for (const Interval& r : intervals) media.push_back(noisy(r, rng));
                       return media;
                     }};
  };
  if (name == "one") return fixed({{0.02, 0.98, 3}});
  if (name == "two") return fixed({{0.05, 0.12, 1.5}, {0.85, 0.95, 2}});
  if (name == "three") return fixed({{0.05, 0.10, 1}, {0.40, 0.45, 1}, {0.90, 0.97, 1}});
  if (name == "eight") return {name, drawEight};
  if (name == "thin+thick") return fixed({{0.1, 0.3, 0.4}, {0.70, 0.72, 6}});
  return {name, nullptr};
}

RayFamily threeBoxes(double tau) {
  return {"3 boxes on 10 %", [tau](std::mt19937_64& rng) { return drawThreeBoxes(tau, rng); }};
}

Result<RayScene> makeRayScene(const RayFamily& family, int rays, std::uint64_t seed) {
  if (!family.draw || rays < 1) return fail(Code::Arguments, "no rays of a family named '{}'", family.name);
  std::mt19937_64 rng(seed);
  std::vector<std::vector<RayMedium>> drawn;
  for (int i = 0; i < rays; ++i) drawn.push_back(family.draw(rng));
  const bool shared =
      std::all_of(drawn.begin(), drawn.end(), [&](const auto& ray) { return samePlaces(ray, drawn[0]); });

  RayScene scene;
  scene.rays = rays;
  scene.light.towards = dvec3(0, 1, 0);
  const int spacing = shared ? 1 : kSpacing;
  while (scene.resolution / spacing * scene.resolution < rays) scene.resolution *= 2;
  for (int i = 0; i < rays; ++i) scene.texels.push_back(place(i, scene.resolution / spacing, spacing));
  // u along x and v along z, texel centres on whole metres; x down the ray.
  const double edge = scene.resolution;
  scene.frustum.worldFromLight = dmat4(dvec4(edge, 0, 0, 0), dvec4(0, 0, edge, 0),
                                       dvec4(0, -kRaySamples, 0, 0), dvec4(-0.5, 0, -0.5, 1));

  std::vector<volume::InstanceList> ofRay(std::size_t(rays), volume::InstanceList{});
  for (std::size_t m = 0; m < drawn[0].size(); ++m)
    PILEUS_CHECK(addMedium(scene, family.name, drawn, m, shared, ofRay));
  for (int i = 0; i < rays; ++i) addTruth(scene, i, drawn[std::size_t(i)], ofRay[std::size_t(i)]);
  return scene;
}

}  // namespace pileus::cli
