#include "editor/viewport/pixel_probe.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "renderer/view/display.h"

namespace pileus::editor {

TexelFigures texelFigures(std::span<const vec4> texels) {
  TexelFigures out;
  out.texels = texels.size();
  if (texels.empty()) return out;
  out.first = texels.front();
  dvec4 sum(0);
  bool any[4] = {};
  std::size_t counts[4] = {};
  for (const vec4& t : texels)
    for (int c = 0; c < 4; ++c) {
      if (std::isnan(t[c]))
        ++out.nan;
      else if (std::isinf(t[c]))
        ++out.inf;
      else {
        out.min[c] = any[c] ? std::min(out.min[c], t[c]) : t[c];
        out.max[c] = any[c] ? std::max(out.max[c], t[c]) : t[c];
        any[c] = true;
        sum[c] += static_cast<double>(t[c]);
        ++counts[c];
      }
    }
  for (int c = 0; c < 4; ++c)
    out.mean[c] = counts[c] ? static_cast<float>(sum[c] / static_cast<double>(counts[c])) : 0;
  return out;
}

std::string figureText(float value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (value == 0) return "0";
  const float magnitude = std::abs(value);
  if (magnitude < 1e-3f || magnitude >= 1e5f) return fmt::format("{:.2e}", value);
  return magnitude < 10     ? fmt::format("{:.4f}", value)
         : magnitude < 1000 ? fmt::format("{:.2f}", value)
                            : fmt::format("{:.1f}", value);
}

std::string stopsText(float luminance) {
  if (!std::isfinite(luminance)) return "no stops";
  if (luminance <= 0) return "no light";
  const double stops = std::log2(static_cast<double>(luminance) / view::kMiddleGrey);
  return fmt::format("{}{:.2f} stops", stops < 0 ? "\xe2\x88\x92" : "+", std::abs(stops));
}

bool PixelProbe::follow(const std::shared_ptr<const view::Picture>& picture, dvec2 from, dvec2 to) {
  bool fresh = false;
  if (const auto texels = reader_.take()) {
    figures_ = texelFigures(*texels);
    known_ = fresh = true;
  }
  if (!picture) {
    forget();
    return fresh;
  }
  const dvec2 whole(picture->size);
  const ivec2 lo = glm::clamp(ivec2(glm::floor(glm::min(from, to) * whole)), ivec2(0), picture->size - 1);
  const ivec2 hi = glm::clamp(ivec2(glm::floor(glm::max(from, to) * whole)), lo, picture->size - 1);
  const ivec2 size = hi - lo + 1;
  const bool same = asked_.lock() == picture && samples_ == picture->samples &&
                    fraction_ == picture->fraction && lo == lo_ && size == size_;
  if (same || reader_.busy()) return fresh;
  // An area of a picture that still improves is read when a pass is whole: it may be large.
  if (size.x * size.y > 4096 && lo == lo_ && size == size_ && asked_.lock() == picture &&
      samples_ == picture->samples && picture->fraction < 1)
    return fresh;
  asked_ = picture, samples_ = picture->samples, fraction_ = picture->fraction, lo_ = lo, size_ = size;
  reader_.request(picture->color, lo, size);
  return fresh;
}

}  // namespace pileus::editor
