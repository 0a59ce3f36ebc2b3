#include "renderer/transport/solve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/transport/diffusion.h"
#include "renderer/transport/mixing.h"
#include "renderer/transport/sweep.h"

namespace pileus::transport {
namespace {

/// The places where light is sent on, and what is known of it there, of one channel: moments where media
/// scatter, irradiance where solids reflect.
struct Unknowns {
  struct Face {
    std::size_t cell, slot;  ///< of a solid; where sweeps have it
    int face;
  };
  std::vector<std::size_t> media;
  std::vector<Face> faces;

  std::size_t size() const { return 4 * media.size() + faces.size(); }
};

/// What a cell gives by itself in a channel: first collisions, emission, or what its faces send back.
dvec3 givenBy(const Cell& cell) {
  if (cell.extinction.w <= 0)
    return dvec3(cell.first[0].w, cell.first[1].w, cell.first[2].w) + 4 * kPi * dvec3(vec3(cell.glow));
  dvec3 sum(0);
  for (int face = 0; face < kFaces; ++face)
    for (int c = 0; c < 3; ++c) sum[c] += isOpen(cell, face) ? double(sentOf(cell, face, c)) : 0;
  return sum;
}

/// Do media and solids the same to all channels?
bool sameMedia(const Cells& cells) {
  const auto gray = [](const vec4& v) { return v.x == v.y && v.y == v.z; };
  return std::all_of(cells.cells.begin(), cells.cells.end(), [&](const Cell& c) {
    return gray(c.extinction) && gray(c.scattering) && (c.extinction.w > 0 || gray(c.forward));
  });
}

/// What all sources together have of each channel.
vec3 colorOf(const Cells& cells) {
  dvec3 sum(0);
  for (const Cell& c : cells.cells) sum += givenBy(c);
  return vec3(sum / std::max({sum.x, sum.y, sum.z, 1e-300}));
}

/// 1 where one will do: everything is the same in all, but for one colour of all light.
int channelsOf(const Cells& cells, const Solution* around) {
  const vec3 color = colorOf(cells);
  if (!(color.x > 0) || !sameMedia(cells)) return 3;
  if (around && !(around->one && glm::length(around->color - color) < 1e-4f)) return 3;
  const auto fits = [&](const vec3& v) {
    const vec3 off = glm::abs(v - color * (v.x / color.x));
    return std::max({off.x, off.y, off.z}) <= 1e-4f * std::max({v.x, v.y, v.z});
  };
  const bool all = std::all_of(cells.cells.begin(), cells.cells.end(), [&](const Cell& c) {
    if (c.extinction.w <= 0)
      return fits(vec3(c.first[0].w, c.first[1].w, c.first[2].w)) && fits(vec3(c.glow));
    for (int face = 0; face < kFaces; ++face)
      if (!fits({sentOf(c, face, 0), sentOf(c, face, 1), sentOf(c, face, 2)})) return false;
    return true;
  });
  return all ? 1 : 3;
}

bool finite(const vec4& v) { return std::isfinite(v.x + v.y + v.z + v.w); }

class Solver {
 public:
  Solver(const Cells& cells, const SolveOptions& options)
      : cells_(cells),
        options_(options),
        count_(cells.lattice.count()),
        channels_(channelsOf(cells, options.around)),
        sweep_(cells, channels_) {
    for (std::size_t i = 0; i < count_; ++i) {
      const Cell& cell = cells.cells[i];
      if (cell.extinction.w > 0) {
        for (int face = 0; face < kFaces; ++face)
          if (isOpen(cell, face)) unknowns_.faces.push_back({i, sweep_.slot(i) + std::size_t(face), face});
      } else if (cell.scattering.x + cell.scattering.y + cell.scattering.z > 0) {
        unknowns_.media.push_back(i);
      }
    }
  }

  Result<Solution> run(JobControl& control) {
    Solution out;
    out.lattice = cells_.lattice;
    out.color = colorOf(cells_), out.one = channels_ == 1;
    if (options_.around) takeIn(*options_.around);
    out.moments.assign(std::size_t(channels_) * count_, vec4(0));
    for (int c = 0; c < channels_; ++c)
      if (c == 0 || !sameMedia(cells_)) diffusion_.push_back(std::make_unique<Diffusion>(cells_, c));
    begin(out);
    std::array<Vector, 3> x, g, weights;
    std::array<Mixing, 3> mixing;
    for (int c = 0; c < channels_; ++c) {
      for (Vector* v : {&x[std::size_t(c)], &g[std::size_t(c)], &weights[std::size_t(c)]})
        v->assign(unknowns_.size(), 0.0f);
      weigh(c, weights[std::size_t(c)]);
    }
    gather(out.moments, x);
    double first = 0;
    do {
      if (control.cancelled()) return Error{Code::Cancelled, "cancelled"};
      send(x);
      sweep_.run(out.moments);
      gather(out.moments, g);
      out.residual = 0;
      for (std::size_t c = 0; c < std::size_t(channels_); ++c) {
        // With what diffusion still makes of it the change is about as large as the error.
        if (options_.accelerated) correct(c, x[c], g[c]);
        out.residual = std::max(out.residual, changeOf(c, x[c], g[c]));
      }
      ++out.sweeps;
      if (out.sweeps == 1) first = std::max(out.residual, options_.residual * 1.0001);
      control.progress(
          std::clamp(std::log(out.residual / first) / std::log(options_.residual / first), 0.0, 0.99));
      if (out.residual <= options_.residual || out.sweeps >= options_.mostSweeps) break;
      for (std::size_t c = 0; c < std::size_t(channels_); ++c) mixing[c].next(x[c], g[c], weights[c]);
    } while (true);
    account(out);
    spread(out);
    return out;
  }

