#pragma once
// Reading .vdb files. The parsing is done by a child process of the same binary under limits (OpenVDB may
// hang, crash or exhaust memory on a hostile file, and cannot be interrupted); cancelling kills the child.
// Imported grids are kept as brick stores in the cache folder, keyed by the file's stamp and the grid, and
// mapped from there; a valid one is used again without a child.
#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/enum_info.h"
#include "renderer/base/import_child.h"
#include "renderer/base/jobs.h"
#include "renderer/base/result.h"
#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

using pileus::ImportLimits;

struct GridInfo {
  std::string name;       ///< unique: the name, or name[i] if several share it
  std::string gridClass;  ///< "fog volume", "level set", "staggered", "unknown"
  std::string
      valueType;  ///< "float", "half" (a float grid saved as half), "double", "int32", "vec3s", "points", ..
  std::string transform;  ///< in words: "uniform scale", "scale and translate", "affine", "frustum", ..
  std::string creator;    ///< from the grid's metadata, or empty
  dmat4 worldFromIndex{1.0};
  dvec3 voxelSize{1.0};             ///< metres
  bool hasBounds = false;           ///< some voxel is active
  ivec3 indexMin{0}, indexMax{-1};  ///< inclusive, of active voxels that count, those beside which others
                                    ///< are nothing; of all where none does
  Box3 worldBounds;                 ///< of these voxels' centres
  std::uint64_t activeVoxels = 0, nonFinite = 0;
  std::uint64_t memoryBytes = 0;    ///< of the tree in memory
  double minimum = 0, maximum = 0;  ///< over active finite voxels; scalar grids only
  double background = 0;
  bool scalar = false;
  bool drawable = false;
  bool damaged = false;  ///< what it says contradicts itself: importing it is an error
  std::string reason;    ///< why not drawable
};

struct VdbInfo {
  std::string version;                                        ///< library and file format, "10.0/224"
  std::vector<std::pair<std::string, std::string>> metadata;  ///< of the file
  std::vector<GridInfo> grids;                                ///< in alphabetical order of their names
  int chosen = -1;  ///< what an empty grid name would import; -1: nothing can be drawn
};

/// What becomes of a grid that holds distances to a surface.
enum class LevelSets { Fog, Ignore };
constexpr auto enumInfo(LevelSets*) {
  return std::array{
      EnumItem<LevelSets>{LevelSets::Fog, "fog", "Fog inside",
                          "Density 0 at the surface, rising to 1 where the level set's band ends inside."},
      EnumItem<LevelSets>{LevelSets::Ignore, "ignore", "Ignore", "Nothing is drawn."}};
}

struct ImportedGrid {
  GridPtr grid;
  std::vector<std::string> warnings;  ///< for the node: empty grid, unknown grids, NaN voxels, ..
  std::vector<std::string> others{};  ///< names of the file's other grids, in alphabetical order
  bool levelSet = false;              ///< the fog was made of one
};

/// Everything in the file. Errors: Input (missing, not a VDB, damaged), Cancelled, Internal (the child could
/// not be run).
Result<VdbInfo> inspectVdb(const std::filesystem::path& path, JobControl& control,
                           const ImportLimits& limits = {});

/// One grid; gridName "" chooses by name and class: a fog volume named density or smoke first, level sets
/// last. A grid that cannot be drawn (points, vectors, a type nobody knows, no active voxels) is an empty
/// grid with a warning. Where the cache cannot be written to, the grid is held in memory, with a warning.
/// Errors: as above; Input also for a grid that is not there (lists those that are), a non-affine transform,
/// an absurd size, a background that would fill it.
Result<ImportedGrid> importVdb(const std::filesystem::path& path, const std::string& gridName,
                               JobControl& control, const ImportLimits& limits = {},
                               LevelSets levelSets = LevelSets::Fog);

}  // namespace pileus::volume
