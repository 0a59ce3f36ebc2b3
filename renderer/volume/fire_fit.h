#pragma once
// A first look at fire: which grid glows, what temperatures its values are and how bright it has to be, so
// that it is well exposed beside smoke under a sun.
#include <span>
#include <string>

#include "renderer/volume/emission.h"
#include "renderer/volume/grid_guess.h"
#include "renderer/volume/instance.h"

namespace pileus::volume {

/// Values of a grid and the temperatures they stand for.
struct FireRange {
  double lowest = 0, highest = 1;
  BlackBody body;
};

struct FireFit {
  std::string grid;
  std::string why;  ///< this grid: "by its name"
  Confidence confidence = Confidence::Guess;
  FireRange range;
  bool kelvins = false;  ///< its values are temperatures already
  double brightness =
      0;  ///< radiance that is seen of its brighter parts with that strength [W/(m^2 sr)]; 0: it is empty
};

/// Where values reach this far they are kelvins.
inline constexpr double kLeastKelvins = 200;

/// The grid that glows: temperatures in kelvins first, then flames, then heat of any unit. Null: there is
/// none.
const GridInfo* fireGrid(std::span<const GridInfo> grids);
/// Range, temperatures and strength for a grid that glows, through `smoke` (one grid with its extinction, or
/// null) where there is some; nothing (brightness 0) for an empty or cold one. Name and reason are the
/// caller's.
FireFit fitFire(const GridPtr& grid, const JobControl& control, const Instance* smoke = nullptr,
                double target = 2.0);

/// What such a range means, in a sentence for the node; `most`: the largest value there is.
std::string fireNote(const FireRange& range, double most);

}  // namespace pileus::volume
