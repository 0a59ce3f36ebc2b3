#pragma once
// Names of the grids in .vdb files, for lists to choose from. A file is read by a child process, in the
// background, when its names are first wanted; the answer is kept until the file changes.
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "renderer/base/jobs.h"
#include "renderer/volume/vdb_import.h"

namespace pileus::editor {

struct GridNames {
  struct File {
    std::filesystem::file_time_type stamp;
    LooseJob<volume::VdbInfo> job;
  };
  std::map<std::string, File> files;  ///< by absolute path
};

struct GridList {
  bool ready = false;
  std::string error;  ///< why there are none
  struct Item {
    std::string name, about;
    bool drawable = true;
  };
  std::vector<Item> items;
};

/// What is known now; starts to read the file if it has not been read yet.
GridList gridsOf(GridNames& names, const std::filesystem::path& file);

}  // namespace pileus::editor
