#pragma once
// The truth every representation is measured against: optical depth along a segment in double precision on
// the CPU. Regular tracking: a grid is walked cell by cell, and inside a cell the trilinear density is a
// cubic along the ray, which two Gauss points integrate exactly; boxes and balls are exact chords. The medium
// is that of volume::sigmaAt: level 0, dequantised. Densities are taken to be non-negative; where one is
// negative it counts as 0 at the Gauss points, and the cell is no longer exact; a remapped one is cut into
// parts. Any thread.
#include <random>
#include <span>
#include <vector>

#include "renderer/scene/light.h"
#include "renderer/volume/instance.h"

namespace pileus::shadow {

/// Optical depth of the world segment from -> to, the sum over all instances.
double opticalDepth(const volume::InstanceList& instances, const dvec3& from, const dvec3& to);

/// Optical depth from `from` up to each parameter of `at`: 0 is `from`, 1 is `to`; sorted, rising. One walk
/// along the segment however many there are.
std::vector<double> cumulativeOpticalDepth(const volume::InstanceList& instances, const dvec3& from,
                                           const dvec3& to, std::span<const double> at);

/// Optical depth between a world point and the light. Sun: up to where the media end; others: to its
/// position, whatever its cone.
double opticalDepthToLight(const volume::InstanceList& instances, const scene::Light& light,
                           const dvec3& point);

/// One unbiased estimate of exp(-opticalDepth): the product of 1 - sigma / majorant over tentative collisions
/// (Novak, Selle, Jarosz 2014), by point samples alone. The independent check of the above.
double ratioTracking(const volume::InstanceList& instances, const dvec3& from, const dvec3& to,
                     std::mt19937_64& rng);

}  // namespace pileus::shadow
