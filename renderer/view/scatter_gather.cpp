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

constexpr int kLeastCells = 32;     ///< along the longest edge, if so many are allowed
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

/// Cells that solids take up, with their albedo, and of each the faces that are open: bits in glow.w, their
/// number in extinction.w; a cell without any keeps a 1 there.
void markSolids(const scene::SolidList& solids, transport::Cells& out) {
  const transport::Lattice& lattice = out.lattice;
  const ivec3 n = lattice.cells;
  const auto each = [&](const auto& body) {
    std::size_t i = 0;
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x, ++i) body(ivec3(x, y, z), i);
  };
  for (const scene::Solid& s : solids) {
    const dmat4 local = glm::inverse(s.worldFromLocal);
    each([&](ivec3 p, std::size_t i) {
      if (!covers(s, local, lattice.min + lattice.cell * (dvec3(p) + 0.5), lattice.cell)) return;
      out.cells[i].extinction.w = 1;
      out.cells[i].scattering = vec4(glm::clamp(s.albedo, vec3(0), vec3(1)), 0);
    });
  }
  each([&](ivec3 p, std::size_t i) {
    transport::Cell& cell = out.cells[i];
    if (cell.extinction.w <= 0) return;
    int faces = 0;
    for (int face = 0; face < 6; ++face) {
      ivec3 q = p;
      q[face / 2] += face & 1 ? 1 : -1;
      const bool outside = q[face / 2] < 0 || q[face / 2] >= n[face / 2];
      const std::size_t at =
          (std::size_t(q.z) * std::size_t(n.y) + std::size_t(q.y)) * std::size_t(n.x) + std::size_t(q.x);
      if (outside || out.cells[at].extinction.w <= 0) faces |= 1 << face;
    }
    cell.glow.w = float(faces);
  });
  for (transport::Cell& cell : out.cells)
    if (cell.extinction.w > 0)
      cell.extinction.w = std::max(1.0f, float(__builtin_popcount(unsigned(cell.glow.w))));
}

}  // namespace

std::vector<transport::Lattice> scatterLattices(const volume::InstanceList& volumes,
                                                const ScatterOptions& scatter) {
  std::vector<Part> parts;
  Part all;
  for (const volume::Instance& i : volumes) {
    if (!scatters(i)) continue;
    const Box3 box = volume::worldBulkBounds(i);
    if (box.empty()) continue;
    const scene::ScaledPhase scaled = scene::scaledPhase(i.medium.phase);
    parts.push_back({box, volume::majorant(i) * (1 - scaled.forward) * (1 - scaled.cosine)});
    all = joined(all, parts.back());
  }
  if (all.box.empty()) return {};
  std::vector<transport::Lattice> out{latticeOf(all, scatter.cells)};
  // What light turns in over a cell wants finer ones; what of that touches belongs together.
  std::erase_if(parts, [&](const Part& p) { return p.turning * out[0].cell <= 2 * kTurning; });
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < parts.size() && !again; ++i)
      for (std::size_t j = i + 1; j < parts.size() && !again; ++j)
        if (touch(parts[i].box, parts[j].box)) {
          parts[i] = joined(parts[i], parts[j]);
          parts.erase(parts.begin() + std::ptrdiff_t(j));
          again = true;
        }
  }
  constexpr double kMuchSmaller = 0.7;
  std::erase_if(parts, [&](const Part& p) { return p.edge() > kMuchSmaller * all.edge(); });
  // The largest ones, if there are too many.
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.edge() > b.edge(); });
  for (std::size_t i = 0; i < parts.size() && out.size() < SCATTER_LATTICES; ++i)
    out.push_back(latticeOf(parts[i], scatter.cells));
  return out;
}

vec3 scaledLight(const volume::InstanceList& volumes) {
  dvec3 sum(0);
  double weights = 0;
  for (const volume::Instance& i : volumes) {
    if (!scatters(i)) continue;
    const dvec3 size = volume::worldBulkBounds(i).size();
    const double weight = volume::majorant(i) * std::max(size.x * size.y * size.z, 1e-300);
    sum += weight * (1.0 - dvec3(i.medium.albedo) * scene::scaledPhase(i.medium.phase).forward);
    weights += weight;
  }
  return weights > 0 ? vec3(sum / weights) : vec3(1);
}

