#pragma once
// What every pass that fills a light's map shares: resident volumes, lists of volumes per tile, the light's
// record, and the walk over the map in regions. A point light's six faces stand one below the other in one
// tall map. GL thread.
#include "renderer/residency/region_run.h"
#include "renderer/shadow/gpu.h"
#include "renderer/shadow/light_frustum.h"

namespace pileus::shadow {

struct ShadowMap;

class MapPass {
 public:
  /// `softwareTiles`: of a region on a CPU.
  MapPass(const volume::InstanceList& volumes, const LightFrustum& frustum, int resolution,
          int softwareTiles = 1);

  /// Uploads bricks for about `ms` milliseconds; 1 = all there, and tile lists are built.
  Result<double> prepare(const Gpu& gpu, double ms);
  /// The record of a light with `map` as its shadow, for the shaders of this pass.
  Result<void> bindLight(const ShadowMap& map);
  /// Binds volumes, tiles, store and the uniforms of lib/map_texel.glsl, and dispatches the region at the
  /// cursor in groups of 8 x 8.
  Result<void> dispatch(const Gpu& gpu, gl::Program& program);
  /// The same bindings without a dispatch, for passes that draw.
  Result<void> bind(const Gpu& gpu, gl::Program& program);
  bool done() const { return run_.cursor.done(); }
  void next() { run_.advance(); }  ///< behind all dispatches of a region
  void restart() { run_.cursor.restart(); }
  void finish() { run_.cursor.finish(); }
  double fraction() const { return run_.cursor.fraction(); }
  ivec2 regionOrigin() const {
    return run_.cursor.origin();
  }  ///< in the tall map, of the region at the cursor
  ivec2 regionEnd() const { return run_.cursor.end(); }
  /// Threads of a dispatch over the region at the cursor.
  std::size_t threads() const {
    const ivec2 groups = (regionEnd() - regionOrigin() + 7) / 8;
    return std::size_t(groups.x * 8) * std::size_t(groups.y * 8);
  }
  double takeGpuMs() { return run_.takeGpuMs(); }
  gl::GpuTimer& timer() { return run_.timer(); }

  const volume::InstanceList& volumes() const { return volumes_; }  ///< canonical
  const LightFrustum& frustum() const { return frustum_; }
  /// Shaders count positions from here: the light's own place, or where a sun's map begins.
  dvec3 origin() const { return dvec3(frustum_.worldFromLight[3]); }
  int resolution() const { return resolution_; }
  int faceStride() const {
    return (resolution_ + 15) / 16 * 16;
  }  ///< rows of the tall map from one face to the next
  ivec2 tallSize() const {
    return {resolution_, frustum_.faces() == 1 ? resolution_ : faceStride() * frustum_.faces()};
  }
  int shapes() const { return run_.shapes(); }
  int longestList() const { return run_.longestList(); }
  /// Variant constants of lib/stretch.glsl.
  gl::Defines defines() const { return run_.defines(); }

 private:
  volume::InstanceList volumes_;
  LightFrustum frustum_;
  int resolution_, softwareTiles_;
  residency::RegionRun run_;
  gl::Buffer record_{"light record"};
  bool ready_ = false;
};

/// Steps of the longest march through any one of them at full detail, at most 8192; 64 for exact shapes.
double mostSteps(const volume::InstanceList& volumes);

/// Texels of the tall map each instance may touch, face by face: entry f * n + i is instance i on face f.
std::vector<residency::PixelBounds> mapBounds(const volume::InstanceList& instances,
                                              const LightFrustum& frustum, int resolution, int faceStride);

}  // namespace pileus::shadow
