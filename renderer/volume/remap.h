#pragma once
// What a grid's densities become when they are sampled: a table, straight from entry to entry. The voxels
// stay as they are, so that another table costs no bake and no upload. Immutable once shared. Tables of what
// is emitted (emission.h) are of the same kind.
#include <memory>
#include <vector>

#include "renderer/base/hash.h"
#include "renderer/base/math.h"

namespace pileus::volume {

inline constexpr int kRemapEntries = 256;

struct DensityRemap {
  double lowest = 0, highest = 1;  ///< densities of the first and the last entry, which also hold beyond
  std::vector<vec4> entries;       ///< kRemapEntries; rgb: factor of the albedo, a: density, not negative
  /// Every density up to this becomes 0; minus infinity: not even 0 does. Asked for each brick, so it is
  /// kept.
  double emptyUpTo = 0;
  Key content;  ///< of the above

  /// Twin of remapped() in lib/volume.glsl, in double precision.
  dvec4 at(double density) const;
  double density(double of) const { return at(of).w; }
  /// The largest density that those from .. to become.
  double largest(double from, double to) const;
};

using RemapPtr = std::shared_ptr<const DensityRemap>;

/// `of`: kRemapEntries densities and factors, evenly from lowest to highest; lowest < highest.
RemapPtr makeRemap(double lowest, double highest, std::vector<vec4> of);
/// One after the other, as one table; either may be null.
RemapPtr composed(const RemapPtr& first, const RemapPtr& then);

}  // namespace pileus::volume
