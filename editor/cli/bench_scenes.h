#pragma once
// Scenes that tables and tests measure shadow representations on: procedural, from fixed seeds, the same
// everywhere.
#include "renderer/base/result.h"
#include "renderer/shadow/representation.h"
#include "renderer/view/render_scene.h"

namespace pileus::cli {

/// `count` clouds (80 to 180 m) over a square kilometre, in loose groups: some overlap, most are apart. Eight
/// different bakes, turned and scaled. One low sun, no shadows yet. The paper's scene has 76 volumes.
Result<view::RenderScene> cloudField(int count, std::uint64_t seed);

/// Three clouds far apart on the way of the sun, each in the shadow of the ones before; a camera that sees
/// all of them from the side.
Result<view::RenderScene> threeClouds();

/// A representation in a table; `ours`: one of the improved family.
struct TableRow {
  shadow::ShadowSpec spec;
  bool ours = false;
};
/// Every fixed-size representation of at most 32 bytes a texel that Pileus has, then the larger layouts and
/// deep maps.
std::vector<TableRow> representationTable(int resolution);
/// K = 4 intervals in 8 bits and 12 cosines in half floats, no weights, no horizon: 32 bytes.
shadow::ShadowSpec improved32(int resolution);
/// The same with weights and a horizon: 40 bytes.
shadow::ShadowSpec improved40(int resolution);
/// As improved32, with cosines per interval.
shadow::ShadowSpec piecewise32(int resolution);
shadow::ShadowSpec fourierOpacity(int coefficients, int resolution, bool range = false);

}  // namespace pileus::cli
