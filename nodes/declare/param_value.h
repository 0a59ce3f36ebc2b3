#pragma once
// What a parameter holds: a constant, as files and edits have it.
#include <string>
#include <variant>

#include "nodes/declare/curve.h"
#include "nodes/declare/socket_type.h"

namespace pileus::nodes {

enum class ParamType { Bool, Int, Float, Vector, Color, Text, File, Enum, Curve, Ramp };

/// Curves and ramps have neither keys nor links: they are what the file says.
constexpr bool constantOnly(ParamType type) { return type == ParamType::Curve || type == ParamType::Ramp; }

/// The type a parameter has as a socket: Number for Bool, Int and Float, Text for files and choices.
constexpr SocketType socketType(ParamType type) {
  switch (type) {
    case ParamType::Bool:
    case ParamType::Int:
    case ParamType::Float:
      return SocketType::Number;
    case ParamType::Vector:
      return SocketType::Vector;
    case ParamType::Color:
      return SocketType::Color;
    case ParamType::Text:
    case ParamType::File:
    case ParamType::Enum:
    case ParamType::Curve:  // never asked: no sockets
    case ParamType::Ramp:
      break;
  }
  return SocketType::Text;
}

/// A parameter's constant: booleans, integers, numbers, vectors and colours (three numbers), texts (also file
/// paths and enum ids), curves and ramps.
using ParamValue = std::variant<bool, int, double, dvec3, std::string, Curve, Ramp>;

}  // namespace pileus::nodes
