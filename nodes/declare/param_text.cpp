// Parameter values as text: for the command line, error messages and the documentation.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "nodes/declare/node_type.h"

namespace pileus::nodes {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Locale-free; the whole text must be the number. Overflow and "nan" are no numbers here.
std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// "1 2 3", "1,2,3", "[1, 2, 3]", "(1;2;3)": the numbers, or nothing if a part is not one.
std::optional<std::vector<double>> numbers(std::string_view text) {
  if (text.size() >= 2 &&
      ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')')))
    text = text.substr(1, text.size() - 2);
  std::vector<double> values;
  constexpr std::string_view kSeparators = " \t,;";
  while (true) {
    const auto first = text.find_first_not_of(kSeparators);
    if (first == std::string_view::npos) return values;
    text.remove_prefix(first);
    const auto length = std::min(text.find_first_of(kSeparators), text.size());
    const auto value = number(text.substr(0, length));
    if (!value) return std::nullopt;
    values.push_back(*value);
    text.remove_prefix(length);
  }
}

/// smooth 0 0, 1 1: the word in front, if there is one, and the numbers in groups of `size`; in JSON's quotes
/// and brackets too.
template <class Shape, class Add>
Result<void> readPoints(std::string_view text, std::size_t size, Shape& shape, const Add& add) {
  std::string plain;  // brackets and quotes only part things
  for (const char c : text) plain += std::string_view("[]()\"").find(c) == std::string_view::npos ? c : ' ';
  std::string_view rest = trimmed(plain);
  if (const auto word = rest.substr(0, rest.find_first_of(" \t,;")); !word.empty() && !number(word)) {
    const auto found = enumFromId<Shape>(word);
    if (!found) return fail(Code::Arguments, "'{}' is no way to go from point to point", word);
    shape = *found;
    rest.remove_prefix(word.size());
  }
  const auto values = numbers(rest);
  if (!values || values->empty() || values->size() % size != 0)
    return fail(Code::Arguments, "'{}' is not groups of {} numbers", trimmed(text), size);
  for (std::size_t i = 0; i < values->size(); i += size) add(values->data() + i);
  return {};
}

}  // namespace

std::string formatNumber(double value) {
  if (value == 0.0) return "0";  // also -0
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, result.ptr);
}

Result<ParamValue> parseParam(const ParamSpec& spec, std::string_view text) {
  const std::string_view word = trimmed(text);
  switch (spec.type) {
    case ParamType::Text:
    case ParamType::File:
      return checkedParam(spec, std::string(text));
    case ParamType::Enum:
      return checkedParam(spec, std::string(word));
    case ParamType::Bool:
      for (const auto yes : {"true", "1", "on", "yes"})
        if (word == yes) return ParamValue(true);
      for (const auto no : {"false", "0", "off", "no"})
        if (word == no) return ParamValue(false);
      return fail(Code::Arguments, "'{}' is not true or false", word);
    case ParamType::Int:
    case ParamType::Float:
      if (const auto value = number(word)) return checkedParam(spec, *value);
      return fail(Code::Arguments, "'{}' is not a number", word);
    case ParamType::Vector:
    case ParamType::Color: {
      const auto values = numbers(word);
      if (!values || (values->size() != 3 && values->size() != 1))
        return fail(Code::Arguments, "'{}' is not three numbers", word);
      if (values->size() == 1) return checkedParam(spec, (*values)[0]);
      return checkedParam(spec, dvec3((*values)[0], (*values)[1], (*values)[2]));
    }
    case ParamType::Curve: {
      Curve curve{{}};
      PILEUS_CHECK(readPoints(word, 2, curve.shape, [&](const double* v) {
        curve.points.push_back({v[0], v[1]});
      }));
      return checkedParam(spec, curve);
    }
    case ParamType::Ramp: {
      Ramp ramp{{}};
      PILEUS_CHECK(readPoints(word, 4, ramp.shape, [&](const double* v) {
        ramp.stops.push_back({v[0], {v[1], v[2], v[3]}});
      }));
      return checkedParam(spec, ramp);
    }
  }
  return fail(Code::Internal, "unknown parameter type");
}

std::string formatParam(const ParamSpec&, const ParamValue& value) {
  if (const auto* v = std::get_if<bool>(&value)) return *v ? "true" : "false";
  if (const auto* v = std::get_if<int>(&value)) return std::to_string(*v);
  if (const auto* v = std::get_if<double>(&value)) return formatNumber(*v);
  if (const auto* v = std::get_if<dvec3>(&value))
    return formatNumber(v->x) + " " + formatNumber(v->y) + " " + formatNumber(v->z);
  if (const auto* v = std::get_if<Curve>(&value)) {
    std::string text(enumId(v->shape));
    for (const dvec2& p : v->points)
      text += (&p == v->points.data() ? " " : ", ") + formatNumber(p.x) + " " + formatNumber(p.y);
    return text;
  }
  if (const auto* v = std::get_if<Ramp>(&value)) {
    std::string text(enumId(v->shape));
    for (const RampStop& s : v->stops)
      text += (&s == v->stops.data() ? " " : ", ") + formatNumber(s.at) + " " + formatParam({}, s.color);
    return text;
  }
  return std::get<std::string>(value);
}

}  // namespace pileus::nodes
