#pragma once
// Procedural clouds, baked to bricks. Deterministic: equal parameters give equal voxels on every machine.
#include "renderer/base/jobs.h"
#include "renderer/base/result.h"
#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

/// A field of cumulus clouds inside a box.
struct CloudParams {
  int seed = 1;
  dvec3 center{0.0, 300.0, 0.0};      ///< metres, of the box
  dvec3 size{1600.0, 600.0, 1600.0};  ///< metres
  double coverage = 0.32;             ///< 0..1, fraction of the ground under cloud
  double density = 0.06;  ///< value in the core: with extinction 1, sigma_t in 1/m (cumulus: 0.03 - 0.06)
  double detail = 0.5;    ///< 0..1, erosion of the edges
  double billow = 0.6;    ///< 0..1, strength of the cauliflower bulges
  double shear = 0.15;    ///< wind shear: metres towards +X per metre of height
  int resolution = 192;   ///< voxels along the longest axis of the box, 16..1024
};

/// The same field at a lower resolution is a low-pass of that at a higher one, so a coarse bake may stand in
/// for a fine one. Coverage 0 is an empty grid. Errors: Arguments (a parameter out of range), Cancelled
/// (within 50 ms).
Result<GridPtr> bakeCloud(const CloudParams& params, JobControl& control);

}  // namespace pileus::volume
