#include "renderer/residency/brick_pool.h"

#include <algorithm>
#include <bit>

#include "renderer/base/profile.h"
#include "renderer/gl/storage.h"
#include "renderer/shaders/shared/bindings.h"

namespace pileus::residency {
namespace {

using volume::kConstantBrick;
using volume::kStoredSize;
using volume::kStoredVoxels;

/// Slot coordinates, 10 bits each.
std::uint32_t packed(std::uint32_t slot, ivec3 slots) {
  const auto x = std::uint32_t(slots.x), y = std::uint32_t(slots.y);
  return slot % x | (slot / x % y) << 10 | slot / (x * y) << 20;
}

/// Payload bricks of levels finest.. of a grid.
std::size_t payloads(const volume::BrickGrid& grid, int finest) {
  std::size_t n = 0;
  for (std::size_t l = std::size_t(finest); l < grid.levels.size(); ++l)
    for (const volume::Brick& b : grid.levels[l].table) n += b.payload != kConstantBrick;
  return n;
}

/// Entries of the page table, whatever is resident.
std::size_t pages(const volume::BrickGrid& grid) {
  std::size_t n = 0;
  for (const volume::Level& level : grid.levels) n += level.table.size();
  return n;
}

}  // namespace

BrickPool::BrickPool(const gl::DeviceInfo& device, std::size_t budgetBytes)
    : device_(device), budget_(budgetBytes) {
  // Powers of two: texel coordinates then normalise exactly, and a voxel's centre returns the voxel alone.
  // Narrow layers keep growth steps small; wide ones are needed only for large budgets.
  const int most = int(std::bit_floor(unsigned(device.max3dTextureSize)));
  int edge = 256;
  while (edge * 2 <= most && std::size_t(edge) * std::size_t(edge) * std::size_t(most) < budgetBytes)
    edge *= 2;
  slots_ = ivec3(edge / kStoredSize, edge / kStoredSize, 0);
  const std::size_t depth =
      std::bit_floor(std::max<std::size_t>(budgetBytes / (std::size_t(edge) * std::size_t(edge)), 32));
  maxLayers_ = std::min(depth, std::size_t(most)) / kStoredSize;
  maxSlots_ = std::size_t(slots_.x) * std::size_t(slots_.y) * maxLayers_;
}

Result<bool> BrickPool::reserveSlots(std::size_t count) {
  if (free_.size() >= count) return true;
  const std::size_t layer = std::size_t(slots_.x) * std::size_t(slots_.y);
  const std::size_t have = layer * std::size_t(slots_.z), needed = have + (count - free_.size());
  if (needed > maxSlots_) return false;
  const std::size_t depth = std::bit_ceil((needed + layer - 1) / layer * kStoredSize);
  const int edge = int(std::bit_ceil(unsigned(slots_.x * kStoredSize)));
  const std::size_t layers = depth / kStoredSize;
  PILEUS_TRY(gl::Texture grown,
             gl::Texture::create(GL_TEXTURE_3D, GL_R8, ivec3(edge, edge, int(depth)), "brick atlas"));
  grown.filter(GL_LINEAR);
  // llvmpipe filters R8 in 8 bits with CLAMP_TO_EDGE; with a border it filters in float.
  grown.wrap(GL_CLAMP_TO_BORDER);
  if (atlas_)
    glCopyImageSubData(atlas_.id(), GL_TEXTURE_3D, 0, 0, 0, 0, grown.id(), GL_TEXTURE_3D, 0, 0, 0, 0,
                       atlas_.size().x, atlas_.size().y, atlas_.size().z);
  atlas_ = std::move(grown);
  std::vector<std::uint32_t> fresh;
  for (std::size_t s = layers * layer; s-- > have;) fresh.push_back(std::uint32_t(s));
  fresh.insert(fresh.end(), free_.begin(), free_.end());
  free_ = std::move(fresh);
  slots_.z = int(layers);
  return true;
}

void BrickPool::release(Entry& entry) {
  for (const std::uint32_t slot : entry.slotOfPayload)
    if (slot != kConstantBrick) free_.push_back(slot);
  entry.slotOfPayload.clear();
}

Result<Residency> BrickPool::ensure(std::span<const volume::GridPtr> grids, double ms) {
  const Stopwatch clock;
  if (!atlas_) {
    PILEUS_CHECK(reserveSlots(1));
    PILEUS_CHECK(rebuildTables());
  }
  ++clock_;
  std::vector<const volume::BrickGrid*> wanted;
  std::vector<volume::GridPtr> owners;
  for (const volume::GridPtr& g : grids) {
    if (!g || g->empty()) continue;
    if (std::none_of(wanted.begin(), wanted.end(), [&](auto* w) { return w->content == g->content; })) {
      wanted.push_back(g.get());
      owners.push_back(g);
    }
  }
  Residency out;
  out.budgetBytes = maxSlots_ * kStoredVoxels;

  std::size_t wantedPages = 0;
  for (const volume::BrickGrid* grid : wanted) wantedPages += pages(*grid);
  if (wantedPages > device_.maxBufferTexels)
    return fail(
        Code::Gpu,
        "{} grids span {} bricks of 16^3 voxels, empty ones and mips included; the buffer textures of "
        "this OpenGL driver hold {}: use smaller or coarser grids, or fewer",
        wanted.size(), wantedPages, device_.maxBufferTexels);

  // Which level each grid starts at, so that all fit: coarsen whichever needs most.
  std::vector<int> finest(wanted.size(), 0);
  std::vector<std::size_t> need(wanted.size());
  std::size_t total = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) total += need[i] = payloads(*wanted[i], 0);
  out.wantedBytes = total * kStoredVoxels;
  while (total > maxSlots_) {
    std::size_t worst = wanted.size();
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (finest[i] + 1 < int(wanted[i]->levels.size()) && (worst == wanted.size() || need[i] > need[worst]))
        worst = i;
    if (worst == wanted.size())
      return fail(
          Code::Gpu,
          "{} grids do not fit into {} of GPU memory for bricks even at their coarsest level: they need "
          "{} there; use fewer, or raise --gpu-memory",
          wanted.size(), gl::givenMib(out.budgetBytes), gl::neededMib(total * kStoredVoxels));
    total -= need[worst];
    total += need[worst] = payloads(*wanted[worst], ++finest[worst]);
  }

