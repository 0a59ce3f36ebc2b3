#pragma once
// `pileus info VOLUME [--json]`: what is in a volume file.
#include <filesystem>

namespace pileus::cli {

struct InfoOptions {
  std::filesystem::path file;
  bool json = false;
};

/// Prints to standard output, errors to standard error. Returns the exit code.
int infoMain(const InfoOptions& options);

}  // namespace pileus::cli
