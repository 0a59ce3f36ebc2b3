#pragma once
// Procedural clouds, baked to bricks. Deterministic: equal parameters give equal voxels on every machine.
#include <array>

#include "renderer/base/enum_info.h"
#include "renderer/base/jobs.h"
#include "renderer/base/result.h"
#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

enum class Genus { Cumulus, Stratocumulus, Stratus, Cirrus, Classic };

constexpr auto enumInfo(Genus*) {
  using E = Genus;
  return std::array{
      EnumItem<E>{E::Cumulus, "cumulus", "Cumulus",
                  "Heaps with level bases and cauliflower heads; towers and anvils by breadth and anvil."},
      EnumItem<E>{E::Stratocumulus, "stratocumulus", "Stratocumulus",
                  "A deck of rounded pads with gaps between them."},
      EnumItem<E>{E::Stratus, "stratus", "Stratus", "A level sheet, thicker here and thinner there."},
      EnumItem<E>{E::Cirrus, "cirrus", "Cirrus",
                  "Threads of ice, drawn out by the wind and hooked where they fall."},
      EnumItem<E>{E::Classic, "classic", "Classic",
                  "Heaps of balls, as graphs of format 3 and before have them."}};
}

/// Clouds inside a box. Heights are parts of the box's.
struct CloudParams {
  Genus genus = Genus::Cumulus;
  int seed = 1;
  dvec3 center{0.0, 300.0, 0.0};      ///< metres, of the box
  dvec3 size{1600.0, 600.0, 1600.0};  ///< metres
  double base = 0.1, top = 0.9;       ///< 0..1; not of the classic ones, as are those marked (*)
  double coverage = 0.32;             ///< 0..1, fraction of the ground under cloud
  double breadth = 1.5;   ///< (*) width of the largest cloud, or of a layer's pads and streaks, in heights
  double density = 0.06;  ///< value in the core: with extinction 1, sigma_t in 1/m (cumulus: 0.03 - 0.06)
  double detail = 0.5;    ///< 0..1, erosion of the edges
  double billow = 0.6;    ///< 0..1, strength of the cauliflower bulges
  double wisp = 0.6;      ///< (*) 0..1, shreds at the edges; threads of cirrus
  double anvil = 0;       ///< (*) 0..2, radius of the anvils in radii of their cloud; cumulus
  double shear = 0.15;    ///< wind shear: metres towards +X per metre of height; cumulus: at most 2
  double age = 0.45;      ///< (*) 0 growing .. 1 dissolving
  double wind = 5;        ///< (*) m/s towards +X
  double time = 0;        ///< (*) seconds
  int resolution = 192;   ///< voxels along the longest axis of the box, 16..1024
};

/// All, or all but one (if there is more than one) for what goes on beside it.
enum class Cores { All, LeaveOne };

/// The same field at a lower resolution is a low-pass of that at a higher one, so a coarse bake may stand in
/// for a fine one. Coverage 0 is an empty grid. Errors: Arguments (a parameter out of range, a top that is
/// not above the base), Cancelled (within 50 ms).
Result<GridPtr> bakeCloud(const CloudParams& params, JobControl& control, Cores cores = Cores::All);

}  // namespace pileus::volume
