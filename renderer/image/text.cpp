#include "renderer/image/text.h"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "embedded_text_fonts.h"

namespace pileus::image {
namespace {

/// In the order of Face.
constexpr std::array kFiles{"opentype/inter/Inter-Regular.otf", "opentype/inter/Inter-SemiBold.otf",
                            "truetype/jetbrains-mono/JetBrainsMono-Regular.ttf"};

const stbtt_fontinfo& font(Face face) {
  static const auto fonts = [] {
    std::array<stbtt_fontinfo, kFiles.size()> out{};
    for (std::size_t i = 0; i < kFiles.size(); ++i)
      for (const EmbeddedFile& file : embedded_text_fonts())
        if (file.path == kFiles[i])
          stbtt_InitFont(&out[i], reinterpret_cast<const unsigned char*>(file.bytes.data()), 0);
    return out;
  }();
  return fonts[static_cast<std::size_t>(face)];
}

/// The code point at the start of `text`, which it shortens. Not UTF-8: the byte itself.
int nextCodePoint(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const int lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (length > text.size() || lead < 0x80) {
    text.remove_prefix(1);
    return lead;
  }
  int code = lead & (0xFF >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3F);
  text.remove_prefix(length);
  return code;
}

/// Calls visit(glyph, x) with each glyph's pen position; gives the width back.
template <class Visit>
double layOut(const stbtt_fontinfo& info, double scale, std::string_view text, const Visit& visit) {
  double x = 0;
  for (int before = 0; !text.empty();) {
    const int glyph = stbtt_FindGlyphIndex(&info, nextCodePoint(text));
    if (before) x += scale * stbtt_GetGlyphKernAdvance(&info, before, glyph);
    visit(glyph, x);
    int advance = 0, bearing = 0;
    stbtt_GetGlyphHMetrics(&info, glyph, &advance, &bearing);
    x += scale * advance;
    before = glyph;
  }
  return x;
}

float scaleOf(const stbtt_fontinfo& info, double em) {
  return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(em));
}

}  // namespace

Canvas::Canvas(ivec2 extent, vec3 background) : size(extent) {
  rgba.resize(static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y) * 4, 1.0f);
  fill(ivec2(0), extent, background);
}

void Canvas::fill(ivec2 origin, ivec2 extent, vec3 color) {
  const ivec2 lo = glm::max(origin, ivec2(0)), hi = glm::min(origin + extent, size);
  for (int y = lo.y; y < hi.y; ++y)
    for (int x = lo.x; x < hi.x; ++x)
      for (int c = 0; c < 3; ++c) rgba[static_cast<std::size_t>((y * size.x + x) * 4 + c)] = color[c];
}

void Canvas::paste(ivec2 origin, ivec2 extent, const std::vector<float>& pixels) {
  for (int y = std::max(0, -origin.y); y < std::min(extent.y, size.y - origin.y); ++y)
    for (int x = std::max(0, -origin.x); x < std::min(extent.x, size.x - origin.x); ++x)
      for (int c = 0; c < 3; ++c)
        rgba[static_cast<std::size_t>(((origin.y + y) * size.x + origin.x + x) * 4 + c)] =
            pixels[static_cast<std::size_t>((y * extent.x + x) * 4 + c)];
}

double textWidth(Face face, double em, std::string_view text) {
  const stbtt_fontinfo& info = font(face);
  return layOut(info, static_cast<double>(scaleOf(info, em)), text, [](int, double) {});
}

void drawText(Canvas& canvas, dvec2 at, Face face, double em, vec3 color, std::string_view text) {
  const stbtt_fontinfo& info = font(face);
  const float scale = scaleOf(info, em);
  const int baseline = static_cast<int>(std::lround(at.y));
  layOut(info, static_cast<double>(scale), text, [&](int glyph, double pen) {
    const double left = std::floor(at.x + pen);
    int width = 0, height = 0, dx = 0, dy = 0;
    unsigned char* coverage = stbtt_GetGlyphBitmapSubpixel(
        &info, scale, scale, static_cast<float>(at.x + pen - left), 0.0f, glyph, &width, &height, &dx, &dy);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const ivec2 p(static_cast<int>(left) + dx + x, baseline + dy + y);
        if (p.x < 0 || p.y < 0 || p.x >= canvas.size.x || p.y >= canvas.size.y) continue;
        const float a = static_cast<float>(coverage[y * width + x]) / 255.0f;
        for (int c = 0; c < 3; ++c) {
          float& v = canvas.rgba[static_cast<std::size_t>((p.y * canvas.size.x + p.x) * 4 + c)];
          v += a * (color[c] - v);
        }
      }
    stbtt_FreeBitmap(coverage, nullptr);
  });
}

std::string fitText(Face face, double em, std::string_view text, double width) {
  if (textWidth(face, em, text) <= width) return std::string(text);
  std::string cut(text);
  while (!cut.empty()) {
    do cut.pop_back();
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80);
    if (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0xC0)
      cut.pop_back();  // a lead byte alone
    if (textWidth(face, em, cut + "\u2026") <= width) break;
  }
  return cut + "\u2026";
}

}  // namespace pileus::image
