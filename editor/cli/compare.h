#pragma once
// `pileus compare A.exr B.exr`: how far a picture is from a reference.
#include <optional>
#include <string>

namespace pileus::cli {

struct CompareOptions {
  std::string a, b;                 ///< EXR files; b is the reference
  std::optional<double> maxRelMse;  ///< a larger relMSE is an error
};

/// Prints the measures on standard output, errors on standard error; returns the exit code: 0, 3 for a file
/// that cannot be read or compared, 6 where relMSE exceeds the bound.
int compareMain(const CompareOptions& options);

}  // namespace pileus::cli
