// Lists of volumes per tile of TILE x TILE pixels or texels (count, then fill; no cap). Built on the CPU by
// residency/tile_lists.
#pragma once
#include "lib/scene_table.glsl"
uniform ivec2 tileGrid;  // tiles across and down
const int kTile = 16;

// Of tileItem().
ivec2 tileRange(ivec2 pixel) {
  ivec2 t = pixel / kTile;
  int i = 4 * sceneSections.x + t.y * tileGrid.x + t.x;
  return 4 * sceneSections.y + ivec2(sceneNumber(i), sceneNumber(i + 1));
}

int tileItem(int i) { return sceneNumber(i); }
