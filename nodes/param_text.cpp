// Parameter values as text: for the command line, error messages and the documentation.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "nodes/node_type.h"

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
  }
  return fail(Code::Internal, "unknown parameter type");
}

std::string formatParam(const ParamSpec&, const ParamValue& value) {
  if (const auto* v = std::get_if<bool>(&value)) return *v ? "true" : "false";
  if (const auto* v = std::get_if<int>(&value)) return std::to_string(*v);
  if (const auto* v = std::get_if<double>(&value)) return formatNumber(*v);
  if (const auto* v = std::get_if<dvec3>(&value))
    return formatNumber(v->x) + " " + formatNumber(v->y) + " " + formatNumber(v->z);
  return std::get<std::string>(value);
}

}  // namespace pileus::nodes
