#pragma once
// Text in pictures: antialiased glyphs of the interface's fonts, blended into display-referred pixels. Any
// thread.
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::image {

/// Display-referred RGBA pixels to draw on, row 0 on top: what writePng takes.
struct Canvas {
  Canvas(ivec2 extent, vec3 background);
  ivec2 size;
  std::vector<float> rgba;

  /// Parts outside are cut off.
  void fill(ivec2 origin, ivec2 extent, vec3 color);
  /// `pixels`: extent.y * extent.x * 4.
  void paste(ivec2 origin, ivec2 extent, const std::vector<float>& pixels);
};

enum class Face { Regular, Bold, Mono };

/// Pixels from the first to the last glyph's advance. `text` is UTF-8; a glyph that the font lacks is its
/// box.
double textWidth(Face face, double em, std::string_view text);
/// `at`: where the baseline begins; `em`: size in pixels.
void drawText(Canvas& canvas, dvec2 at, Face face, double em, vec3 color, std::string_view text);
/// `text`, shortened with an ellipsis to at most `width` pixels.
std::string fitText(Face face, double em, std::string_view text, double width);

}  // namespace pileus::image
