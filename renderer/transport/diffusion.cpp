#include "renderer/transport/diffusion.h"

#include <algorithm>
#include <cmath>

#include "renderer/transport/sweep.h"

namespace pileus::transport {
namespace {

/// diagonal phi - SUM of what is between it and its neighbours times theirs; symmetric. Arrays have room for
/// a layer of cells in front of the first and behind the last, and what is between the lattice and elsewhere
/// is 0, so that neighbours need no questions.
struct Operator {
  ivec3 cells{0};
  std::size_t count = 0, line = 0, layer = 0;  ///< cells; from one to the next along y and z
  std::vector<float> x, y, z;                  ///< between a cell and the next one along each axis
  std::vector<float> own;       ///< what leaves it for elsewhere: absorbed, or out of the lattice
  std::vector<float> diagonal;  ///< the sum of all of these around it
  std::vector<float> inverse;   ///< 1 / diagonal

  std::size_t padded() const { return count + 2 * layer; }
};

/// The place of a cell in padded arrays.
std::size_t at(const Operator& a, ivec3 p) {
  return a.layer * (std::size_t(p.z) + 1) + a.line * std::size_t(p.y) + std::size_t(p.x);
}

template <class Body>
void forCells(ivec3 n, const Body& body) {
  std::size_t i = 0;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x, ++i) body(ivec3(x, y, z), i);
}

Operator empty(ivec3 cells) {
  Operator a;
  a.cells = cells;
  a.line = std::size_t(cells.x), a.layer = a.line * std::size_t(cells.y);
  a.count = a.layer * std::size_t(cells.z);
  for (std::vector<float>* v : {&a.x, &a.y, &a.z, &a.own}) v->assign(a.padded(), 0.0f);
  return a;
}

void addUp(Operator& a) {
  a.diagonal.assign(a.padded(), 1.0f), a.inverse.assign(a.padded(), 1.0f);
  for (std::size_t i = a.layer; i < a.layer + a.count; ++i) {
    const float sum = a.own[i] + a.x[i] + a.x[i - 1] + a.y[i] + a.y[i - a.line] + a.z[i] + a.z[i - a.layer];
    // Cells that have to do with nothing (solid ones) stay as they are.
    a.diagonal[i] = sum > 0 ? sum : 1.0f;
    a.inverse[i] = 1 / a.diagonal[i];
  }
}

/// Cells joined by eights. Between two of them lie four faces and twice the way.
Operator coarser(const Operator& fine) {
  Operator a = empty((fine.cells + 1) / 2);
  forCells(fine.cells, [&](ivec3 p, std::size_t) {
    const std::size_t to = at(a, p / 2), i = at(fine, p);
    a.own[to] += fine.own[i];
    if (p.x & 1) a.x[to] += 0.5f * fine.x[i];
    if (p.y & 1) a.y[to] += 0.5f * fine.y[i];
    if (p.z & 1) a.z[to] += 0.5f * fine.z[i];
  });
  addUp(a);
  return a;
}

inline float around(const Operator& a, const float* v, std::size_t i) {
  return (a.x[i - 1] * v[i - 1] + a.x[i] * v[i + 1]) +
         (a.y[i - a.line] * v[i - a.line] + a.y[i] * v[i + a.line]) +
         (a.z[i - a.layer] * v[i - a.layer] + a.z[i] * v[i + a.layer]);
}

/// Gauss and Seidel over every other cell.
void smooth(const Operator& a, const std::vector<float>& b, std::vector<float>& v, int color) {
  for (int z = 0; z < a.cells.z; ++z)
    for (int y = 0; y < a.cells.y; ++y) {
      const std::size_t begin = at(a, {0, y, z});
      for (std::size_t i = begin + std::size_t((color + y + z) & 1); i < begin + a.line; i += 2)
        v[i] = (b[i] + around(a, v.data(), i)) * a.inverse[i];
    }
}

/// out = b - a v, and a v where b is null.
void applied(const Operator& a, const float* b, const std::vector<float>& v, std::vector<float>& out) {
  for (std::size_t i = a.layer; i < a.layer + a.count; ++i) {
    const float product = a.diagonal[i] * v[i] - around(a, v.data(), i);
    out[i] = b ? b[i] - product : product;
  }
}

struct Level {
  Operator a;
  std::vector<float> right, value, rest;
};

/// A symmetric V-cycle from nothing: value is about a^-1 right.
void cycle(std::vector<Level>& levels, std::size_t l) {
  Level& here = levels[l];
  std::fill(here.value.begin(), here.value.end(), 0.0f);
  const bool coarsest = l + 1 == levels.size();
  const int times = coarsest ? 16 : 2;
  for (int i = 0; i < times; ++i)
    for (const int color : {0, 1}) smooth(here.a, here.right, here.value, color);
  if (!coarsest) {
    Level& next = levels[l + 1];
    applied(here.a, here.right.data(), here.value, here.rest);
    std::fill(next.right.begin(), next.right.end(), 0.0f);
    forCells(here.a.cells,
             [&](ivec3 p, std::size_t) { next.right[at(next.a, p / 2)] += here.rest[at(here.a, p)]; });
    cycle(levels, l + 1);
    forCells(here.a.cells,
             [&](ivec3 p, std::size_t) { here.value[at(here.a, p)] += next.value[at(next.a, p / 2)]; });
  }
  for (int i = 0; i < times; ++i)
    for (const int color : {1, 0}) smooth(here.a, here.right, here.value, color);
}

double dot(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * double(b[i]);
  return sum;
}

}  // namespace

struct Diffusion::Work {
  Lattice lattice;
  std::vector<Level> levels;
  std::vector<float> d;  ///< diffusion coefficients in cells; 0 in solids
};

