#include "nodes/declare/node_type.h"

#include <cmath>

namespace pileus::nodes {
namespace {

template <class List>
int indexOf(const List& list, std::string_view id) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].id == id) return static_cast<int>(i);
  return -1;
}

std::string range(const ParamSpec& spec) {
  return formatNumber(spec.hardMin) + ".." + formatNumber(spec.hardMax);
}

std::string quoted(const ParamValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return "'" + *text + "'";
  return formatParam({}, value);
}

Result<ParamValue> mismatch(const ParamValue& value, std::string_view wanted) {
  return fail(Code::Arguments, "{} is not {}", quoted(value), wanted);
}

std::optional<double> asNumber(const ParamValue& value) {
  if (const auto* v = std::get_if<double>(&value)) return *v;
  if (const auto* v = std::get_if<int>(&value)) return static_cast<double>(*v);
  return std::nullopt;
}

}  // namespace

const ParamSpec* NodeType::param(std::string_view wanted) const {
  const int i = paramIndex(wanted);
  return i < 0 ? nullptr : &params[static_cast<std::size_t>(i)];
}
int NodeType::paramIndex(std::string_view wanted) const { return indexOf(params, wanted); }
int NodeType::inputIndex(std::string_view wanted) const { return indexOf(inputs, wanted); }
int NodeType::outputIndex(std::string_view wanted) const { return indexOf(outputs, wanted); }

Result<ParamValue> convertedParam(const ParamSpec& spec, const ParamValue& value) {
  const auto number = asNumber(value);
  switch (spec.type) {
    case ParamType::Bool:
      if (std::holds_alternative<bool>(value)) return value;
      return mismatch(value, "true or false");
    case ParamType::Int:
      if (std::holds_alternative<int>(value)) return value;
      if (number && *number == std::floor(*number) && std::abs(*number) <= 2147483647.0)
        return ParamValue(static_cast<int>(*number));
      return mismatch(value, "a whole number");
    case ParamType::Float:
      if (number && std::isfinite(*number)) return ParamValue(*number);
      return mismatch(value, "a number");
    case ParamType::Vector:
    case ParamType::Color:
      if (number && std::isfinite(*number)) return ParamValue(dvec3(*number));
      if (const auto* v = std::get_if<dvec3>(&value))
        if (std::isfinite(v->x) && std::isfinite(v->y) && std::isfinite(v->z)) return value;
      return mismatch(value, "three numbers");
    case ParamType::Text:
    case ParamType::File:
    case ParamType::Enum:
      if (std::holds_alternative<std::string>(value)) return value;
      return mismatch(value, spec.type == ParamType::Enum ? "a choice" : "a text");
    case ParamType::Curve:
      if (std::holds_alternative<Curve>(value)) return value;
      return mismatch(value, "a curve: [\"smooth\", [x, y], ...]");
    case ParamType::Ramp:
      if (std::holds_alternative<Ramp>(value)) return value;
      return mismatch(value, "a ramp: [\"linear\", [position, r, g, b], ...]");
  }
  return fail(Code::Internal, "unknown parameter type");
}

Result<ParamValue> checkedParam(const ParamSpec& spec, const ParamValue& given) {
  PILEUS_TRY(ParamValue value, convertedParam(spec, given));
  const auto outside = [&spec](double v) { return v < spec.hardMin || v > spec.hardMax; };
  if (const auto number = asNumber(value)) {
    if (outside(*number))
      return fail(Code::Arguments, "{} is outside {}", formatNumber(*number), range(spec));
  } else if (const auto* v = std::get_if<dvec3>(&value)) {
    for (int axis = 0; axis < 3; ++axis)
      if (outside((*v)[axis])) {
        const char name = (spec.type == ParamType::Color ? "rgb" : "xyz")[axis];
        return fail(Code::Arguments, "{} = {} is outside {}", name, formatNumber((*v)[axis]), range(spec));
      }
  } else if (spec.type == ParamType::Enum) {
    std::string choices;
    for (const Choice& choice : spec.choices) {
      if (choice.id == std::get<std::string>(value)) return value;
      choices += (choices.empty() ? "" : ", ") + choice.id;
    }
    return fail(Code::Arguments, "{} is not one of {}", quoted(value), choices);
  } else if (const auto* curve = std::get_if<Curve>(&value)) {
    PILEUS_CHECK(checkCurve(*curve));
  } else if (const auto* ramp = std::get_if<Ramp>(&value)) {
    PILEUS_CHECK(checkRamp(*ramp, spec.hardMin, spec.hardMax));
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    if (text->find('\0') != std::string::npos) return fail(Code::Arguments, "the text holds a zero byte");
  }
  return value;
}

bool convertible(SocketType from, SocketType to) {
  return from == to || (from == SocketType::Number && (to == SocketType::Vector || to == SocketType::Color));
}

}  // namespace pileus::nodes
