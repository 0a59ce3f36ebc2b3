#pragma once
// `pileus compare A.exr B.exr [B2.exr]`: how far a picture is from a reference.
#include <optional>
#include <string>

namespace pileus::cli {

struct CompareOptions {
  std::string a, b;  ///< EXR files; b is the reference
  std::string b2;    ///< the reference's other half, independent of b; empty: there is none
  std::optional<double> maxRelMse, maxScaledRelMse;  ///< what is larger is an error
};

/// Prints the measures on standard output, errors on standard error; returns the exit code: 0, 3 for a file
/// that cannot be read or compared, 6 where relMSE or scaled relMSE exceeds its bound,
/// or two halves are too noisy to tell.
int compareMain(const CompareOptions& options);

}  // namespace pileus::cli
