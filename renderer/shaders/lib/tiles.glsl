// Lists of volumes per tile of TILE x TILE pixels or texels (count, then fill; no cap). Built on the CPU by
// residency/tile_lists.
#pragma once
#include "shared/bindings.h"
layout(binding = UNIT_TILE_OFFSETS) uniform isamplerBuffer tileOffsets;
layout(binding = UNIT_TILE_ITEMS) uniform isamplerBuffer tileItems;
uniform ivec2 tileGrid;  // tiles across and down
const int kTile = 16;

ivec2 tileRange(ivec2 pixel) {
  ivec2 t = pixel / kTile;
  int i = t.y * tileGrid.x + t.x;
  return ivec2(texelFetch(tileOffsets, i).x, texelFetch(tileOffsets, i + 1).x);
}

int tileItem(int i) { return texelFetch(tileItems, i).x; }
