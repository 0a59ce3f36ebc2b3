#include "editor/picture/light_switches.h"

#include <algorithm>

namespace pileus::editor {

bool LightSwitches::off(const std::string& path) const {
  const auto in = [&](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), path) != list.end();
  };
  return in(muted) || (!solo.empty() && !in(solo));
}

void toggle(std::vector<std::string>& list, const std::string& path) {
  if (std::erase(list, path) == 0) list.push_back(path);
}

}  // namespace pileus::editor