ScatterGather::ScatterGather(std::shared_ptr<const RenderScene> scene, const transport::Lattice& lattice,
                             bool emission, std::shared_ptr<KeptSuns> kept)
    : scene_(std::move(scene)),
      lattice_(lattice),
      emission_(emission),
      sampled_(layerLights(*scene_)),
      lightScale_(scaledLight(scene_->volumes)) {
  sampled_.keep(std::move(kept));
}

Result<void> ScatterGather::start(const shadow::Gpu& gpu) {
  transport::Cells blank{lattice_, std::vector<transport::Cell>(lattice_.count())};
  markSolids(scene_->solids, blank);
  PILEUS_CHECK(cells_.assign(std::span<const transport::Cell>(blank.cells)));
  std::vector<std::vector<int>> lists(1, std::vector<int>(lights_->drawnVolumes()));
  std::iota(lists[0].begin(), lists[0].end(), 0);
  run_.list(lists);
  budget_.plan(gatherCost(*lights_), gpu.device);
  run_.cursor = gl::RegionCursor({lattice_.cells.x, lattice_.cells.y * lattice_.cells.z}, gpu.device, 4);
  sample_ = 0;
  return {};
}

Result<double> ScatterGather::step(const shadow::Gpu& gpu, double ms) {
  if (sample_ >= SCATTER_SAMPLES) return 1.0;
  const Stopwatch clock;
  if (!lights_) {
    PILEUS_TRY(const double made, sampled_.make(gpu, std::nullopt, ms));
    if (made < 1) return 0.1 * made;
    lights_.emplace(sampled_.lights(), scene_->volumes, scene_->solids, emission_);
  }
  const dvec3 origin = lattice_.min + 0.5 * lattice_.cell * dvec3(lattice_.cells);
  PILEUS_TRY(const residency::Residency residency, run_.prepare(gpu.bricks, lights_->volumes(), ms, origin));
  if (residency.fraction < 1) return 0.1 + 0.1 * residency.fraction;
  if (sample_ < 0) PILEUS_CHECK(start(gpu));
  PILEUS_CHECK(lights_->bind(gpu.store, run_.table(), run_.origin()));
  do {
    PILEUS_TRY(const bool drawn, dispatch(gpu));
    if (!drawn) continue;
    run_.advance();
    if (!run_.cursor.done()) continue;
    run_.cursor.restart();
    ++sample_;
  } while (sample_ < SCATTER_SAMPLES && clock.ms() < ms);
  return sample_ >= SCATTER_SAMPLES
             ? 1.0
             : std::min(0.2 + 0.8 * (sample_ + run_.cursor.fraction()) / SCATTER_SAMPLES, 0.9999);
}

Result<bool> ScatterGather::dispatch(const shadow::Gpu& gpu) {
  gl::Defines defines = lights_->defines();
  for (const auto& [name, value] : run_.defines()) defines.emplace_back(name, value);
  defines.insert(defines.end(),
                 {{"EMISSION", emission_}, {"RESUME", budget_.resumes()}, {"REACHED", budget_.reached()}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"view/scatter_gather.comp.glsl"}, defines));
  PILEUS_CHECK(run_.bind(gpu.bricks, *program));
  cells_.bindStorage(BIND_SCATTER_CELLS);
  program->set("latticeCells", lattice_.cells);
  program->set("latticeMin", vec3(lattice_.min - run_.origin()));
  program->set("latticeCell", float(lattice_.cell));
  program->set("sampleIndex", sample_);
  program->set("lightCount", std::max(int(lights_->lights().size()), 1));
  program->set("lightScale", lightScale_);
  return run_.dispatch(*program, &budget_);
}

transport::Cells ScatterGather::cells() const {
  transport::Cells out{lattice_, std::vector<transport::Cell>(lattice_.count())};
  glGetNamedBufferSubData(cells_.id(), 0, GLsizeiptr(out.cells.size() * sizeof(transport::Cell)),
                          out.cells.data());
  return out;
}

}  // namespace pileus::view
