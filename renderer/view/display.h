#pragma once
// Picture -> display-referred 8-bit texture. In this order: gain, view transform, gamma, dither of one code
// value, channel, clip marks. Float all the way; nothing is clamped before the view transform. GL thread.
#include <array>
#include <map>
#include <memory>
#include <string>

#include "renderer/base/enum_info.h"
#include "renderer/gl/texture.h"
#include "renderer/image/color.h"

namespace pileus::gl {
class ShaderLibrary;
}

namespace pileus::view {

/// One channel on its own, as grey. Luminance is taken of scene light and goes through the view transform;
/// alpha and transmittance are no light and go around it.
enum class Channel { Color, Red, Green, Blue, Alpha, Luminance, Transmittance };
constexpr auto enumInfo(Channel*) {
  using C = Channel;
  return std::array{EnumItem<C>{C::Color, "color", "RGB", "All channels."},
                    EnumItem<C>{C::Red, "red", "R", "Red alone, through the view transform."},
                    EnumItem<C>{C::Green, "green", "G", "Green alone, through the view transform."},
                    EnumItem<C>{C::Blue, "blue", "B", "Blue alone, through the view transform."},
                    EnumItem<C>{C::Alpha, "alpha", "A", "Alpha: how much of what is behind is covered."},
                    EnumItem<C>{C::Luminance, "luminance", "Y", "Luminance, through the view transform."},
                    EnumItem<C>{C::Transmittance, "transmittance", "T", "What passes through: 1 - alpha."}};
}

struct DisplaySettings {
  std::string display, view;  ///< "" = the config's default
  std::string look;           ///< "" = as the view asks for
  double exposure = 0;        ///< stops
  double gamma = 1;           ///< behind the view transform
  bool raw = false;           ///< no view transform: scene values as they are
  Channel channel = Channel::Color;
  bool falseColor = false;  ///< bands of exposure instead of the view transform
  bool zebra = false;       ///< marks what is clipped
  vec2 range{0};  ///< of data such as depth, shown from white to dark grey; y <= x: the picture is light
  bool operator==(const DisplaySettings&) const = default;
};

/// ACEScg weights of luminance.
inline constexpr vec3 kLuminance{0.2722287f, 0.6740818f, 0.0536895f};
/// Scene luminance that false colours call 0 stops.
inline constexpr double kMiddleGrey = 0.18;
/// Display colours of false colour: band i is centred on i - 7 stops around middle grey; the first and last
/// hold all that is beyond.
inline constexpr int kExposureBands = 15;
const std::array<vec3, kExposureBands>& exposureBands();

class Display {
 public:
  explicit Display(gl::ShaderLibrary& shaders);
  ~Display();
  /// Draws `color` (RGBA32F, size `size`) into a texture of `outputSize` (bilinear when magnified,
  /// area-averaged when reduced) that stays owned by the Display and valid until the next call with the same
  /// slot. Alpha 1: the picture stands over black. Returns the GL texture name (RGBA8, row 0 on top).
  /// Programs are cached by the transform's key.
  Result<unsigned> draw(const gl::Texture& color, ivec2 size, ivec2 outputSize,
                        const image::ColorConfig& config, const DisplaySettings& settings, int slot = 0);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pileus::view
