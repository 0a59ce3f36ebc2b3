#pragma once
// How every pass runs that works through volumes region by region: their bricks made resident, lists of them
// per tile, then for each region a dispatch, or several where its marches pause. On every device; GL thread.
#include <utility>

#include "renderer/gl/gpu_timer.h"
#include "renderer/gl/region_cursor.h"
#include "renderer/residency/march_budget.h"
#include "renderer/residency/tile_lists.h"
#include "renderer/residency/volume_set.h"

namespace pileus::residency {

inline constexpr int kInRegisters =
    4;  ///< volumes of an overlap; the rest is visited one by one at each step

class RegionRun {
 public:
  /// Makes the volumes resident within `ms`; go on once its fraction is 1. `origin` as VolumeSet has it.
  Result<Residency> prepare(BrickPool& bricks, const volume::InstanceList& volumes, double ms,
                            const dvec3& origin, bool peaks = false) {
    return set_.prepare(bricks, volumes, ms, origin, peaks);
  }
  const dvec3& origin() const { return set_.origin(); }
  /// Lists for a picture or map of that size, as TileLists::build() has them.
  void list(ivec2 size, std::span<const PixelBounds> bounds, int items = 0) {
    tiles_.build(table_, size, bounds, items);
  }
  /// Lists that no tile of a picture has.
  void list(std::span<const std::vector<int>> lists) { tiles_.build(table_, lists); }
  /// Makes the program current, with volumes, lists and all else of the table at their binding points.
  Result<void> bind(const BrickPool& bricks, gl::Program& program);
  /// Where shadow items and solids belong, before bind().
  SceneTable& table() { return table_; }
  /// One dispatch in groups of 8 x 8 over pixels [from, to): uniforms regionOrigin and regionEnd, and those
  /// of the budget. Timed and waited for; whatever reads what it wrote may come behind it. False: marches
  /// paused, and the same region has to be dispatched again.
  Result<bool> dispatch(gl::Program& program, ivec2 from, ivec2 to, MarchBudget* budget = nullptr);
  /// The region at the cursor.
  Result<bool> dispatch(gl::Program& program, MarchBudget* budget = nullptr) {
    return dispatch(program, cursor.origin(), cursor.end(), budget);
  }

  gl::RegionCursor cursor;  ///< the caller's to set
  /// Behind all dispatches of the region at the cursor.
  void advance() { cursor.advance(std::exchange(longestMs_, 0.0)); }
  const volume::InstanceList& volumes() const { return set_.instances(); }
  int shapes() const { return set_.shapes(); }
  int longestList() const { return tiles_.longest(); }
  /// Variant constants SHAPES, ACTIVE and OVERFLOW of lib/stretch.glsl.
  gl::Defines defines() const;
  int dispatches() const { return dispatches_; }
  gl::GpuTimer& timer() { return timer_; }
  double takeGpuMs();

 private:
  SceneTable table_;
  VolumeSet set_;
  TileLists tiles_;
  gl::GpuTimer timer_;
  double gpuMs_ = 0, longestMs_ = 0;  ///< the latter of a dispatch of this region
  int dispatches_ = 0;
};

}  // namespace pileus::residency
