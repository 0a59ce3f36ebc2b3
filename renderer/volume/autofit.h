#pragma once
// First looks at a grid: where most of it is, and an extinction where its density has no known unit.
#include "renderer/volume/instance.h"

namespace pileus::volume {

/// Index coordinates: the grid's bounds without strays, which are less than a thousandth of it and lie
/// farther from the rest than that is wide. What is fitted to a volume (shadow maps, cameras, extinctions)
/// is fitted to this, or one voxel set by mistake would blur all of it. Grids without strays, and those of
/// less than 512 voxels, give their bounds. Empty for an empty grid.
Box3 bulkBounds(const BrickGrid& grid);
/// The same of placed volumes: local, and in the world.
Box3 bulkBounds(const Instance& instance);
Box3 worldBulkBounds(const Instance& instance);
Box3 worldBulkBounds(const InstanceList& instances);

struct Autofit {
  double extinction = 1;    ///< 1/m per unit density
  double opticalDepth = 0;  ///< that it gives: the median over rays through the middle; 0 for an empty grid
};

/// Extinction for an optical depth of about `target` through the middle of the grid: the median over rays
/// through the centre of its bulk, along the axes and in well-spread directions. Rays that meet nothing do
/// not count; an empty grid gives extinction 1.
Autofit autofit(const BrickGrid& grid, double target = 6.0);

/// The mip level with some 64 to 128 voxels along the longest axis, which tell enough.
int levelToMeasure(const BrickGrid& grid);

/// Three digits say what is known of a guess, and nodes can be read. 0 for what is not above 0.
double threeDigits(double v);

}  // namespace pileus::volume
