#include "renderer/truth/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "renderer/truth/compare.h"

namespace pileus::truth {
namespace {

using image::Canvas;
using image::Face;

constexpr vec3 kBackground(0.086f), kTile(0.129f), kRule(0.22f), kDim(0.58f), kText(0.93f),
    kAccent(0.55f, 0.78f, 1.0f);
constexpr int kColumns = 6, kMargin = 40, kGap = 20, kPad = 10, kHeader = 118, kGroupHeader = 62,
              kCaption = 84;
constexpr int kLeastContent = 300;    ///< pixels the text of a tile takes
constexpr double kFullColour = 0.25;  ///< of the truth's 99th percentile of luminance
constexpr std::size_t kBarSteps = 220;

/// Luminance of linear ACEScg (AP1).
double luminance(const float* p) {
  return 0.2722287 * double(p[0]) + 0.6740818 * double(p[1]) + 0.0536895 * double(p[2]);
}

struct Grid {
  ivec2 picture;
  int columns;
  int content() const { return std::max(picture.x, kLeastContent); }
  ivec2 tile() const { return {content() + 2 * kPad, 2 * picture.y + kCaption + 2 * kPad + 4}; }
  int rows(std::size_t n) const { return (int(n) + columns - 1) / columns; }
  int height(std::size_t n) const { return kGroupHeader + rows(n) * (tile().y + kGap); }
  ivec2 origin(int top, std::size_t i) const {
    return {kMargin + int(i) % columns * (tile().x + kGap),
            top + kGroupHeader + int(i) / columns * (tile().y + kGap)};
  }
};

Result<std::vector<float>> displayed(const image::Image& picture, const image::ColorConfig& config,
                                     const SheetOptions& o) {
  std::vector<float> rgba = picture.layers.front().pixels;
  const float gain = float(std::exp2(o.exposure));
  for (std::size_t i = 0; i < rgba.size(); ++i)
    if (i % 4 != 3) rgba[i] *= gain;
  PILEUS_CHECK(config.applyCpu(o.display, o.view, rgba.data(), rgba.size() / 4));
  return rgba;
}

double white(const image::Image& truth) {
  const std::vector<float>& p = truth.layers.front().pixels;
  std::vector<double> lit;
  for (std::size_t i = 0; i + 3 < p.size(); i += 4)
    if (p[i + 3] > 0.01f) lit.push_back(luminance(&p[i]));
  if (lit.empty()) return 1;
  const auto at = lit.begin() + std::ptrdiff_t(0.99 * double(lit.size() - 1));
  std::nth_element(lit.begin(), at, lit.end());
  return std::max(*at, 1e-12);
}

std::vector<float> difference(const image::Image& picture, const image::Image& truth, double scale) {
  const std::vector<float>&a = picture.layers.front().pixels, &b = truth.layers.front().pixels;
  std::vector<float> out(a.size(), 1.0f);
  for (std::size_t i = 0; i + 3 < a.size(); i += 4) {
    const vec3 c = signedColor((luminance(&a[i]) - luminance(&b[i])) / scale);
    for (int k = 0; k < 3; ++k) out[i + std::size_t(k)] = c[k];
  }
  return out;
}

void right(Canvas& canvas, dvec2 at, Face face, double em, vec3 color, const std::string& text) {
  image::drawText(canvas, {at.x - image::textWidth(face, em, text), at.y}, face, em, color, text);
}

std::string megabytes(std::size_t bytes) { return fmt::format("{:.2f} MiB", double(bytes) / (1 << 20)); }

std::string milliseconds(double ms) {
  return ms < 10 ? fmt::format("{:.2f} ms", ms) : fmt::format("{:.0f} ms", ms);
}

void drawTile(Canvas& canvas, ivec2 origin, const Grid& grid, const ShootoutEntry& e,
              const std::vector<float>& picture, const std::vector<float>& diff, bool best) {
  canvas.fill(origin, grid.tile(), kTile);
  if (best) canvas.fill(origin, {grid.tile().x, 2}, kAccent);
  const int left = origin.x + kPad, top = origin.y + kPad, end = left + grid.content();
  const ShadowMeasure& m = e.worst();
  image::drawText(canvas, {double(left), top + 15.0}, Face::Bold, 15, kText,
                  image::fitText(Face::Bold, 15, e.name, grid.content()));
  const auto row = [&](int line, const std::string& a, const std::string& b, vec3 color) {
    image::drawText(canvas, {double(left), top + 18.0 + 18.0 * line}, Face::Mono, 12, color, a);
    right(canvas, {double(end), top + 18.0 + 18.0 * line}, Face::Mono, 12, color, b);
  };
  row(1, fmt::format("mean {:.4f}  p95 {:.3f}", m.error.mean, m.error.p95),
      fmt::format("max {:.2f}", m.error.maximum), best ? kAccent : kText);
  if (e.bytes() > 0) {
    const bool whole = m.bytesPerTexel == std::floor(m.bytesPerTexel);
    row(2, fmt::format("{}\u00b2  {:.{}f} B", shadow::resolutionOf(m.spec), m.bytesPerTexel, whole ? 0 : 1),
        megabytes(e.bytes()), kDim);
    row(3, fmt::format("{:.0f} ns a lookup", m.nsPerLookup), milliseconds(e.buildMs()), kDim);
  } else {
    row(2, "no map", "", kDim);
    row(3, fmt::format("{:.0f} ns a lookup", m.nsPerLookup), "", kDim);
  }
  const ivec2 at(left + (grid.content() - grid.picture.x) / 2, top + kCaption);
  canvas.paste(at, grid.picture, picture);
  canvas.paste(at + ivec2(0, grid.picture.y + 4), grid.picture, diff);
  right(canvas, {at.x + grid.picture.x - 6.0, at.y + 2.0 * grid.picture.y - 3}, Face::Mono, 11, kDim,
        fmt::format("relMSE {:.2e}", e.relMse));
}

void drawHeader(Canvas& canvas, const SheetOptions& o) {
  image::drawText(canvas, {double(kMargin), 56}, Face::Bold, 28, kText, o.title);
  image::drawText(canvas, {double(kMargin), 84}, Face::Regular, 15, kDim, o.subtitle);
  const int end = canvas.size.x - kMargin, begin = end - int(kBarSteps), top = 42;
  for (int i = 0; i < int(kBarSteps); ++i)
    canvas.fill({begin + i, top}, {1, 14}, signedColor(2.0 * i / double(kBarSteps - 1) - 1));
  image::drawText(canvas, {double(begin), top + 32.0}, Face::Regular, 13, kDim, "too dark");
  right(canvas, {double(end), top + 32.0}, Face::Regular, 13, kDim, "light leaks");
  right(canvas, {begin - 16.0, top + 12.0}, Face::Regular, 13, kDim,
        fmt::format("picture \u2212 truth, full colour at \u00b1{:.0f} % of white", 100 * kFullColour));
}

void drawGroupHeader(Canvas& canvas, int top, const std::string& name, const std::string& text) {
  canvas.fill({kMargin, top + 8}, {canvas.size.x - 2 * kMargin, 1}, kRule);
  image::drawText(canvas, {double(kMargin), top + 42.0}, Face::Bold, 19, kText, name);
  image::drawText(canvas, {kMargin + image::textWidth(Face::Bold, 19, name) + 16, top + 42.0}, Face::Regular,
                  15, kDim, text);
}

}  // namespace

vec3 signedColor(double v) { return falseColour(std::copysign(std::sqrt(std::min(std::abs(v), 1.0)), v)); }

Result<image::Canvas> contactSheet(const std::vector<ShootoutEntry>& entries,
                                   const image::ColorConfig& config, const SheetOptions& options) {
  if (entries.empty() || entries.front().picture.layers.empty())
    return fail(Code::Internal, "a contact sheet needs the truth");
  const image::Image& truth = entries.front().picture;
  const double scale = kFullColour * white(truth);
  std::vector<const ShootoutEntry*> groups[2];
  groups[0].push_back(&entries.front());
  for (std::size_t i = 1; i < entries.size(); ++i)
    groups[entries[i].group == ShootoutGroup::EqualMemory ? 1 : 0].push_back(&entries[i]);
  const Grid grid{truth.size, kColumns};
  int height = kHeader + kMargin;
  for (const auto& g : groups) height += g.empty() ? 0 : grid.height(g.size());
  Canvas canvas({2 * kMargin + kColumns * grid.tile().x + (kColumns - 1) * kGap, height}, kBackground);
  drawHeader(canvas, options);
  int top = kHeader, resolution = 0;
  for (const ShootoutEntry* e : groups[0])
    resolution = std::max(resolution, shadow::resolutionOf(e->worst().spec));
  for (int g = 0; g < 2; ++g) {
    if (groups[g].empty()) continue;
    const std::string text =
        g == 0 ? fmt::format("each with its usual parameters, in half floats, all at {0} \u00d7 {0} texels",
                             resolution)
               : fmt::format("each map takes {}, as the improved map does in 32 bytes a texel",
                             megabytes(groups[1].front()->bytes()));
    drawGroupHeader(canvas, top, g == 0 ? "Defaults" : "Equal memory", text);
    const auto error = [](const ShootoutEntry* e) {
      return e->group == ShootoutGroup::Truth ? 1e9 : e->worst().error.mean;
    };
    const auto best = *std::min_element(groups[g].begin(), groups[g].end(),
                                        [&](auto* a, auto* b) { return error(a) < error(b); });
    for (std::size_t i = 0; i < groups[g].size(); ++i) {
      const ShootoutEntry& e = *groups[g][i];
      PILEUS_TRY(const std::vector<float> picture, displayed(e.picture, config, options));
      const std::vector<float> diff = difference(e.picture, truth, scale);
      drawTile(canvas, grid.origin(top, i), grid, e, picture, diff,
               &e == best && e.group != ShootoutGroup::Truth);
    }
    top += grid.height(groups[g].size());
  }
  return canvas;
}

}  // namespace pileus::truth
