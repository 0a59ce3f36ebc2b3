#include "renderer/base/byte_stream.h"
#include "renderer/volume/vdb_child.h"

namespace pileus::volume {
namespace {

void encodeGrid(ByteWriter& w, const GridInfo& g) {
  w.put(g.name).put(g.gridClass).put(g.valueType).put(g.transform).put(g.creator).put(g.reason);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) w.put(g.worldFromIndex[c][r]);
  for (int a = 0; a < 3; ++a)
    w.put(g.voxelSize[a])
        .put(g.indexMin[a])
        .put(g.indexMax[a])
        .put(g.worldBounds.min[a])
        .put(g.worldBounds.max[a]);
  w.put(g.activeVoxels).put(g.nonFinite).put(g.memoryBytes).put(g.minimum).put(g.maximum).put(g.background);
  w.put(g.hasBounds).put(g.scalar).put(g.drawable).put(g.damaged);
}

bool takeBool(ByteReader& r) { return r.take<unsigned char>() != 0; }

GridInfo decodeGrid(ByteReader& r) {
  GridInfo g;
  for (std::string* text : {&g.name, &g.gridClass, &g.valueType, &g.transform, &g.creator, &g.reason})
    *text = r.takeText();
  for (int c = 0; c < 4; ++c)
    for (int row = 0; row < 4; ++row) g.worldFromIndex[c][row] = r.take<double>();
  for (int a = 0; a < 3; ++a) {
    g.voxelSize[a] = r.take<double>();
    g.indexMin[a] = r.take<int>();
    g.indexMax[a] = r.take<int>();
    g.worldBounds.min[a] = r.take<double>();
    g.worldBounds.max[a] = r.take<double>();
  }
  g.activeVoxels = r.take<std::uint64_t>();
  g.nonFinite = r.take<std::uint64_t>();
  g.memoryBytes = r.take<std::uint64_t>();
  g.minimum = r.take<double>();
  g.maximum = r.take<double>();
  g.background = r.take<double>();
  g.hasBounds = takeBool(r);
  g.scalar = takeBool(r);
  g.drawable = takeBool(r);
  g.damaged = takeBool(r);
  return g;
}

}  // namespace

std::string encodeInfo(const VdbInfo& info) {
  ByteWriter w;
  w.put(info.version).put(static_cast<std::uint32_t>(info.metadata.size()));
  for (const auto& [key, value] : info.metadata) w.put(key).put(value);
  w.put(static_cast<std::uint32_t>(info.grids.size()));
  for (const GridInfo& g : info.grids) encodeGrid(w, g);
  w.put(info.chosen);
  return w.bytes();
}

std::optional<VdbInfo> decodeInfo(std::string_view bytes) {
  ByteReader r(bytes);
  VdbInfo info;
  info.version = r.takeText();
  for (auto n = r.take<std::uint32_t>(); n > 0 && r.ok(); --n) {
    std::string key = r.takeText();
    info.metadata.emplace_back(std::move(key), r.takeText());
  }
  for (auto n = r.take<std::uint32_t>(); n > 0 && r.ok(); --n) info.grids.push_back(decodeGrid(r));
  info.chosen = r.take<int>();
  if (!r.ok() || !r.done() || info.chosen >= static_cast<int>(info.grids.size())) return std::nullopt;
  return info;
}

}  // namespace pileus::volume
