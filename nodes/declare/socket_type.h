#pragma once
// The types of what flows along links; the values themselves are in value.h.
#include <array>

#include "renderer/base/enum_info.h"

namespace pileus::nodes {

enum class SocketType { Volume, Light, Metric, Camera, Solid, Image, Number, Vector, Color, Text };
constexpr auto enumInfo(SocketType*) {
  using T = SocketType;
  return std::array{
      EnumItem<T>{T::Volume, "volume", "Volume", "A list of placed volumes with their media."},
      EnumItem<T>{T::Light, "light", "Light", "A list of lights, each perhaps with its shadow map."},
      EnumItem<T>{T::Metric, "metric", "Metric", "A pseudometric map with its frustum, light and volumes."},
      EnumItem<T>{T::Camera, "camera", "Camera", "A camera."},
      EnumItem<T>{T::Solid, "solid", "Solid", "A list of opaque solids."},
      EnumItem<T>{T::Image, "image", "Image", "A scene-linear picture with layers."},
      EnumItem<T>{T::Number, "number", "Number", "A number."},
      EnumItem<T>{T::Vector, "vector", "Vector", "Three numbers."},
      EnumItem<T>{T::Color, "color", "Colour", "A colour in the working space."},
      EnumItem<T>{T::Text, "text", "Text", "A text."}};
}

struct SocketValue;  // value.h

}  // namespace pileus::nodes