Diffusion::Diffusion(const Cells& cells, int c) : work_(std::make_unique<Work>()) {
  const ivec3 n = cells.lattice.cells;
  // Lengths in cells: nothing here is far from one.
  const double h = cells.lattice.cell;
  const int longest = std::max({n.x, n.y, n.z});
  Operator a = empty(n);
  std::vector<float>& d = work_->d;
  d.assign(a.padded(), 0.0f);
  forCells(n, [&](ivec3 p, std::size_t i) {
    const Cell& cell = cells.cells[i];
    const double turning = h * double(cell.extinction[c] - cell.forward[c]);
    const double spread =
        1 / (3 * std::max(turning, 1.0 / longest)) + Sweep::spread(h * double(cell.extinction[c]));
    d[at(a, p)] = cell.extinction.w > 0 ? 0.0f : float(spread);
  });
  std::vector<float>* between[3] = {&a.x, &a.y, &a.z};
  const std::size_t strides[3] = {1, a.line, a.layer};
  forCells(n, [&](ivec3 p, std::size_t cell) {
    const std::size_t i = at(a, p);
    if (d[i] <= 0) return;
    a.own[i] += float(h) * std::max(cells.cells[cell].extinction[c] - cells.cells[cell].scattering[c], 0.0f);
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const std::size_t other = side > 0 ? i + strides[axis] : i - strides[axis];
        const int to = p[axis] + side;
        if (to < 0 || to >= n[axis] || d[other] <= 0)
          a.own[i] += 1 / (2 + 1 / (2 * d[i]));
        else if (side > 0)
          (*between[axis])[i] = 2 * d[i] * d[other] / (d[i] + d[other]);
      }
  });
  addUp(a);
  work_->lattice = cells.lattice;
  work_->levels.push_back({std::move(a), {}, {}, {}});
  while (work_->levels.back().a.count > 64)
    work_->levels.push_back({coarser(work_->levels.back().a), {}, {}, {}});
  for (Level& l : work_->levels)
    for (std::vector<float>* v : {&l.right, &l.value, &l.rest}) v->assign(l.a.padded(), 0.0f);
}

Diffusion::~Diffusion() = default;

void Diffusion::solve(std::span<const vec4> first, double enough, int most, std::span<vec4> moments) const {
  std::vector<Level>& levels = work_->levels;
  const Operator& a = levels[0].a;
  const std::vector<float>& d = work_->d;
  const ivec3 n = a.cells;
  const float h = float(work_->lattice.cell);
  const std::size_t strides[3] = {1, a.line, a.layer};
  const std::vector<float>* between[3] = {&a.x, &a.y, &a.z};
  std::vector<float> rest(a.padded(), 0.0f), value = rest, towards = rest, passed = rest;
  const auto lost = [&](ivec3 p, std::size_t i, int axis, int side) {
    const int to = p[axis] + side;
    return to < 0 || to >= n[axis] || d[side > 0 ? i + strides[axis] : i - strides[axis]] <= 0;
  };
  forCells(n, [&](ivec3 p, std::size_t cell) {
    const std::size_t i = at(a, p);
    if (d[i] <= 0) return;
    rest[i] += h * first[cell].w;
    for (int axis = 0; axis < 3; ++axis) {
      const float own = 1.5f * h * first[cell][axis];
      for (const int side : {-1, 1})
        if (lost(p, i, axis, side)) rest[i] -= float(side) * own / (2 + 1 / (2 * d[i]));
      if (lost(p, i, axis, 1)) continue;
      const std::size_t next = cell + (axis == 0   ? 1
                                       : axis == 1 ? std::size_t(n.x)
                                                   : std::size_t(n.x) * std::size_t(n.y));
      const float flow = (*between[axis])[i] * (own + 1.5f * h * first[next][axis]);
      rest[i] -= flow, rest[i + strides[axis]] += flow;
    }
  });
  const double whole = std::sqrt(dot(rest, rest));
  double before = 0;
  for (int i = 0; i < most && std::sqrt(dot(rest, rest)) > enough * whole; ++i) {
    levels[0].right = rest;
    cycle(levels, 0);
    const std::vector<float>& step = levels[0].value;
    const double now = dot(rest, step), by = before > 0 ? now / before : 0;
    if (!(now > 0)) break;
    for (std::size_t k = 0; k < step.size(); ++k) towards[k] = step[k] + float(by) * towards[k];
    applied(a, nullptr, towards, passed);
    const double length = now / std::max(dot(towards, passed), 1e-300);
    for (std::size_t k = 0; k < value.size(); ++k) {
      value[k] += float(length) * towards[k];
      rest[k] -= float(length) * passed[k];
    }
    before = now;
  }
  forCells(n, [&](ivec3 p, std::size_t cell) {
    const std::size_t i = at(a, p);
    vec3 flow(0.0f);
    for (int axis = 0; d[i] > 0 && axis < 3; ++axis) {
      const float own = 1.5f * h * first[cell][axis];
      const std::size_t stride = axis == 0   ? 1
                                 : axis == 1 ? std::size_t(n.x)
                                             : std::size_t(n.x) * std::size_t(n.y);
      for (const int side : {-1, 1}) {
        if (lost(p, i, axis, side)) {
          flow[axis] += 0.5f * (float(side) * value[i] + own) / (2 + 1 / (2 * d[i]));
        } else {
          const std::size_t other = side > 0 ? i + strides[axis] : i - strides[axis];
          const float across = own + 1.5f * h * first[side > 0 ? cell + stride : cell - stride][axis];
          flow[axis] += 0.5f * (*between[axis])[side > 0 ? i : other] *
                        (float(side) * (value[i] - value[other]) + across);
        }
      }
    }
    moments[cell] = vec4(flow, value[i]);
  });
}

}  // namespace pileus::transport
