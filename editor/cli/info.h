#pragma once
// `pileus info VOLUMES [--json]`: what is in volume files.
#include <filesystem>
#include <vector>

namespace pileus::cli {

struct InfoOptions {
  std::vector<std::filesystem::path> files;
  bool json = false;  ///< of several files: a list
};

/// Prints to standard output, errors to standard error. Returns the exit code: of the first file that has an
/// error; the others are listed all the same.
int infoMain(const InfoOptions& options);

}  // namespace pileus::cli
