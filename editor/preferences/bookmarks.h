#pragma once
// Places of the graph canvas to come back to, nine for each file.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::editor {

/// What files call zoom 0: levels below it came later.
inline constexpr int kLevelOfZoom0 = 10;

struct CanvasPlace {
  std::vector<std::string> scope;  ///< groups from the outermost in; empty: the document itself
  dvec2 center{0};                 ///< canvas units
  int level = 0;                   ///< of zoom, an index of Theme::zoomLevels
  bool operator==(const CanvasPlace&) const = default;
};

struct FileBookmarks {
  std::string path;  ///< of the document; "" = not saved yet, forgotten with it
  std::array<std::optional<CanvasPlace>, 9> places;
  bool operator==(const FileBookmarks&) const = default;
};

}  // namespace pileus::editor
