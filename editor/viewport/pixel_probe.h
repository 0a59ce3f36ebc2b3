#pragma once
// One place or area of a picture, read without waiting and again whenever the picture has changed.
#include <memory>
#include <span>
#include <string>

#include "renderer/view/picture.h"
#include "renderer/view/texel_reader.h"

namespace pileus::editor {

/// What an area holds; channels that are not finite count only where they are named.
struct TexelFigures {
  vec4 first{0};  ///< the value itself where the area is one texel
  vec4 min{0}, mean{0}, max{0};
  std::size_t texels = 0, nan = 0, inf = 0;
};
TexelFigures texelFigures(std::span<const vec4> texels);
/// "0.1234", "12.3", "4.5e-06", or in words "nan", "inf", "-inf".
std::string figureText(float value);
/// "+1.23", or in words where there is no light.
std::string stopsText(float luminance);

class PixelProbe {
 public:
  /// Corners in [0,1]^2, y down. True: new figures have come.
  bool follow(const std::shared_ptr<const view::Picture>& picture, dvec2 from, dvec2 to);
  bool busy() const { return reader_.busy(); }
  bool known() const { return known_ && figures_.texels > 0; }
  const TexelFigures& figures() const { return figures_; }
  ivec2 pixel() const { return lo_; }
  ivec2 size() const { return size_; }
  void forget() { known_ = false, asked_.reset(), reader_.forget(); }

 private:
  view::TexelReader reader_;
  std::weak_ptr<const view::Picture> asked_;
  int samples_ = -1;
  double fraction_ = -1;
  ivec2 lo_{-1}, size_{0};
  bool known_ = false;
  TexelFigures figures_;
};

}  // namespace pileus::editor
