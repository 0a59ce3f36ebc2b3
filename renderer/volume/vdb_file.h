#pragma once
// An open .vdb file, parsed in this process: for the import child only (see vdb_import.h). With vdb_damage
// and vdb_tree, the one user of OpenVDB.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "renderer/volume/vdb_import.h"

namespace pileus::volume {

class VdbFile {
 public:
  /// Reads the header. Error (Input): what is wrong with the file; the path is not in the message.
  static Result<std::unique_ptr<VdbFile>> open(const std::filesystem::path& path);
  ~VdbFile();

  /// Reads every grid.
  Result<VdbInfo> info(JobControl& control);
  /// As importVdb.
  Result<ImportedGrid> import(const std::string& gridName, LevelSets levelSets, JobControl& control);

 private:
  VdbFile();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pileus::volume
