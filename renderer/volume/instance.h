#pragma once
// A placed volume: a brick grid or an exact analytic shape, with its medium. Plain values, shared by every
// pass.
#include <vector>

#include "renderer/scene/medium.h"
#include "renderer/volume/brick_grid.h"
#include "renderer/volume/remap.h"

namespace pileus::volume {

enum class Shape {
  Grid,  ///< local space: the grid's source index coordinates
  Box,   ///< local space: the cube [-0.5, 0.5]^3, uniform inside
  Ball,  ///< local space: the unit ball, uniform inside
};

struct Instance {
  Shape shape = Shape::Box;
  GridPtr grid;    ///< Shape::Grid only
  RemapPtr remap;  ///< Shape::Grid only: what its densities become; null: they stay
  /// What it emits for each of its densities, as makeEmission() has it; null: nothing. One that emits has no
  /// extinction, whatever its medium says: it scatters no light and casts no shadow.
  RemapPtr emission;
  double density = 1;         ///< Box and Ball: the uniform density
  dmat4 worldFromLocal{1.0};  ///< affine; may mirror
  scene::Medium medium;
};

using InstanceList = std::vector<Instance>;

/// Local bounds of the part that can be non-zero; empty for an empty grid.
Box3 localBounds(const Instance& instance);
/// World axis-aligned bounds of one or of all.
Box3 worldBounds(const Instance& instance);
Box3 worldBounds(const InstanceList& instances);
/// Metres: the smallest detail along any axis - a voxel edge, or 1/64 of an analytic shape's smallest extent.
double detailSize(const Instance& instance);
/// Largest density anywhere inside, as remapped; of one that emits: of its voxels.
double largestDensity(const Instance& instance);
/// Does it emit anything, anywhere?
bool emits(const Instance& instance);
/// Can there be anything in a brick of its grid?
bool occupied(const Instance& instance, const Brick& brick);
/// Largest sigma_t [1/m] anywhere inside, of any channel.
double majorant(const Instance& instance);
/// Content key of everything that decides how it looks.
Key contentKey(const InstanceList& instances);
/// sigma_t [1/m] at a world position, mean of its channels, level 0, in double precision: the CPU twin of
/// sigmaAt in lib/volume.glsl.
double sigmaAt(const Instance& instance, const dvec3& world);
/// Radiance gained per metre there [W/(m^3 sr)], in the same way.
dvec3 emissionAt(const Instance& instance, const dvec3& world);

}  // namespace pileus::volume
