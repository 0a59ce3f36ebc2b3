#pragma once
// How iterates of a linear iteration come to rest sooner than by themselves.
#include <array>
#include <vector>

namespace pileus::transport {

using Vector = std::vector<float>;

/// Anderson 1965 (mixing of type II): of the last few iterates x and what the iteration made of them, g(x),
/// the combination whose change is least.
class Mixing {
 public:
  /// The next x; `weights` of the changes' squares. All of one length, the same each time.
  void next(Vector& x, const Vector& g, const Vector& weights);

 private:
  static constexpr std::size_t kHistory = 5;
  std::array<double, kHistory> least(const Vector& change, const Vector& weights) const;

  std::size_t steps_ = 0;
  std::vector<Vector> changes_, results_;  ///< of one step to the next
  Vector lastChange_, lastResult_;
};

}  // namespace pileus::transport