 private:
  const Diffusion& diffusionOf(std::size_t c) const {
    return *diffusion_[std::min(c, diffusion_.size() - 1)];
  }

  /// What comes in through the faces.
  void takeIn(const Solution& around) {
    const Lattice& lattice = cells_.lattice;
    const ivec3 n = lattice.cells;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2, u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
      std::vector<vec4>& in = sweep_.incoming(face);
      for (int c = 0; c < channels_; ++c)
        for (int j = 0; j < n[v]; ++j)
          for (int i = 0; i < n[u]; ++i) {
            dvec3 p;
            p[u] = i + 0.5, p[v] = j + 0.5, p[axis] = face & 1 ? n[axis] : 0;
            const vec4 m = momentsAt(around, lattice.min + lattice.cell * p, c);
            in.push_back(float(1 / (4 * kPi)) * vec4(3.0f * vec3(m), m.w));
          }
    }
  }

  void begin(Solution& out) {
    if (options_.start.size() == 3 * count_) {
      std::copy_n(options_.start.begin(), out.moments.size(), out.moments.begin());
      return;
    }
    if (!options_.diffusionStart) return;
    std::vector<vec4> sources(count_);
    for (std::size_t c = 0; c < std::size_t(channels_); ++c) {
      for (std::size_t i = 0; i < count_; ++i) {
        const Cell& cell = cells_.cells[i];
        sources[i] = cell.extinction.w > 0
                         ? vec4(0)
                         : cell.first[c] + vec4(vec3(0), float(4 * kPi) * cell.glow[int(c)]);
      }
      const std::span<vec4> moments = std::span(out.moments).subspan(c * count_, count_);
      diffusionOf(c).solve(sources, 1e-3, 20, moments);
      for (vec4& m : moments) {
        m.w = std::max(m.w, 0.0f);
        const float length = glm::length(vec3(m));
        if (length > m.w) m = vec4(vec3(m) * (m.w / length), m.w);
      }
    }
  }

  /// What diffusion makes of a sweep's change.
  void correct(std::size_t c, const Vector& x, Vector& g) {
    sources_.assign(count_, vec4(0)), correction_.resize(count_);
    std::size_t k = 0;
    for (const std::size_t i : unknowns_.media) {
      const Cell& cell = cells_.cells[i];
      sources_[i] = vec4(cell.forward[int(c)] * vec3(g[k] - x[k], g[k + 1] - x[k + 1], g[k + 2] - x[k + 2]),
                         cell.scattering[int(c)] * (g[k + 3] - x[k + 3]));
      k += 4;
    }
    diffusionOf(c).solve(sources_, 0.05, 4, correction_);
    k = 0;
    for (const std::size_t i : unknowns_.media)
      for (int j = 0; j < 4; ++j) g[k++] += correction_[i][j];
  }

  /// One channel for all, by their colours.
  void spread(Solution& out) const {
    if (channels_ == 3) return;
    const vec3 color = colorOf(cells_);
    out.moments.resize(3 * count_);
    for (std::size_t c = 3; c-- > 0;)
      for (std::size_t i = 0; i < count_; ++i)
        out.moments[c * count_ + i] = out.moments[i] * (color[int(c)] / color.x);
    for (dvec3* v : {&out.given, &out.kept, &out.left}) *v = v->x * dvec3(color / color.x);
  }

  /// What is known behind a sweep.
  void gather(const Moments& moments, std::array<Vector, 3>& to) const {
    for (std::size_t c = 0; c < std::size_t(channels_); ++c) {
      std::size_t k = 0;
      for (const std::size_t i : unknowns_.media) {
        const vec4& m = moments[c * count_ + i];
        for (int j = 0; j < 4; ++j) to[c][k++] = m[j];
      }
      for (const Unknowns::Face& f : unknowns_.faces) to[c][k++] = sweep_.received()[f.slot][int(c)];
    }
  }

  /// How much of it goes on.
  void weigh(int c, Vector& weights) const {
    std::size_t k = 0;
    const double face = 1 / cells_.lattice.cell;
    for (const std::size_t i : unknowns_.media)
      for (int j = 0; j < 4; ++j) weights[k++] = cells_.cells[i].scattering[c];
    for (const Unknowns::Face& f : unknowns_.faces)
      weights[k++] = cells_.cells[f.cell].scattering[c] * float(face);
    for (float& w : weights) w *= w;
  }

