#pragma once
// makeNode: turns `struct In`, `struct Out`, describe() and evaluate() of one file into a NodeType. Typed
// member pointers, so that a misspelt parameter is a compile error.
#include <cmath>
#include <type_traits>

#include "nodes/declare/eval_context.h"
#include "nodes/declare/node_type.h"

namespace pileus::nodes {

namespace detail {

template <class M>
constexpr bool isSocket =
    std::is_same_v<M, VolumeValue> || std::is_same_v<M, LightValue> || std::is_same_v<M, MetricValue> ||
    std::is_same_v<M, CameraValue> || std::is_same_v<M, SolidValue> || std::is_same_v<M, ImageValue>;

template <class M>
constexpr SocketType socketType() {
  if constexpr (std::is_same_v<M, VolumeValue>)
    return SocketType::Volume;
  else if constexpr (std::is_same_v<M, LightValue>)
    return SocketType::Light;
  else if constexpr (std::is_same_v<M, MetricValue>)
    return SocketType::Metric;
  else if constexpr (std::is_same_v<M, CameraValue>)
    return SocketType::Camera;
  else if constexpr (std::is_same_v<M, SolidValue>)
    return SocketType::Solid;
  else if constexpr (std::is_same_v<M, ImageValue>)
    return SocketType::Image;
  else if constexpr (std::is_same_v<M, double>)
    return SocketType::Number;
  else if constexpr (std::is_same_v<M, dvec3>)
    return SocketType::Vector;
  else if constexpr (std::is_same_v<M, Color>)
    return SocketType::Color;
  else
    return SocketType::Text;
}

/// Joins lists; other values are replaced by the last link.
template <class M>
void assignSocket(M& member, const SocketValue& value) {
  if (const M* v = std::get_if<M>(&value)) {
    if constexpr (std::is_same_v<M, MetricValue>)
      member = *v;  // its solids belong to its maps
    else if constexpr (requires { member.items; })
      member.items.insert(member.items.end(), v->items.begin(), v->items.end());
    else
      member = *v;
  }
}

template <class M>
ParamType paramType() {
  if constexpr (std::is_same_v<M, bool>)
    return ParamType::Bool;
  else if constexpr (std::is_same_v<M, int>)
    return ParamType::Int;
  else if constexpr (std::is_same_v<M, double>)
    return ParamType::Float;
  else if constexpr (std::is_same_v<M, dvec3>)
    return ParamType::Vector;
  else if constexpr (std::is_same_v<M, Color>)
    return ParamType::Color;
  else if constexpr (std::is_same_v<M, FilePath>)
    return ParamType::File;
  else if constexpr (std::is_same_v<M, std::string>)
    return ParamType::Text;
  else if constexpr (std::is_same_v<M, Curve>)
    return ParamType::Curve;
  else if constexpr (std::is_same_v<M, Ramp>)
    return ParamType::Ramp;
  else {
    static_assert(DescribedEnum<M>, "a parameter enum needs enumInfo beside it");
    return ParamType::Enum;
  }
}

template <class M>
ParamValue toParam(const M& v) {
  if constexpr (std::is_same_v<M, Color>)
    return dvec3(v.rgb);
  else if constexpr (std::is_same_v<M, FilePath>)
    return v.path;
  else if constexpr (DescribedEnum<M>)
    return std::string(enumId(v));
  else
    return v;
}

template <class M>
void fromParam(M& member, const ParamValue& v) {
  if constexpr (std::is_same_v<M, Color>)
    member.rgb = vec3(std::get<dvec3>(v));
  else if constexpr (std::is_same_v<M, FilePath>)
    member.path = std::get<std::string>(v);
  else if constexpr (DescribedEnum<M>)
    member = enumFromId<M>(std::get<std::string>(v)).value_or(member);
  else
    member = std::get<M>(v);
}

}  // namespace detail

/// Chained refinements of one parameter.
class ParamRow {
 public:
  explicit ParamRow(ParamSpec& spec) : spec_(&spec) {}
  ParamRow& label(std::string v) { return spec_->label = std::move(v), *this; }
  ParamRow& unit(std::string v) { return spec_->unit = std::move(v), *this; }
  ParamRow& help(std::string v) { return spec_->help = std::move(v), *this; }
  /// Hard range; also the soft one unless given.
  ParamRow& range(double lo, double hi) {
    spec_->hardMin = lo, spec_->hardMax = hi;
    if (spec_->softMin == spec_->softMax) spec_->softMin = lo, spec_->softMax = hi;
    return *this;
  }
  ParamRow& soft(double lo, double hi) { return spec_->softMin = lo, spec_->softMax = hi, *this; }
  ParamRow& logarithmic() { return spec_->logarithmic = true, *this; }
  /// Curve and Ramp: 0 .. 1 stands for densities at `input` between two other parameters.
  ParamRow& over(std::string input, std::string lowest, std::string highest, std::string what = "density") {
    return spec_->data = {std::move(input), std::move(lowest), std::move(highest), std::move(what)}, *this;
  }
  ParamRow& socket() { return spec_->socket = true, *this; }
  ParamRow& file(std::string kinds, bool writes = false) {
    return spec_->fileKinds = std::move(kinds), spec_->writes = writes, *this;
  }

