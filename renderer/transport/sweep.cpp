#include "renderer/transport/sweep.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/transport/ordinates.h"

namespace pileus::transport {
namespace {

/// A number for each ordinate of an octant.
using Lanes = float __attribute__((vector_size(kOrdinates * sizeof(float))));

Lanes lanes(const std::array<double, kOrdinates>& v) {
  Lanes out{};
  for (int m = 0; m < kOrdinates; ++m) out[m] = float(v[std::size_t(m)]);
  return out;
}
Lanes all(float v) { return Lanes{} + v; }
float sum(Lanes v) { return (v[0] + v[1]) + (v[2] + v[3]); }
/// Directions of an octant: along each axis cosines with their signs, and faces passed per metre.
struct Octant {
  ivec3 step;
  Lanes x, y, z, perX, perY, perZ, all, weighedX, weighedY, weighedZ;
  Lanes moments[kOrdinates];  ///< of a radiance in that direction: flux, and integral
};

Octant octantOf(int index, double cell) {
  const Ordinates set = ordinates();
  Octant out;
  std::array<double, kOrdinates> axis[3];
  for (int a = 0; a < 3; ++a) {
    out.step[a] = index >> a & 1 ? -1 : 1;
    for (std::size_t m = 0; m < kOrdinates; ++m) axis[a][m] = set.direction[m][a];
  }
  const Lanes x = lanes(axis[0]), y = lanes(axis[1]), z = lanes(axis[2]), w = lanes(set.weight);
  const float per = float(1 / cell);
  out.perX = x * per, out.perY = y * per, out.perZ = z * per;
  out.x = x * float(out.step.x), out.y = y * float(out.step.y), out.z = z * float(out.step.z);
  out.weighedX = w * x, out.weighedY = w * y, out.weighedZ = w * z;
  out.all = out.perX + out.perY + out.perZ;
  for (int m = 0; m < kOrdinates; ++m) out.moments[m] = w[m] * Lanes{out.x[m], out.y[m], out.z[m], 1};
  return out;
}

/// Radiance in the middle of a cell and where it leaves it.
struct Passed {
  Lanes middle, x, y, z;
};

/// What leaves is middle + part (middle - what enters) along each axis: 1 is a diamond, 0 upwind.
inline Passed pass(const Octant& o, Lanes q, float sigma, float part, Lanes x, Lanes y, Lanes z) {
  Passed p;
  p.middle = (q + (1 + part) * (o.perX * x + o.perY * y + o.perZ * z)) / (sigma + (1 + part) * o.all);
  p.x = p.middle + part * (p.middle - x);
  p.y = p.middle + part * (p.middle - y);
  p.z = p.middle + part * (p.middle - z);
  return p;
}

/// The part that is exact, within 2 %, in a uniform slab as thick as the mean way through a cell of that
/// optical depth along an axis: a diamond where it is thin, upwind where it is thick. It does not depend on
/// what is sent, so that all stays linear.
float slabPart(double depth) {
  const double way = std::sqrt(3.0) * depth;
  return float((6 + way) / (6 + way * (2 + way)));
}

constexpr int kGroups = 4;  ///< of two octants each, whose sums are added in their order: any number of
                            ///< threads gives the same bits

}  // namespace

struct Sweep::Work {
  std::vector<Lanes> row, plane;  ///< what enters along y and z, per channel
  std::vector<Lanes> moments;
  std::vector<vec3> received;
  dvec3 leaked{0}, entered{0};
};

Sweep::Sweep(const Cells& cells, int channels) : cells_(cells), channels_(channels) {
  const std::size_t count = cells.lattice.count(), all = std::size_t(channels) * count;
  sources_.resize(all);
  slots_.resize(count);
  std::uint32_t faces = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (cells.cells[i].extinction.w > 0) slots_[i] = std::exchange(faces, faces + kFaces);
  sent_.resize(faces);
  received_.resize(faces);
  parts_.resize(all);
  for (int c = 0; c < channels; ++c)
    for (std::size_t i = 0; i < count; ++i)
      parts_[std::size_t(c) * count + i] =
          slabPart(double(cells.cells[i].extinction[c]) * cells.lattice.cell);
  for (int g = 0; g < kGroups; ++g) {
    work_.push_back(std::make_unique<Work>());
    work_.back()->row.resize(3 * std::size_t(cells.lattice.cells.x));
    work_.back()->plane.resize(3 * std::size_t(cells.lattice.cells.x) * std::size_t(cells.lattice.cells.y));
    work_.back()->moments.resize(all);
    work_.back()->received.resize(faces);
  }
}

Sweep::~Sweep() = default;

double Sweep::spread(double depth) {
  const double b = double(slabPart(depth));
  return (1 - b) / (4 * (1 + b));
}

double Sweep::halfFlux() {
  const Ordinates set = ordinates();
  double sum = 0;
  for (std::size_t m = 0; m < kOrdinates; ++m) sum += 4 * set.weight[m] * set.direction[m].x;
  return sum;
}

void Sweep::run(Moments& moments) {
  const ivec3 n = cells_.lattice.cells;
  const int channels = channels_;
  const std::size_t count = cells_.lattice.count(), texels = std::size_t(channels) * count;
  const double face = cells_.lattice.cell * cells_.lattice.cell;
  const auto sweepOctant = [&](Work& w, const Octant& o) {
    const auto enters = [&](int axis, int c, std::size_t cell, std::size_t cells, Lanes weighed) {
      const std::vector<vec4>& in = incoming_[std::size_t(2 * axis + (o.step[axis] > 0 ? 0 : 1))];
      if (in.empty()) return Lanes{};
      const vec4& m = in[std::size_t(c) * cells + cell];
      const Lanes radiance = m.w + m.x * o.x + m.y * o.y + m.z * o.z,
                  positive = radiance > 0 ? radiance : Lanes{};
      w.entered[c] += face * double(sum(weighed * positive));
      return positive;
    };
    const std::size_t across = std::size_t(n.x), layer = across * std::size_t(n.y);
    for (std::size_t i = 0; i < layer; ++i)
      for (int c = 0; c < channels; ++c) w.plane[3 * i + std::size_t(c)] = enters(2, c, i, layer, o.weighedZ);
    const auto first = [&](int a) { return o.step[a] > 0 ? 0 : n[a] - 1; };
    for (int k = 0, z = first(2); k < n.z; ++k, z += o.step.z) {
      for (std::size_t x = 0; x < across; ++x)
        for (int c = 0; c < channels; ++c)
          w.row[3 * x + std::size_t(c)] =
              enters(1, c, std::size_t(z) * across + x, across * std::size_t(n.z), o.weighedY);
      for (int j = 0, y = first(1); j < n.y; ++j, y += o.step.y) {
        Lanes along[3] = {};
        for (int c = 0; c < channels; ++c)
          along[c] = enters(0, c, std::size_t(z) * std::size_t(n.y) + std::size_t(y),
                            std::size_t(n.y) * std::size_t(n.z), o.weighedX);
        const std::size_t line = (std::size_t(z) * std::size_t(n.y) + std::size_t(y)) * std::size_t(n.x);
        for (int i = 0, x = first(0); i < n.x; ++i, x += o.step.x) {
          const std::size_t at = line + std::size_t(x);
          const Cell& cell = cells_.cells[at];
          const bool solid = cell.extinction.w > 0;
          Lanes* row = &w.row[3 * std::size_t(x)];
          Lanes* plane = &w.plane[3 * (std::size_t(y) * std::size_t(n.x) + std::size_t(x))];
          if (solid) {
            // Light comes in through the faces that it meets, and leaves through those behind.
            const std::size_t faces = slots_[at];
            const int in[3] = {o.step.x > 0 ? 0 : 1, o.step.y > 0 ? 2 : 3, o.step.z > 0 ? 4 : 5};
            const auto take = [&](int axis, const Lanes& weighed, Lanes& radiance, int c) {
              if (isOpen(cell, in[axis]))
                w.received[faces + std::size_t(in[axis])][c] += sum(weighed * radiance);
              radiance = all(sent_[faces + std::size_t(in[axis] ^ 1)][c]);
            };
            for (int c = 0; c < channels; ++c) {
              take(0, o.weighedX, along[c], c);
              take(1, o.weighedY, row[c], c);
              take(2, o.weighedZ, plane[c], c);
            }
          } else {
            for (int c = 0; c < channels; ++c) {
              const vec4& s = sources_[std::size_t(c) * count + at];
              const Lanes q = s.w + s.x * o.x + s.y * o.y + s.z * o.z;
              const Passed p = pass(o, q, cell.extinction[c], parts_[std::size_t(c) * count + at], along[c],
                                    row[c], plane[c]);
              along[c] = p.x, row[c] = p.y, plane[c] = p.z;
              Lanes& m = w.moments[std::size_t(c) * count + at];
              m += (p.middle[0] * o.moments[0] + p.middle[1] * o.moments[1]) +
                   (p.middle[2] * o.moments[2] + p.middle[3] * o.moments[3]);
            }
          }
        }
        for (int c = 0; c < channels; ++c) w.leaked[c] += face * double(sum(o.weighedX * along[c]));
      }
      for (std::size_t x = 0; x < std::size_t(n.x); ++x)
        for (std::size_t c = 0; c < std::size_t(channels); ++c)
          w.leaked[int(c)] += face * double(sum(o.weighedY * w.row[3 * x + c]));
    }
    for (std::size_t i = 0; i < std::size_t(n.x) * std::size_t(n.y); ++i)
      for (std::size_t c = 0; c < std::size_t(channels); ++c)
        w.leaked[int(c)] += face * double(sum(o.weighedZ * w.plane[3 * i + c]));
  };
  tbb::parallel_for(0, kGroups, [&](int g) {
    Work& w = *work_[std::size_t(g)];
    std::fill(w.moments.begin(), w.moments.end(), Lanes{});
    std::fill(w.received.begin(), w.received.end(), vec3(0));
    w.leaked = w.entered = dvec3(0);
    sweepOctant(w, octantOf(g, cells_.lattice.cell));
    sweepOctant(w, octantOf(7 - g, cells_.lattice.cell));
  });
  moments.resize(texels);
  constexpr std::size_t kBlock = 4096;
  tbb::parallel_for(std::size_t(0), (texels + kBlock - 1) / kBlock, [&](std::size_t b) {
    for (std::size_t i = b * kBlock; i < std::min((b + 1) * kBlock, texels); ++i) {
      const Lanes m =
          (work_[0]->moments[i] + work_[1]->moments[i]) + (work_[2]->moments[i] + work_[3]->moments[i]);
      moments[i] = {m[0], m[1], m[2], m[3]};
    }
  });
  leaked_ = entered_ = dvec3(0);
  for (const auto& w : work_) leaked_ += w->leaked, entered_ += w->entered;
  for (std::size_t i = 0; i < received_.size(); ++i)
    received_[i] =
        (work_[0]->received[i] + work_[1]->received[i]) + (work_[2]->received[i] + work_[3]->received[i]);
}

}  // namespace pileus::transport
