#pragma once
// The layout of what the canvas shows, made anew only where something has changed.
#include <memory>
#include <set>
#include <string>

#include "editor/graph_view/layout/layout.h"

namespace pileus::editor {

struct Canvas;
struct Clock;
struct Session;
struct Settings;

struct LayoutCache {
  std::shared_ptr<const Layout> layout;
  std::uint64_t revision = 0;
  dvec2 moved{0};
  bool moving = false;
  std::set<std::string> raised;
  ThumbnailChoice thumbnails;
  int frame = 1;
};

/// Of shownGraph(). Stays valid while it is held, whatever happens to the document.
std::shared_ptr<const Layout> shownLayout(const Session& session, const Clock& clock,
                                          const Settings& settings, Canvas& canvas);

}  // namespace pileus::editor
