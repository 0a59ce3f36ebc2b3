#include "editor/picture/display_color.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "editor/picture/shown.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kMostKnown = 128;

const view::DisplaySettings& settingsOf(const Shown& shown) { return shown.displayed.drawn[0].settings; }

float encoded(float x) {
  x = std::clamp(x, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

std::uint32_t packed(const vec4& c) { return glm::packUnorm4x8({vec3(c), 1}); }

}  // namespace

void updateDisplayColors(const Shown& shown, DisplayColors& colors) {
  const view::DisplaySettings& s = settingsOf(shown);
  std::string transform = s.display + '\n' + s.view + '\n' + s.look;
  if (colors.transform == transform && colors.config.lock() == shown.displayed.colors) return;
  colors.transform = std::move(transform);
  colors.config = shown.displayed.colors;
  colors.known.clear();
  ++colors.revision;
}

void toDisplay(const Shown& shown, std::span<vec4> colors) {
  const view::DisplaySettings& s = settingsOf(shown);
  const auto& config = shown.displayed.colors;
  if (config && config->applyCpu(s.display, s.view, &colors[0].x, colors.size(), s.look)) return;
  if (config && config->applyCpu("", "", &colors[0].x, colors.size())) return;
  for (vec4& c : colors) c = {encoded(c.x), encoded(c.y), encoded(c.z), 1};
}

std::uint32_t displayColor(const Shown& shown, DisplayColors& colors, const dvec3& linear) {
  auto& known = colors.known;
  const auto it = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == linear; });
  if (it != known.end()) return it->second;
  if (known.size() >= kMostKnown) known.clear();
  vec4 color(vec3(linear), 1.0f);
  toDisplay(shown, {&color, 1});
  known.emplace_back(linear, packed(color));
  return known.back().second;
}

}  // namespace pileus::editor
