#pragma once
// First look at a volume file: which grid, how dense, how large, and what else there is.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/volume/autofit.h"
#include "renderer/volume/fire_fit.h"
#include "renderer/volume/grid_guess.h"

namespace pileus::volume {

struct FileFrames {
  int count = 1;            ///< files of the same name with another number, this one included
  std::string first, last;  ///< their names, by number
};

/// The files beside `path` that differ from it in the last number of their name only.
FileFrames framesBeside(const std::filesystem::path& path);

struct VdbFit {
  std::filesystem::path file;
  GridGuess guess;        ///< of what is drawn as smoke; of fire alone: its grid
  bool byDefault = true;  ///< an import without a grid's name would take the same one
  bool smoke = true;      ///< false: there is fire alone
  Autofit fit;            ///< of smoke
  std::optional<FireFit> fire;
  double voxelSize = 1;  ///< metres
  double longest = 1;    ///< voxels along the longest axis
  Box3 bounds;           ///< world; empty: there is nothing to see
  FileFrames frames;
  std::vector<std::string> warnings;
};

/// Inspects and imports the file (its bricks are kept, so that the node that draws it need not read it
/// again). Errors as importVdb; Input where no grid can be drawn: it says what the file holds.
Result<VdbFit> fitVdb(const std::filesystem::path& path, JobControl& control);

}  // namespace pileus::volume
