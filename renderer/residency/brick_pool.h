#pragma once
// Bricks on the GPU: one R8 atlas of 18^3 slots and one page table buffer for all grids. Grids stay resident
// until room is needed; where a scene does not fit the budget, the largest grids are kept at a coarser mip
// (and said so). GL thread only.
#include <span>
#include <unordered_map>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/context.h"
#include "renderer/gl/texture.h"
#include "renderer/shaders/shared/records.h"
#include "renderer/volume/brick_grid.h"

namespace pileus::residency {

/// Where a resident grid's levels are.
struct ResidentGrid {
  std::vector<gpu::LevelRecord> levels;
  int finest = 0;  ///< finest level with voxels on the GPU; sampling clamps to it
};

struct Residency {
  double fraction = 1;  ///< of the bricks wanted; 1 = all there
  int coarsened = 0;    ///< grids kept at a coarser level than 0
  std::size_t wantedBytes = 0, budgetBytes = 0;
};

class BrickPool {
 public:
  BrickPool(const gl::DeviceInfo& device, std::size_t budgetBytes);

  /// Makes the grids resident, uploading for about `ms` milliseconds; call again while fraction < 1. Grids
  /// not named may be evicted. Error (Gpu) where not even the coarsest levels fit.
  Result<Residency> ensure(std::span<const volume::GridPtr> grids, double ms);
  /// Only after ensure() said 1 for it.
  const ResidentGrid* find(const volume::BrickGrid& grid) const;
  /// Binds atlas and pages to their binding points.
  void bind() const;
  ivec3 atlasSize() const { return atlas_.size(); }  ///< texels
  std::size_t bytes() const { return atlas_.bytes(); }
  std::size_t budget() const { return budget_; }
  std::size_t residentBricks() const {
    return std::size_t(slots_.x) * std::size_t(slots_.y) * std::size_t(slots_.z) - free_.size();
  }
  /// Grows with every upload or eviction; part of what a cached record depends on.
  std::uint64_t generation() const { return generation_; }

 private:
  struct Entry {
    volume::GridPtr grid;
    ResidentGrid place;
    int wantedFinest = 0;
    std::vector<std::uint32_t> slotOfPayload;  ///< kConstantBrick: not uploaded
    std::size_t nextPayload = 0;               ///< upload cursor over `order`
    std::vector<std::uint32_t> order;          ///< payload indices to upload, coarse levels first
    std::uint64_t lastUse = 0;
  };
  void release(Entry& entry);
  /// False where the budget has no room. Error (Gpu) where the GPU has none: all stays as it is.
  Result<bool> reserveSlots(std::size_t count);
  Result<void> rebuildTables();

  gl::DeviceInfo device_;
  std::size_t budget_;
  std::size_t maxSlots_ = 0, maxLayers_ = 0;
  ivec3 slots_{0};
  gl::Texture atlas_;
  std::vector<std::uint32_t> free_;  ///< slots free below the atlas's current size, highest first
  std::unordered_map<Key, Entry> entries_;
  gl::Buffer pages_{"brick pages"};
  std::uint64_t clock_ = 0, generation_ = 0;
};

}  // namespace pileus::residency