 private:
  ParamSpec* spec_;
};

/// Chained refinements of one socket.
class SocketRow {
 public:
  explicit SocketRow(SocketSpec& spec) : spec_(&spec) {}
  SocketRow& label(std::string v) { return spec_->label = std::move(v), *this; }
  SocketRow& help(std::string v) { return spec_->help = std::move(v), *this; }
  SocketRow& many() { return spec_->many = true, *this; }
  SocketRow& required() { return spec_->required = true, *this; }

 private:
  SocketSpec* spec_;
};

/// "step_scale" -> "Step scale".
std::string labelFromId(std::string_view id);

template <class In, class Out>
class Describe {
 public:
  explicit Describe(NodeType& type) : type_(&type) {
    // Rows hand out references into these.
    type.params.reserve(64);
    type.inputs.reserve(32);
    type.outputs.reserve(32);
  }
  Describe& name(std::string v) { return type_->label = std::move(v), *this; }
  Describe& category(std::string v) { return type_->category = std::move(v), *this; }
  Describe& help(std::string v) { return type_->help = std::move(v), *this; }
  Describe& keywords(std::string v) { return type_->keywords = std::move(v), *this; }
  Describe& uses(unsigned bits) { return type_->uses |= bits, *this; }
  Describe& output() { return type_->isOutput = true, *this; }

  /// A socket, if the member is a socket value, else a parameter whose default is the member's initialiser.
  template <class M>
  auto in(std::string id, M In::*member) {
    if constexpr (detail::isSocket<M>) {
      SocketSpec& s = type_->inputs.emplace_back();
      s.label = labelFromId(id);
      s.id = std::move(id);
      s.type = detail::socketType<M>();
      s.assign = [member](void* in, const SocketValue& v) {
        detail::assignSocket(static_cast<In*>(in)->*member, v);
      };
      return SocketRow(s);
    } else {
      ParamSpec& p = type_->params.emplace_back();
      p.label = labelFromId(id);
      p.id = std::move(id);
      p.type = detail::paramType<M>();
      p.fallback = detail::toParam(In{}.*member);
      p.hardMin = -1e9, p.hardMax = 1e9;
      if constexpr (DescribedEnum<M>)
        for (const auto& item : enumInfo(static_cast<M*>(nullptr)))
          p.choices.push_back({std::string(item.id), std::string(item.label), std::string(item.help)});
      p.set = [member](void* in, const ParamValue& v) {
        detail::fromParam(static_cast<In*>(in)->*member, v);
      };
      return ParamRow(p);
    }
  }

  template <class M>
  SocketRow out(std::string id, M Out::*member) {
    SocketSpec& s = type_->outputs.emplace_back();
    s.label = labelFromId(id);
    s.id = std::move(id);
    s.type = detail::socketType<M>();
    s.read = [member](const void* out) -> SocketValue { return static_cast<const Out*>(out)->*member; };
    return SocketRow(s);
  }

 private:
  NodeType* type_;
};

template <class In, class Out>
NodeType makeNode(std::string id, int version, void (*describe)(Describe<In, Out>&),
                  Result<Out> (*evaluate)(const In&, EvalContext&)) {
  NodeType type;
  type.id = std::move(id);
  type.version = version;
  Describe<In, Out> d(type);
  describe(d);
  std::vector<std::function<void(void*, const SocketValue&)>> assign;
  std::vector<std::function<void(void*, const ParamValue&)>> set;
  std::vector<std::function<SocketValue(const void*)>> read;
  for (const SocketSpec& s : type.inputs) assign.push_back(s.assign);
  for (const ParamSpec& p : type.params) set.push_back(p.set);
  for (const SocketSpec& s : type.outputs) read.push_back(s.read);
  type.evaluate = [=](std::span<const std::vector<SocketValue>> inputs, std::span<const ParamValue> params,
                      EvalContext& context) -> Result<std::vector<SocketValue>> {
    In in;
    for (std::size_t i = 0; i < assign.size(); ++i)
      for (const SocketValue& v : inputs[i]) assign[i](&in, v);
    for (std::size_t i = 0; i < set.size(); ++i) set[i](&in, params[i]);
    PILEUS_TRY(Out out, evaluate(in, context));
    std::vector<SocketValue> values;
    for (const auto& r : read) values.push_back(r(&out));
    return values;
  };
  return type;
}

}  // namespace pileus::nodes
