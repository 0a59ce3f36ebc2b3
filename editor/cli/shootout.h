#pragma once
// pileus shootout: every shadow representation on a file's own lights.
#include <filesystem>
#include <string>

#include "renderer/base/math.h"
#include "renderer/truth/truth_picture.h"

namespace pileus::cli {

struct ShootoutArguments {
  std::filesystem::path file, out;  ///< out empty: FILE's name with -shootout, in the working folder
  ivec2 size{320, 180};
  int resolution = 512, samples = 4, points = 20000;
  std::string render;                                  ///< node; "": the one that feeds an output
  truth::TruthKind truth = truth::TruthKind::Marched;  ///< of the pictures
  bool overwrite = false;
};

int shootoutMain(const ShootoutArguments& arguments);

}  // namespace pileus::cli
