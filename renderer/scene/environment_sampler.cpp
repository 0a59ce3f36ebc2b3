#include "renderer/scene/environment_sampler.h"

#include <algorithm>
#include <cmath>

namespace pileus::scene {
namespace {

/// Rising sums of `weights` as shares of their total, which is returned; even where all are 0.
double writeShares(const std::vector<double>& weights, float* out) {
  double total = 0;
  for (const double w : weights) total += w;
  double sum = 0;
  out[0] = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += total > 0 ? weights[i] / total : 1.0 / double(weights.size());
    out[i + 1] = i + 1 == weights.size() ? 1.0f : std::min(float(sum), 1.0f);
  }
  return total;
}

struct Found {
  int cell;
  double inside;  // 0 .. 1
};
/// The cell whose share holds u: never one without any.
Found find(const float* shares, int count, double u) {
  const float* end = shares + count + 1;
  const float* above =
      std::upper_bound(shares + 1, end, u, [](double x, float share) { return x < double(share); });
  if (above == end)  // u rounds to 1: the last that has a share
    for (--above; above > shares + 1 && above[-1] >= *above;) --above;
  const double low = double(above[-1]), high = double(above[0]);
  return {int(above - shares) - 1, high > low ? std::clamp((u - low) / (high - low), 0.0, 1.0) : 0.5};
}

}  // namespace

EnvironmentSampler environmentSampler(const EnvironmentMap& map, ivec2 largest) {
  const EnvironmentMap cells = reduced(map, largest);
  EnvironmentSampler out;
  out.size = cells.size;
  const std::size_t w = std::size_t(cells.size.x), h = std::size_t(cells.size.y);
  if (cells.radiance.empty()) return out;
  out.table.assign(out.densities() + w * h, 0);
  std::vector<double> rows, columns;
  for (std::size_t y = 0; y < h; ++y) {
    columns.clear();
    for (std::size_t x = 0; x < w; ++x) columns.push_back(environmentImportance(cells.at(int(x), int(y))));
    rows.push_back(texelSolidAngle(cells.size, int(y)) *
                   writeShares(columns, out.table.data() + out.columns() + y * (w + 1)));
  }
  if (*std::max_element(rows.begin(), rows.end()) <= 0)
    for (std::size_t y = 0; y < h; ++y) rows[y] = texelSolidAngle(cells.size, int(y));
  writeShares(rows, out.table.data());
  for (std::size_t y = 0; y < h; ++y)
    for (std::size_t x = 0; x < w; ++x) {
      const float* column = out.table.data() + out.columns() + y * (w + 1) + x;
      out.table[out.densities() + y * w + x] =
          float((double(out.table[y + 1]) - double(out.table[y])) * (double(column[1]) - double(column[0])) /
                texelSolidAngle(cells.size, int(y)));
    }
  return out;
}

EnvironmentSample EnvironmentSampler::sample(double a, double b) const {
  const Found row = find(table.data(), size.y, a);
  const std::size_t width = std::size_t(size.x);
  const Found column = find(table.data() + columns() + std::size_t(row.cell) * (width + 1), size.x, b);
  // Even in the sine of the elevation, from the nearer pole, where 1 - sine keeps its digits.
  const auto fromPole = [&](int y) {
    const double half = std::sin(kPi / 2 * y / size.y);
    return 2 * half * half;
  };
  const bool lower = 2 * row.cell >= size.y;
  const double from = lower ? fromPole(size.y - row.cell) : fromPole(row.cell),
               to = lower ? fromPole(size.y - row.cell - 1) : fromPole(row.cell + 1);
  const double q = glm::mix(from, to, row.inside), across = std::sqrt(q * (2 - q));
  const double azimuth = (0.5 - (column.cell + column.inside) / size.x) * 2 * kPi;
  return {{across * std::sin(azimuth), lower ? q - 1 : 1 - q, across * std::cos(azimuth)},
          double(table[densities() + std::size_t(row.cell) * width + std::size_t(column.cell)])};
}

double EnvironmentSampler::pdf(const dvec3& direction) const {
  const dvec2 p = environmentUv(direction) * dvec2(size);
  const std::size_t x = std::size_t(std::min(int(p.x), size.x - 1)),
                    y = std::size_t(std::min(int(p.y), size.y - 1));
  return double(table[densities() + y * std::size_t(size.x) + x]);
}

}  // namespace pileus::scene
