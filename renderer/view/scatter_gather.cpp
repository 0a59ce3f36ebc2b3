#include "renderer/view/scatter_gather.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/scatter.h"
#include "renderer/view/march_cost.h"
#include "renderer/volume/autofit.h"

namespace pileus::view {
namespace {

constexpr int kLeastCells = 32;                   ///< along the longest edge, if so many are allowed
constexpr int kDispatches = 2 * SCATTER_SAMPLES;  ///< media, lights
constexpr double kTurning = 0.125;  ///< transport depth of a cell: what finer ones would tell is not seen

/// Of the media: where it is, and its densest transport extinction [1/m].
struct Part {
  Box3 box;
  double turning = 0;
  double edge() const {
    const dvec3 size = box.size();
    return std::max({size.x, size.y, size.z});
  }
};

Part joined(Part a, const Part& b) {
  a.box.extend(b.box);
  a.turning = std::max(a.turning, b.turning);
  return a;
}

bool touch(const Box3& a, const Box3& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

transport::Lattice latticeOf(const Part& p, int most) {
  const double wanted = std::ceil(p.edge() * p.turning / kTurning);
  return transport::latticeOver(p.box,
                                int(std::clamp(wanted, double(std::min(kLeastCells, most)), double(most))));
}

bool scatters(const volume::Instance& i) {
  return !i.emission && volume::majorant(i) > 0 &&
         std::max({i.medium.albedo.x, i.medium.albedo.y, i.medium.albedo.z}) > 0;
}

/// Is the cell of edge h with that middle taken up by it?
bool covers(const scene::Solid& solid, const dmat4& localFromWorld, const dvec3& middle, double h) {
  const dvec3 p(localFromWorld * dvec4(middle, 1));
  // Half of the cell along the local axes.
  const glm::dmat3 m(localFromWorld);
  dvec3 half(0);
  for (int a = 0; a < 3; ++a) half += glm::abs(m[a]) * (0.5 * h);
  const bool across = std::abs(p.x) <= 0.5 && std::abs(p.z) <= 0.5;
  return solid.shape == scene::SolidShape::Plane ? across && std::abs(p.y) <= half.y
                                                 : across && std::abs(p.y) <= 0.5;
}

/// Cells that solids take up, with their albedo and open faces.
void markSolids(const scene::SolidList& solids, transport::Cells& out) {
  const transport::Lattice& lattice = out.lattice;
  for (const scene::Solid& s : solids) {
    const dmat4 local = glm::inverse(s.worldFromLocal);
    const Box3 box = scene::worldBounds({s});
    const auto cellOf = [&](const dvec3& p, double room) {
      return ivec3(glm::clamp((p - lattice.min) / lattice.cell + room, dvec3(0), dvec3(lattice.cells)));
    };
    const ivec3 lo = cellOf(box.min, -1), hi = cellOf(box.max, 2);
    for (int z = lo.z; z < hi.z; ++z)
      for (int y = lo.y; y < hi.y; ++y)
        for (int x = lo.x; x < hi.x; ++x) {
          if (!covers(s, local, lattice.min + lattice.cell * (dvec3(x, y, z) + 0.5), lattice.cell)) continue;
          transport::Cell& cell = out.cells[(std::size_t(z) * std::size_t(lattice.cells.y) + std::size_t(y)) *
                                                std::size_t(lattice.cells.x) +
                                            std::size_t(x)];
          cell.extinction.w = 1;
          cell.scattering = vec4(glm::clamp(s.albedo, vec3(0), vec3(1)), 0);
        }
  }
  transport::markOpenFaces(out);
}

/// Joins those that touch, until none do.
void joinTouching(std::vector<Part>& parts) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = parts.size(); j-- > i + 1;) {
        if (!touch(parts[i].box, parts[j].box)) continue;
        parts[i] = joined(parts[i], parts[j]);
        parts.erase(parts.begin() + std::ptrdiff_t(j));
        again = true;
      }
  }
}

/// What of the solids may light the media much: as far away as these are large.
Box3 nearBy(const scene::SolidList& solids, const Part& media) {
  const Box3 all = scene::worldBounds(solids);
  const dvec3 room(media.edge());
  Box3 out{glm::max(all.min, media.box.min - room), glm::min(all.max, media.box.max + room)};
  return out.empty() ? Box3{} : out;
}

}  // namespace

