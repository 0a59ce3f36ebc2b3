#pragma once
// One row for each type that a member of `In` or `Out` may have: what it is as a socket and as a parameter,
// what several links to one input come to, and how a parameter's constant is kept. A new type is a row here
// and an alternative of SocketValue or ParamValue.
#include <type_traits>

#include "nodes/declare/param_value.h"
#include "nodes/declare/value.h"

namespace pileus::nodes {

// What several links to one input come to.

/// Their lists, one behind the other.
struct Joined {
  template <class T>
  static void join(T& to, const T& more) {
    to.items.insert(to.items.end(), more.items.begin(), more.items.end());
  }
};
/// What the last one gives.
struct Replaced {
  template <class T>
  static void join(T& to, const T& more) {
    to = more;
  }
};

// How a parameter's constant is kept.

struct AsItIs {
  template <class T>
  static ParamValue kept(const T& v) {
    return v;
  }
  template <class T>
  static void take(T& to, const ParamValue& v) {
    to = std::get<T>(v);
  }
};
struct AsThreeNumbers {
  static ParamValue kept(const Color& v) { return dvec3(v.rgb); }
  static void take(Color& to, const ParamValue& v) { to.rgb = vec3(std::get<dvec3>(v)); }
};
struct AsPath {
  static ParamValue kept(const FilePath& v) { return v.path; }
  static void take(FilePath& to, const ParamValue& v) { to.path = std::get<std::string>(v); }
};
struct AsId {
  template <class T>
  static ParamValue kept(const T& v) {
    return std::string(enumId(v));
  }
  template <class T>
  static void take(T& to, const ParamValue& v) {
    to = enumFromId<T>(std::get<std::string>(v)).value_or(to);
  }
};

/// A type that only flows along links.
template <SocketType kType, class Joining>
struct LinkTraits : Joining {
  static constexpr SocketType socket = kType;
  static constexpr bool isParam = false;
};
/// A type of parameters, which may be linked as well.
template <ParamType kType, class Keeping>
struct ParamTraits : Keeping, Replaced {
  static constexpr SocketType socket = socketType(kType);
  static constexpr bool isParam = true;
  static constexpr ParamType param = kType;
};

template <class T>
struct ValueTraits;

// clang-format off
template <> struct ValueTraits<VolumeValue> : LinkTraits<SocketType::Volume, Joined> {};
template <> struct ValueTraits<LightValue>  : LinkTraits<SocketType::Light, Joined> {};
template <> struct ValueTraits<SolidValue>  : LinkTraits<SocketType::Solid, Joined> {};
template <> struct ValueTraits<MetricValue> : LinkTraits<SocketType::Metric, Replaced> {};  // with its solids
template <> struct ValueTraits<CameraValue> : LinkTraits<SocketType::Camera, Replaced> {};
template <> struct ValueTraits<ImageValue>  : LinkTraits<SocketType::Image, Replaced> {};

template <> struct ValueTraits<bool>        : ParamTraits<ParamType::Bool, AsItIs> {};
template <> struct ValueTraits<int>         : ParamTraits<ParamType::Int, AsItIs> {};
template <> struct ValueTraits<double>      : ParamTraits<ParamType::Float, AsItIs> {};
template <> struct ValueTraits<dvec3>       : ParamTraits<ParamType::Vector, AsItIs> {};
template <> struct ValueTraits<Color>       : ParamTraits<ParamType::Color, AsThreeNumbers> {};
template <> struct ValueTraits<std::string> : ParamTraits<ParamType::Text, AsItIs> {};
template <> struct ValueTraits<FilePath>    : ParamTraits<ParamType::File, AsPath> {};
template <> struct ValueTraits<Curve>       : ParamTraits<ParamType::Curve, AsItIs> {};
template <> struct ValueTraits<Ramp>        : ParamTraits<ParamType::Ramp, AsItIs> {};
template <DescribedEnum T> struct ValueTraits<T> : ParamTraits<ParamType::Enum, AsId> {};
// clang-format on

/// Another link's value to one that is there already; what is of another type replaces it.
void join(SocketValue& to, const SocketValue& more);

}  // namespace pileus::nodes
