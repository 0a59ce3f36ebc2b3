#include "nodes/evaluate/node_inputs.h"

#include <cmath>

#include "nodes/declare/value_traits.h"
#include "renderer/base/file.h"

namespace pileus::nodes {
namespace {

template <class T>
requires std::is_arithmetic_v<T>
void add(Hasher& hash, T v) { hash.add(v); }
void add(Hasher& hash, const dvec3& v) { hash.add(v.x).add(v.y).add(v.z); }
void add(Hasher& hash, const std::string& text) { hash.add(std::string_view(text)); }
void add(Hasher& hash, const Curve& curve) {
  hash.add(curve.shape).add(curve.points.size());
  for (const dvec2& p : curve.points) hash.add(p.x).add(p.y);
}
void add(Hasher& hash, const Ramp& ramp) {
  hash.add(ramp.shape).add(ramp.stops.size());
  for (const RampStop& s : ramp.stops) hash.add(s.at), add(hash, s.color);
}

void addParam(Hasher& hash, const ParamValue& value) {
  hash.add(value.index());
  std::visit([&hash](const auto& v) { add(hash, v); }, value);
}

void addCamera(Hasher& hash, const std::optional<scene::Camera>& camera) {
  hash.add(camera.has_value());
  if (!camera) return;
  for (const dvec3& v : {camera->eye, camera->target, camera->up}) add(hash, v);
  hash.add(camera->fov);
}

/// A link's value as one for this parameter; Code::Input with no place named where it is none.
Result<ParamValue> paramFrom(const ParamSpec& spec, const SocketValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    if (!std::isfinite(*number)) return fail(Code::Input, "is not a finite number");
    if (spec.type == ParamType::Bool) return ParamValue(*number != 0);
    if (spec.type == ParamType::Int) return ParamValue(std::round(*number));  // checked and converted below
    return ParamValue(*number);
  }
  return std::visit(
      [](const auto& v) -> Result<ParamValue> {
        using T = std::decay_t<decltype(v)>;
        if constexpr (!std::is_same_v<T, std::monostate>)
          if constexpr (ValueTraits<T>::isParam) return ValueTraits<T>::kept(v);
        return fail(Code::Input, "is not a value this parameter takes");
      },
      value);
}

}  // namespace

std::optional<Error> resolveParams(const std::string& name, const Node& node, const NodeType& type,
                                   const EvalSettings& settings, NodeInputs& in) {
  for (std::size_t i = 0; i < type.params.size(); ++i) {
    const ParamSpec& spec = type.params[i];
    ParamValue raw = spec.fallback;
    const auto linked = in.linkedParams.find(static_cast<int>(i));
    std::string linkedFrom;
    if (const auto it = node.params.find(spec.id); it != node.params.end()) raw = it->second;
    if (const auto it = node.animated.find(spec.id); it != node.animated.end())
      raw = valueAt(it->second, settings.frame);
    if (linked != in.linkedParams.end()) {
      const Link& link = *in.paramLinks.at(linked->first);
      linkedFrom = " (from " + link.fromNode + "." + link.fromSocket + ")";
      auto value = paramFrom(spec, linked->second);
      if (!value) return fail(Code::Input, "{}.{}: {}{}", name, spec.id, value.error().message, linkedFrom);
      raw = std::move(*value);
    } else if (const auto it = node.unknown.find("params/" + spec.id); it != node.unknown.end()) {
      if (!it->second.starts_with("{\"expr\""))
        return fail(Code::Input, "{}.{}: {} is not a value this parameter takes", name, spec.id,
                    it->second.substr(0, 80));
      in.warnings.push_back(spec.id + ": expressions are not evaluated yet; the default is used");
    }
    auto checked = checkedParam(spec, raw);
    if (!checked) return fail(Code::Input, "{}.{}: {}{}", name, spec.id, checked.error().message, linkedFrom);
    if (spec.type == ParamType::File) {
      const std::string& text = std::get<std::string>(*checked);
      if (!text.empty()) {
        std::error_code ignored;
        const auto path = std::filesystem::absolute(settings.folder / text, ignored).lexically_normal();
        *checked = path.string();
        if (!spec.writes) in.stamps.push_back(fileStamp(path)), in.files.push_back(path.string());
      }
    }
    in.params.push_back(std::move(*checked));
  }
  return std::nullopt;
}

Key contentKey(const NodeType& type, const NodeInputs& in, const EvalSettings& settings) {
  Hasher hash;
  hash.add(std::string_view(type.id)).add(type.version);
  for (std::size_t i = 0; i < in.params.size(); ++i)
    if (!type.params[i].forEditor) addParam(hash, in.params[i]);
  for (const Key& stamp : in.stamps) hash.add(stamp);
  bool cameraLinked = false;
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    hash.add(in.keys[i].size());
    for (const Key& key : in.keys[i]) hash.add(key);
    cameraLinked = cameraLinked || (type.inputs[i].type == SocketType::Camera && !in.keys[i].empty());
  }
  if (type.uses & UsesFrame) hash.add(settings.frame);
  if (type.uses & UsesRate) hash.add(settings.fps);
  if (type.uses & UsesColors) hash.add(std::string_view(settings.ocio)).add(fileStamp(settings.ocio));
  if (type.uses & UsesSize) hash.add(settings.size.x).add(settings.size.y);
  if (type.uses & UsesQuality) {
    hash.add(settings.quality);
    if (settings.quality == Quality::Draft)
      hash.add((type.uses & UsesSize) ? settings.draftPixels : settings.draftTexels);
  }
  if (type.uses & UsesLayers) {
    const view::PictureRegion& r = settings.region;
    hash.add(settings.layer.kind)
        .add(settings.layer.light)
        .add(settings.extra.depth)
        .add(settings.extra.lights)
        .add(settings.extra.orders)
        .add(settings.extra.backdrops);
    hash.add(r.min.x).add(r.min.y).add(r.max.x).add(r.max.y);
    if (!r.whole()) hash.add(settings.around);
  }
  if ((type.uses & UsesFreeCamera) && !cameraLinked) addCamera(hash, settings.freeCamera);
  return hash.key();
}

SocketValue convertedValue(const SocketValue& value, SocketType to) {
  if (const double* number = std::get_if<double>(&value)) {
    if (to == SocketType::Vector) return dvec3(*number);
    if (to == SocketType::Color) return Color{vec3(static_cast<float>(*number))};
  }
  return value;
}

SocketValue joinedValue(const std::vector<SocketValue>& values) {
  SocketValue joined = values.front();
  for (std::size_t i = 1; i < values.size(); ++i) join(joined, values[i]);
  return joined;
}

}  // namespace pileus::nodes
