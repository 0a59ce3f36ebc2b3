#pragma once
// Lights that the viewport leaves out, or shows alone. Plain values, never part of the document.
#include <string>
#include <vector>

namespace pileus::editor {

/// Lights that are muted one by one, or not among those that are alone: rendered as if they gave nothing.
struct LightSwitches {
  std::vector<std::string> muted, solo;  ///< paths
  bool any() const { return !muted.empty() || !solo.empty(); }
  bool off(const std::string& path) const;
  bool operator==(const LightSwitches&) const = default;
};
void toggle(std::vector<std::string>& list, const std::string& path);

}  // namespace pileus::editor
