#pragma once
// Animated parameter values: keys over frames, evaluated at one frame. Plain values.
#include <array>
#include <vector>

#include "nodes/declare/param_value.h"
#include "renderer/base/enum_info.h"

namespace pileus::nodes {

/// How the value travels from a key to the next one.
enum class Interpolation { Constant, Linear, Smooth };
constexpr auto enumInfo(Interpolation*) {
  using I = Interpolation;
  return std::array{EnumItem<I>{I::Constant, "constant", "Constant", "Holds the value until the next key."},
                    EnumItem<I>{I::Linear, "linear", "Linear", "A straight line to the next key."},
                    EnumItem<I>{I::Smooth, "smooth", "Smooth",
                                "Eases out of this key and into the next; never overshoots."}};
}

struct AnimationKey {
  double frame = 1;
  ParamValue value;
  Interpolation interpolation = Interpolation::Smooth;
  bool operator==(const AnimationKey&) const = default;
};

/// At least one key, frames strictly increasing, all values of one kind.
struct Animation {
  std::vector<AnimationKey> keys;
  bool operator==(const Animation&) const = default;
};

/// The first value before the first key, the last one after the last. Integers are rounded; booleans and
/// texts hold.
ParamValue valueAt(const Animation& animation, double frame);

}  // namespace pileus::nodes