std::vector<transport::Lattice> scatterLattices(const volume::InstanceList& volumes,
                                                const scene::SolidList& solids,
                                                const ScatterOptions& scatter) {
  std::vector<Part> parts;
  Part media;
  for (const volume::Instance& i : volumes) {
    if (!scatters(i)) continue;
    const Box3 box = volume::worldBulkBounds(i);
    if (box.empty()) continue;
    const scene::ScaledPhase scaled = scene::scaledPhase(i.medium.phase);
    parts.push_back({box, volume::majorant(i) * (1 - scaled.forward) * (1 - scaled.cosine)});
    media = joined(media, parts.back());
  }
  if (media.box.empty()) return {};
  Part all = media;
  all.box.extend(nearBy(solids, media));
  std::vector<transport::Lattice> out{latticeOf(all, scatter.cells)};
  // What light turns in over a cell wants finer ones, and so has all that solids made room around; what of
  // that touches belongs together.
  constexpr double kMuchSmaller = 0.7;
  if (media.edge() > kMuchSmaller * all.edge())
    std::erase_if(parts, [&](const Part& p) { return p.turning * out[0].cell <= 2 * kTurning; });
  joinTouching(parts);
  std::erase_if(parts, [&](const Part& p) { return p.edge() > kMuchSmaller * all.edge(); });
  // The largest ones, if there are too many.
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.edge() > b.edge(); });
  for (std::size_t i = 0; i < parts.size() && out.size() < SCATTER_LATTICES; ++i)
    out.push_back(latticeOf(parts[i], scatter.cells));
  return out;
}

ScatterGather::ScatterGather(const transport::Lattice& lattice, const RenderScene& scene, LightSet& lights,
                             bool emission)
    : lattice_(lattice),
      lights_(lights),
      solids_(scene.solids),
      emission_(emission),
      lightScale_(lightDepths(scene, true)) {}

Result<void> ScatterGather::start(const shadow::Gpu& gpu) {
  transport::Cells blank{lattice_, std::vector<transport::Cell>(lattice_.count())};
  markSolids(solids_, blank);
  PILEUS_CHECK(cells_.assign(std::span<const transport::Cell>(blank.cells)));
  std::vector<std::vector<int>> lists(1, std::vector<int>(lights_.drawnVolumes()));
  std::iota(lists[0].begin(), lists[0].end(), 0);
  run_.list(lists);
  budget_.plan(gatherCost(lights_), gpu.device);
  run_.cursor = gl::RegionCursor({lattice_.cells.x, lattice_.cells.y * lattice_.cells.z}, gpu.device);
  sample_ = 0;
  return {};
}

Result<double> ScatterGather::step(const shadow::Gpu& gpu, double ms) {
  if (sample_ >= kDispatches) return 1.0;
  const Stopwatch clock;
  const dvec3 origin = lattice_.min + 0.5 * lattice_.cell * dvec3(lattice_.cells);
  PILEUS_TRY(const residency::Residency residency, run_.prepare(gpu.bricks, lights_.volumes(), ms, origin));
  if (residency.fraction < 1) return 0.1 * residency.fraction;
  if (sample_ < 0) PILEUS_CHECK(start(gpu));
  PILEUS_CHECK(lights_.bind(gpu.store, run_.table(), run_.origin()));
  do {
    PILEUS_TRY(const bool drawn, dispatch(gpu));
    if (!drawn) continue;
    run_.advance();
    if (!run_.cursor.done()) continue;
    run_.cursor.restart();
    ++sample_;
  } while (sample_ < kDispatches && clock.ms() < ms);
  if (sample_ >= kDispatches) return 1.0;
  return std::min(0.1 + 0.9 * (sample_ + run_.cursor.fraction()) / kDispatches, 0.9999);
}

Result<bool> ScatterGather::dispatch(const shadow::Gpu& gpu) {
  gl::Defines defines = lights_.defines();
  for (const auto& [name, value] : run_.defines()) defines.emplace_back(name, value);
  defines.insert(defines.end(),
                 {{"EMISSION", emission_}, {"RESUME", budget_.resumes()}, {"REACHED", budget_.reached()}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"view/scatter_gather.comp.glsl"}, defines));
  PILEUS_CHECK(run_.bind(gpu.bricks, *program));
  cells_.bindStorage(BIND_SCATTER_CELLS);
  program->set("latticeCells", lattice_.cells);
  program->set("latticeMin", vec3(lattice_.min - run_.origin()));
  program->set("latticeCell", float(lattice_.cell));
  program->set("sampleIndex", sample_ % SCATTER_SAMPLES);
  program->set("ofLights", sample_ / SCATTER_SAMPLES);
  program->set("lightCount", std::max(int(lights_.lights().size()), 1));
  program->set("lightScale", lightScale_);
  return run_.dispatch(*program, &budget_);
}

transport::Cells ScatterGather::cells() const {
  transport::Cells out{lattice_, std::vector<transport::Cell>(lattice_.count())};
  glGetNamedBufferSubData(cells_.id(), 0, GLsizeiptr(out.cells.size() * sizeof(transport::Cell)),
                          out.cells.data());
  transport::limitBackward(out);
  transport::thinDense(out);
  return out;
}

}  // namespace pileus::view
