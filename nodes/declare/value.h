#pragma once
// What flows along links. Values are cheap to copy; GPU results are shared and immutable once published. For
// nodes and for what reads their results: graphs do without.
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "nodes/declare/socket_type.h"
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

/// What a socket holds; monostate: nothing linked. A struct, so that it can be declared ahead.
using AnySocketValue = std::variant<std::monostate, VolumeValue, LightValue, MetricValue, CameraValue,
                                    SolidValue, ImageValue, double, dvec3, Color, std::string>;
struct SocketValue : AnySocketValue {
  using AnySocketValue::AnySocketValue;
};

}  // namespace pileus::nodes
