#pragma once
// Reading the voxels of an OpenVDB tree: what their values mean, which of them count, and in blocks for the
// brick builder. Templates of vdb_file.cpp, which includes OpenVDB before it: no header of ours does.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "renderer/volume/brick_builder.h"

namespace pileus::volume {

inline ivec3 toIvec(const openvdb::Coord& c) { return {c.x(), c.y(), c.z()}; }

/// Calls f(value, box) for each active tile and f(value, one voxel) for each active voxel.
template <class Tree, class F>
void forActive(const Tree& tree, F&& f) {
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (auto v = leaf->cbeginValueOn(); v; ++v) f(static_cast<double>(*v), std::uint64_t(1));
  auto tile = tree.cbeginValueOn();
  tile.setMaxDepth(Tree::DEPTH - 2);
  for (; tile; ++tile) f(static_cast<double>(*tile), static_cast<std::uint64_t>(tile.getVoxelCount()));
}

struct Range {
  std::uint64_t count = 0, nonFinite = 0;
  double minimum = std::numeric_limits<double>::infinity(), maximum = -minimum;
};

/// What a tree's values are as density.
struct TreeValues {
  double nothing = 0;  ///< values of at most this size do not count: no bounds are made for them
  double band = 0;  ///< of a level set: metres from the surface to the end of its band inside; 0: as stored

  float of(double v) const {
    return static_cast<float>(band > 0 && std::isfinite(v) ? std::clamp(-v / band, 0.0, 1.0) : v);
  }
  bool counts(double v) const {
    const double density = static_cast<double>(of(v));
    return std::isfinite(density) && std::abs(density) > nothing;
  }
};

template <class Tree>
Range rangeOf(const Tree& tree) {
  Range r;
  forActive(tree, [&](double v, std::uint64_t n) {
    r.count += n;
    if (!std::isfinite(v))
      r.nonFinite += n;
    else {
      r.minimum = std::min(r.minimum, v);
      r.maximum = std::max(r.maximum, v);
    }
  });
  if (r.minimum > r.maximum) r.minimum = r.maximum = 0;
  return r;
}

/// Of the active voxels and tiles that count; empty: there are none.
template <class Tree>
openvdb::CoordBBox countingBounds(const Tree& tree, const TreeValues& values) {
  openvdb::CoordBBox bounds;
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) {
    if (bounds.isInside(leaf->getNodeBoundingBox())) continue;
    for (auto v = leaf->cbeginValueOn(); v; ++v)
      if (values.counts(static_cast<double>(*v))) bounds.expand(v.getCoord());
  }
  auto tile = tree.cbeginValueOn();
  tile.setMaxDepth(Tree::DEPTH - 2);
  for (; tile; ++tile) {
    openvdb::CoordBBox box;
    if (values.counts(static_cast<double>(*tile)) && tile.getBoundingBox(box)) bounds.expand(box);
  }
  return bounds;
}

/// Hands blocks of a tree to the brick builder.
template <class Tree>
class TreeBlocks {
 public:
  TreeBlocks(const Tree& tree, const TreeValues& values, ivec3 activeMin, ivec3 activeMax, ivec3 bricks)
      : tree_(tree),
        values_(values),
        background_(static_cast<double>(tree.background())),
        fillsUp_(values.counts(background_)),
        origin_(activeMin - 1),
        bricks_(bricks),
        touched_(std::size_t(bricks.x) * std::size_t(bricks.y) * std::size_t(bricks.z), 0) {
    if (fillsUp_) {
      std::fill(touched_.begin(), touched_.end(), std::uint8_t(1));
      return;
    }
    const openvdb::CoordBBox active(openvdb::Coord(activeMin.x, activeMin.y, activeMin.z),
                                    openvdb::Coord(activeMax.x, activeMax.y, activeMax.z));
    const auto mark = [&](openvdb::CoordBBox box) {
      box.intersect(active);
      if (!box.empty()) markBricks(toIvec(box.min()), toIvec(box.max()));
    };
    for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) mark(leaf->getNodeBoundingBox());
    auto tile = tree.cbeginValueAll();  // an inactive tile may hold a value as well
    tile.setMaxDepth(Tree::DEPTH - 2);
    for (; tile; ++tile) {
      if (valueOf(static_cast<double>(*tile)) == 0.0f) continue;
      openvdb::CoordBBox box;
      tile.getBoundingBox(box);
      mark(box);
    }
  }

  bool touches(ivec3 lo) const { return touched_[flat((lo + kApron - origin_) / kBrickSize)] != 0; }

  Fill fill(ivec3 lo, float* out) const {
    openvdb::tree::ValueAccessor<const Tree, false> access(tree_);
    constexpr int dim = Tree::LeafNodeType::DIM;
    const ivec3 first = (lo >> 3) << 3;
    static_assert(dim == 8);
    constexpr int most = (kStoredSize + dim - 2) / dim + 1;
    const typename Tree::LeafNodeType* leaves[most * most * most];
    float tiles[most * most * most];
    bool uniform = true;
    for (int k = 0, i = 0; k < most; ++k)
      for (int j = 0; j < most; ++j)
        for (int m = 0; m < most; ++m, ++i) {
          const openvdb::Coord at(first.x + m * dim, first.y + j * dim, first.z + k * dim);
          leaves[i] = access.probeConstLeaf(at);
          tiles[i] = leaves[i] ? 0.0f : valueOf(static_cast<double>(access.getValue(at)));
          uniform = uniform && !leaves[i] && tiles[i] == tiles[0];
        }
    if (uniform) {
      out[0] = tiles[0];
      return out[0] == 0 ? Fill::Zero : Fill::Constant;
    }
    for (int z = 0; z < kStoredSize; ++z)
      for (int y = 0; y < kStoredSize; ++y)
        for (int x = 0; x < kStoredSize; ++x) {
          const ivec3 p = lo + ivec3(x, y, z) - first;
          const int i = ((p.z >> 3) * most + (p.y >> 3)) * most + (p.x >> 3);
          const auto offset = static_cast<openvdb::Index>(((p.x & 7) << 6) | ((p.y & 7) << 3) | (p.z & 7));
          *out++ = leaves[i] ? valueOf(static_cast<double>(leaves[i]->getValue(offset))) : tiles[i];
        }
    return Fill::Voxels;
  }

 private:
  std::size_t flat(ivec3 b) const {
    return (std::size_t(b.z) * std::size_t(bricks_.y) + std::size_t(b.y)) * std::size_t(bricks_.x) +
           std::size_t(b.x);
  }
  /// Bricks whose block (own voxels and apron: 16 b - 1 .. 16 b + 16 of the lattice) meets the box.
  void markBricks(ivec3 lowest, ivec3 highest) {
    const ivec3 b0 = glm::max(ivec3(0), (lowest - origin_ - 1) / kBrickSize);
    const ivec3 b1 = glm::min(bricks_ - 1, (highest - origin_ + 1) / kBrickSize);
    for (int z = b0.z; z <= b1.z; ++z)
      for (int y = b0.y; y <= b1.y; ++y)
        for (int x = b0.x; x <= b1.x; ++x) touched_[flat({x, y, z})] = 1;
  }

  /// A background that is nothing is 0: what nobody set shall not make bricks.
  float valueOf(double v) const { return v == background_ && !fillsUp_ ? 0.0f : values_.of(v); }

  const Tree& tree_;
  TreeValues values_;
  double background_;
  bool fillsUp_;  ///< the background counts: every brick holds something
  ivec3 origin_, bricks_;
  std::vector<std::uint8_t> touched_;
};

}  // namespace pileus::volume
