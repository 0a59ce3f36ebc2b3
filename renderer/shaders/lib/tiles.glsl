// Lists of volumes per tile of TILE x TILE pixels or texels (count, then fill; no cap). Built on the CPU by residency/tile_lists.
#pragma once
#include "shared/bindings.h"
layout(std430, binding = BIND_TILE_OFFSETS) readonly buffer TileOffsets { int tileOffsets[]; };
layout(std430, binding = BIND_TILE_ITEMS) readonly buffer TileItems { int tileItems[]; };
uniform ivec2 tileGrid;  // tiles across and down
const int kTile = 16;

ivec2 tileRange(ivec2 pixel) {
  ivec2 t = pixel / kTile;
  int i = t.y * tileGrid.x + t.x;
  return ivec2(tileOffsets[i], tileOffsets[i + 1]);
}
