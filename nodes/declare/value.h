#pragma once
// What flows along links. Values are cheap to copy; GPU results are shared and immutable once published.
#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "nodes/declare/curve.h"
#include "renderer/base/enum_info.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/light.h"
#include "renderer/scene/solid.h"
#include "renderer/shadow/shadowed_light.h"
#include "renderer/volume/instance.h"

namespace pileus::shadow {
struct PseudometricMap;  // renderer/shadow/pseudometric_map.h
}
namespace pileus::view {
struct Picture;  // renderer/view/picture.h
}

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
      EnumItem<T>{T::Color, "color", "Color", "A colour in the working space."},
      EnumItem<T>{T::Text, "text", "Text", "A text."}};
}

/// A colour parameter: linear in the working space.
struct Color {
  vec3 rgb{1.0f};
};
/// A file parameter: absolute once resolved for evaluation.
struct FilePath {
  std::string path;
};

struct VolumeValue {
  volume::InstanceList items;
};
using LightWithShadow = shadow::ShadowedLight;
struct LightValue {
  std::vector<LightWithShadow> items;
};
struct MetricValue {
  std::vector<std::shared_ptr<const shadow::PseudometricMap>> items;  ///< one for each light
  scene::SolidList solids;                                            ///< that block those lights
};
struct CameraValue {
  std::shared_ptr<const scene::Camera> camera;  ///< null: not linked
};
struct SolidValue {
  scene::SolidList items;
};
struct ImageValue {
  std::shared_ptr<const view::Picture> picture;  ///< null: nothing linked
};

/// What a socket holds; monostate: nothing linked.
using SocketValue = std::variant<std::monostate, VolumeValue, LightValue, MetricValue, CameraValue,
                                 SolidValue, ImageValue, double, dvec3, Color, std::string>;

/// A parameter's constant: booleans, integers, numbers, vectors and colours (three numbers), texts (also file
/// paths and enum ids), curves and ramps.
using ParamValue = std::variant<bool, int, double, dvec3, std::string, Curve, Ramp>;

}  // namespace pileus::nodes
