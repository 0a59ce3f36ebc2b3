#pragma once
// `pileus judge FILE`: a graph's picture against an unbiased path tracer.
#include <filesystem>
#include <optional>
#include <string>

#include "renderer/base/math.h"

namespace pileus::cli {

struct JudgeArguments {
  std::filesystem::path file, out;  ///< out: EXR; empty: none
  std::string output;               ///< node; "": the only one
  std::optional<ivec2> size;        ///< nothing: the file's
  std::optional<int> bounces;       ///< nothing: what the picture claims
  int samples = 256;
  double seconds = 0;               ///< 0: no limit
  std::optional<double> maxRelMse;  ///< a larger scaled relMSE is an error
  bool json = false, overwrite = false;
};

/// Prints the figures on standard output, progress and errors on standard error; returns the exit code: 6
/// where scaled relMSE exceeds the bound, or its standard error is above a quarter of it.
int judgeMain(const JudgeArguments& arguments);

}  // namespace pileus::cli