  double changeOf(std::size_t c, const Vector& x, const Vector& g) const {
    double change = 0, all = 0;
    std::size_t k = 3;
    for (const std::size_t i : unknowns_.media) {
      const double s = double(cells_.cells[i].scattering[int(c)]);
      change += s * std::abs(double(g[k]) - double(x[k])), all += s * std::abs(double(g[k]));
      k += 4;
    }
    k -= 3;
    for (const auto& [i, slot, face] : unknowns_.faces) {
      const double s = double(cells_.cells[i].scattering[int(c)]) / cells_.lattice.cell;
      change += s * std::abs(double(g[k]) - double(x[k])), all += s * std::abs(double(g[k]));
      ++k;
    }
    return all > 0 ? change / all : 0;
  }

  /// Sources of the next sweep.
  void send(const std::array<Vector, 3>& x) {
    const float per = float(1 / (4 * kPi)), flux = float(Sweep::halfFlux());
    for (std::size_t c = 0; c < std::size_t(channels_); ++c) {
      const int channel = int(c);
      for (std::size_t i = 0; i < count_; ++i) {
        const Cell& cell = cells_.cells[i];
        const vec4& first = cell.first[c];
        sweep_.sources()[c * count_ + i] =
            per * vec4(3.0f * vec3(first), first.w) + vec4(vec3(0), cell.glow[channel]);
      }
      std::size_t k = 0;
      for (const std::size_t i : unknowns_.media) {
        const Cell& cell = cells_.cells[i];
        sweep_.sources()[c * count_ + i] +=
            per * vec4(3 * cell.forward[channel] * vec3(x[c][k], x[c][k + 1], x[c][k + 2]),
                       cell.scattering[channel] * x[c][k + 3]);
        k += 4;
      }
      for (const auto& [i, slot, face] : unknowns_.faces) {
        const Cell& cell = cells_.cells[i];
        sweep_.sent()[slot][channel] =
            (cell.scattering[channel] * x[c][k++] + sentOf(cell, face, channel)) / flux;
      }
    }
  }

  void account(Solution& out) const {
    const double h = cells_.lattice.cell, area = h * h, volume = area * h;
    for (int c = 0; c < channels_; ++c) {
      for (std::size_t i = 0; i < count_; ++i) {
        const Cell& cell = cells_.cells[i];
        const bool solid = cell.extinction.w > 0;
        out.given[c] += (solid ? area : volume) * givenBy(cell)[c];
        const double phi = double(out.moments[std::size_t(c) * count_ + i].w);
        if (!solid) out.kept[c] += volume * double(cell.extinction[c] - cell.scattering[c]) * phi;
      }
      for (const Unknowns::Face& f : unknowns_.faces)
        out.kept[c] +=
            area * double(sweep_.received()[f.slot][c]) * (1 - double(cells_.cells[f.cell].scattering[c]));
    }
    out.given += sweep_.entered();
    out.left = sweep_.leaked();
  }

  const Cells& cells_;
  const SolveOptions& options_;
  std::size_t count_;
  int channels_;
  Sweep sweep_;
  Unknowns unknowns_;
  std::vector<std::unique_ptr<Diffusion>> diffusion_;  ///< of each channel, or of all
  std::vector<vec4> sources_, correction_;
};

}  // namespace

vec4 momentsAt(const Solution& solution, const dvec3& p, int channel) {
  const Lattice& l = solution.lattice;
  if (solution.moments.empty()) return vec4(0);
  const dvec3 q = glm::clamp((p - l.min) / l.cell - 0.5, dvec3(0), dvec3(l.cells - 1));
  const ivec3 lo = glm::min(ivec3(q), glm::max(l.cells - 2, ivec3(0)));
  const vec3 part(q - dvec3(lo));
  vec4 sum(0);
  for (int corner = 0; corner < 8; ++corner) {
    const ivec3 at(corner & 1, corner >> 1 & 1, corner >> 2 & 1), cell = glm::min(lo + at, l.cells - 1);
    float weight = 1;
    for (int a = 0; a < 3; ++a) weight *= at[a] ? part[a] : 1 - part[a];
    sum += weight * solution.moments[std::size_t(channel) * l.count() +
                                     (std::size_t(cell.z) * std::size_t(l.cells.y) + std::size_t(cell.y)) *
                                         std::size_t(l.cells.x) +
                                     std::size_t(cell.x)];
  }
  return sum;
}

Result<Solution> solve(const Cells& cells, const SolveOptions& options, JobControl& control) {
  for (const Cell& cell : cells.cells)
    for (const vec4& v : {cell.first[0], cell.first[1], cell.first[2], cell.extinction, cell.scattering,
                          cell.forward, cell.glow})
      if (!finite(v))
        return fail(Code::Input, "what media scatter is not finite: is a light or a volume too bright?");
  if (cells.lattice.count() == 0) {
    Solution none;
    none.lattice = cells.lattice;
    return none;
  }
  Solver solver(cells, options);
  return solver.run(control);
}

}  // namespace pileus::transport
