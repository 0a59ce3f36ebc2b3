#pragma once
// pileus render: pictures without a window.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::cli {

struct RenderOptions {
  std::filesystem::path file;
  std::string text;           ///< not "": of the graph, which is in no file; `file` is then its name
  std::filesystem::path out;  ///< "-": standard output; empty: the output.exr node's own file
  std::optional<ivec2> size;
  ivec3 frames{0, 0, 1};  ///< first, last, step; 0 0 1 = the file's range
  bool framesGiven = false;
  std::vector<std::string> set;  ///< "Node.param=value"
  std::string output;            ///< node name; empty: the only one
  int gpuMemoryMiB = 0;
  bool overwrite = false, png = false;
  std::filesystem::path stats;
};

int renderMain(const RenderOptions& options);

}  // namespace pileus::cli
