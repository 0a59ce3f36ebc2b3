#include "renderer/view/picture_scan.h"

#include <algorithm>
#include <cmath>

#include "renderer/view/display.h"

namespace pileus::view {
namespace {

constexpr double kMostTexels = 40000;

int binOf(float value) {
  if (!(value > 0)) return -1;
  const double stops = std::log2(static_cast<double>(value) / kMiddleGrey);
  const double t = (stops - Histogram::kLowest) / (Histogram::kHighest - Histogram::kLowest);
  return t < 0 ? -1 : std::min(static_cast<int>(t * Histogram::kBins), Histogram::kBins - 1);
}

/// All but the outermost hundredths of what is covered.
vec2 depthRange(std::span<const vec4> texels) {
  std::vector<float> depths;
  depths.reserve(texels.size());
  for (const vec4& t : texels)
    if (t.a > 0.01f && std::isfinite(t.r)) depths.push_back(t.r);
  if (depths.empty()) return vec2(0);
  const auto at = [&](double part) {
    const auto n = static_cast<std::ptrdiff_t>(part * static_cast<double>(depths.size() - 1));
    std::nth_element(depths.begin(), depths.begin() + n, depths.end());
    return depths[static_cast<std::size_t>(n)];
  };
  const float near = at(0.01), far = at(0.99);
  return {near, far > near ? far : near * 1.001f + 1e-6f};
}

}  // namespace

ScanResult scanTexels(std::span<const vec4> texels) {
  ScanResult out;
  out.texels = texels.size();
  bool first = true;
  const float each = 1 / static_cast<float>(std::max<std::size_t>(texels.size(), 1));
  for (const vec4& t : texels) {
    if (!std::isfinite(t.r) || !std::isfinite(t.g) || !std::isfinite(t.b) || !std::isfinite(t.a)) {
      ++out.notFinite;
      continue;
    }
    out.lo = first ? t : glm::min(out.lo, t);
    out.hi = first ? t : glm::max(out.hi, t);
    first = false;
    const float values[4] = {t.r, t.g, t.b, glm::dot(vec3(t), kLuminance)};
    for (std::size_t c = 0; c < 4; ++c) {
      const int bin = binOf(values[c]);
      if (bin >= 0)
        out.histogram.parts[c][static_cast<std::size_t>(bin)] += each;
      else if (c == 3)
        out.histogram.black += each;
    }
  }
  out.depth = depthRange(texels);
  return out;
}

bool PictureScan::follow(const std::shared_ptr<const Picture>& picture, double nowMs, double restMs) {
  bool fresh = false;
  if (auto texels = reader_.take()) {
    result_ = scanTexels(*texels);
    fresh = true;
  }
  if (!picture) {
    forget();
    return fresh;
  }
  const bool same = scanned_.lock() == picture;
  if (same && picture->samples == samples_ && picture->fraction == fraction_) return fresh;
  if (reader_.busy() || (picture->fraction < 1 && nowMs - at_ < restMs)) return fresh;
  scanned_ = picture, samples_ = picture->samples, fraction_ = picture->fraction, at_ = nowMs;
  const double by =
      std::max(1.0, std::sqrt(static_cast<double>(picture->size.x) * picture->size.y / kMostTexels));
  const ivec2 size = glm::max(ivec2(dvec2(picture->size) / by), ivec2(1));
  if (!reduced_.color || reduced_.size != size) {
    auto color = gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(size, 1), "reduced picture");
    if (!color) return fresh;
    reduced_.size = size;
    reduced_.color = std::move(*color);
  }
  sample(*picture, reduced_);
  reader_.request(reduced_.color, ivec2(0), size);
  return fresh;
}

}  // namespace pileus::view
