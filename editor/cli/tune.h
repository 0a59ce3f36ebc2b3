#pragma once
// pileus tune: the cheapest shadow parameters that keep a bound, written into a copy of the graph.
#include <filesystem>
#include <string>

#include "renderer/truth/tune.h"

namespace pileus::cli {

struct TuneArguments {
  std::filesystem::path file, out;
  truth::TuneGoal goal;
  std::string render;  ///< node; "": the one that feeds an output
  int points = 20000, maxResolution = 2048;
  bool overwrite = false;
};

int tuneMain(const TuneArguments& arguments);

}  // namespace pileus::cli
