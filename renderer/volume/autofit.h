#pragma once
// A first extinction for a grid whose density has no known unit.
#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

struct Autofit {
  double extinction = 1;    ///< 1/m per unit density
  double opticalDepth = 0;  ///< that it gives: the median over rays through the middle; 0 for an empty grid
};

/// Extinction for an optical depth of about `target` through the middle of the grid: the median over rays
/// through the centre of its bounds, along the axes and in well-spread directions. Rays that meet nothing do
/// not count; an empty grid gives extinction 1.
Autofit autofit(const BrickGrid& grid, double target = 6.0);

/// The mip level with some 64 to 128 voxels along the longest axis, which tell enough.
int levelToMeasure(const BrickGrid& grid);

/// Three digits say what is known of a guess, and nodes can be read. 0 for what is not above 0.
double threeDigits(double v);

}  // namespace pileus::volume