  bool changed = false;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    out.coarsened += finest[i] > 0;
    Entry& e = entries_[wanted[i]->content];
    e.lastUse = clock_;
    if (e.grid && e.wantedFinest == finest[i]) continue;
    release(e);
    e = Entry{owners[i], {}, finest[i], {}, 0, {}, clock_};
    e.slotOfPayload.assign(wanted[i]->payloadCount, kConstantBrick);
    for (std::size_t l = wanted[i]->levels.size(); l-- > std::size_t(finest[i]);)
      for (const volume::Brick& b : wanted[i]->levels[l].table)
        if (b.payload != kConstantBrick) e.order.push_back(b.payload);
    changed = true;
  }
  // Grids that nobody else keeps can never be asked for again.
  for (auto it = entries_.begin(); it != entries_.end();) {
    if (it->second.lastUse == clock_ || it->second.grid.use_count() > 1) {
      ++it;
      continue;
    }
    release(it->second);
    it = entries_.erase(it);
    changed = true;
  }
  // Room: evict the grids unused for longest.
  std::size_t missing = 0;
  for (const auto& [key, e] : entries_)
    if (e.lastUse == clock_) missing += e.order.size() - e.nextPayload;
  std::size_t allPages = 0;
  for (const auto& [key, e] : entries_) allPages += pages(*e.grid);
  while (true) {
    const Result<bool> room = missing > 0 ? reserveSlots(missing) : Result<bool>(true);
    if (room && *room && allPages <= device_.maxBufferTexels) break;
    auto oldest = entries_.end();
    for (auto it = entries_.begin(); it != entries_.end(); ++it)
      if (it->second.lastUse < clock_ &&
          (oldest == entries_.end() || it->second.lastUse < oldest->second.lastUse))
        oldest = it;
    if (oldest == entries_.end()) {
      // What is there stays, and the tables speak of it alone.
      if (changed) PILEUS_CHECK(rebuildTables());
      if (!room) return room.error();
      return fail(Code::Gpu, "the brick pool is full ({})", gl::givenMib(out.budgetBytes));
    }
    allPages -= pages(*oldest->second.grid);
    release(oldest->second);
    entries_.erase(oldest);
    changed = true;
  }

  std::size_t all = 0, done = 0;
  bool moved = false;  // one brick at least, however little time there is
  for (auto& [key, e] : entries_) {
    if (e.lastUse != clock_) continue;
    while (e.nextPayload < e.order.size() && (!moved || clock.ms() < ms)) {
      moved = true;
      const std::uint32_t payload = e.order[e.nextPayload++], slot = free_.back();
      free_.pop_back();
      e.slotOfPayload[payload] = slot;
      const int s = int(slot);
      const ivec3 at =
          kStoredSize * ivec3(s % slots_.x, (s / slots_.x) % slots_.y, s / (slots_.x * slots_.y));
      glTextureSubImage3D(atlas_.id(), 0, at.x, at.y, at.z, kStoredSize, kStoredSize, kStoredSize, GL_RED,
                          GL_UNSIGNED_BYTE, e.grid->payload.get() + std::size_t(payload) * kStoredVoxels);
      changed = true;
    }
    all += e.order.size();
    done += e.nextPayload;
  }
  if (changed) PILEUS_CHECK(rebuildTables());
  out.fraction = all == 0 ? 1.0 : double(done) / double(all);
  return out;
}

Result<void> BrickPool::rebuildTables() {
  ++generation_;
  std::vector<uvec4> pages;
  for (auto& [key, e] : entries_) {
    e.place = {{}, e.wantedFinest};
    for (const volume::Level& level : e.grid->levels) {
      e.place.levels.push_back({ivec4(level.bricks, int(pages.size()))});
      for (const volume::Brick& b : level.table) {
        const bool stored = b.payload != kConstantBrick && e.slotOfPayload[b.payload] != kConstantBrick;
        // A brick that is not resident shows its mean value: only seen below `finest`, where sampling never
        // looks.
        const float offset =
            b.payload == kConstantBrick || stored ? b.offset : 0.5f * (b.minimum + b.maximum);
        pages.push_back(uvec4(stored ? packed(e.slotOfPayload[b.payload], slots_) : PAGE_CONSTANT,
                              std::bit_cast<std::uint32_t>(offset), std::bit_cast<std::uint32_t>(b.scale),
                              std::bit_cast<std::uint32_t>(b.maximum)));
      }
    }
  }
  return pages_.assign(std::span<const uvec4>(pages));
}

const ResidentGrid* BrickPool::find(const volume::BrickGrid& grid) const {
  const auto it = entries_.find(grid.content);
  return it == entries_.end() ? nullptr : &it->second.place;
}

void BrickPool::bind() const {
  glBindTextureUnit(UNIT_ATLAS, atlas_.id());
  pages_.bindTexels(UNIT_PAGES, GL_RGBA32UI);
}

}  // namespace pileus::residency
