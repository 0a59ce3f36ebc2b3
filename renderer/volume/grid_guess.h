#pragma once
// What the grids of a volume file are for, guessed from their names and classes: other programs agree on
// names only by habit.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/volume/vdb_import.h"

namespace pileus::volume {

enum class GridRole { Density, Temperature, Flame, Fuel, Velocity, Color, Shadow, Unknown };

/// By the name alone, whatever its case and the index in "name[i]": density, smoke, soot; temperature, heat;
/// flames, burn; v, vel, vel.x, velocity; Cd, color.
GridRole roleOfGrid(std::string_view name);

/// How much is to be said for a guess.
enum class Confidence { Sure, Likely, Guess };
std::string_view confidenceText(Confidence confidence);  ///< "sure", "likely", "a guess"

struct GridGuess {
  std::string grid;  ///< "": there is none to draw
  std::string why;   ///< "named density, a fog volume"
  Confidence confidence = Confidence::Guess;
  /// One sentence for each other grid that one might look for: what it seems to be, and that it is not used.
  std::vector<std::string> notes;
};

/// A fog volume called density or smoke, then the first float fog volume that is no heat, then any scalar
/// grid.
GridGuess guessGrid(std::span<const GridInfo> grids);

/// The same sentences from names alone: for a grid that was chosen already.
std::string whyByName(std::string_view chosen);
std::vector<std::string> notesOnOthers(std::span<const std::string> names);

}  // namespace pileus::volume
