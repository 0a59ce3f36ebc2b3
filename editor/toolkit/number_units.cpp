#include "editor/toolkit/number_units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pileus::editor {
namespace {

using K = UnitKind;
constexpr double kDegree = std::numbers::pi / 180;

constexpr Unit kUnits[] = {{"m", K::Length, 1},
                           {"cm", K::Length, 0.01},
                           {"mm", K::Length, 0.001},
                           {"um", K::Length, 1e-6},
                           {"km", K::Length, 1000},
                           {"ft", K::Length, 0.3048},
                           {"in", K::Length, 0.0254},
                           {"yd", K::Length, 0.9144},
                           {"mi", K::Length, 1609.344},
                           {"deg", K::Angle, kDegree},
                           {"degrees", K::Angle, kDegree},
                           {"rad", K::Angle, 1},
                           {"turn", K::Angle, 2 * std::numbers::pi},
                           {"turns", K::Angle, 2 * std::numbers::pi},
                           {"K", K::Temperature, 1},
                           {"k", K::Temperature, 1},
                           {"stop", K::Stops, 1},
                           {"stops", K::Stops, 1},
                           {"EV", K::Stops, 1},
                           {"ev", K::Stops, 1}};

struct Function {
  std::string_view name;
  double (*run)(double);
  enum { Plain, OfAngle, ToAngle, KeepsUnit } kind = Plain;
};
using F = Function;

constexpr Function kFunctions[] = {
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"cbrt", [](double x) { return std::cbrt(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"exp2", [](double x) { return std::exp2(x); }},
    {"ln", [](double x) { return std::log(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"log2", [](double x) { return std::log2(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"sin", [](double x) { return std::sin(x); }, F::OfAngle},
    {"cos", [](double x) { return std::cos(x); }, F::OfAngle},
    {"tan", [](double x) { return std::tan(x); }, F::OfAngle},
    {"asin", [](double x) { return std::asin(x); }, F::ToAngle},
    {"acos", [](double x) { return std::acos(x); }, F::ToAngle},
    {"atan", [](double x) { return std::atan(x); }, F::ToAngle},
    {"abs", [](double x) { return std::abs(x); }, F::KeepsUnit},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
    {"round", [](double x) { return std::round(x); }},
};

bool plain(const Quantity& q) { return q.kind == K::None || q.kind == K::Percent; }

Result<Quantity> callOne(const Function& f, const Quantity& a) {
  const bool fits = plain(a) || f.kind == F::KeepsUnit || (f.kind == F::OfAngle && a.kind == K::Angle);
  if (!fits) return fail(Code::Arguments, "{}() takes a number without a unit.", f.name);
  const double value = f.run(a.value);
  if (std::isnan(value)) return fail(Code::Arguments, "{}() of that is not a number.", f.name);
  return Quantity{value, f.kind == F::ToAngle ? K::Angle : f.kind == F::KeepsUnit ? a.kind : K::None};
}

Result<Quantity> callMany(std::string_view name, const Quantity* a, int count) {
  for (int i = 1; i < count; ++i)
    if (a[i].kind != a[0].kind)
      return fail(Code::Arguments, "The values of {}() are of different kinds.", name);
  if (name == "clamp") return Quantity{std::min(std::max(a[0].value, a[1].value), a[2].value), a[0].kind};
  if (name == "pow" || name == "atan2") {
    if (!plain(a[0])) return fail(Code::Arguments, "{}() takes numbers without a unit.", name);
    return name == "pow" ? Quantity{std::pow(a[0].value, a[1].value), K::None}
                         : Quantity{std::atan2(a[0].value, a[1].value), K::Angle};
  }
  Quantity best = a[0];
  for (int i = 1; i < count; ++i)
    best.value = name == "min" ? std::min(best.value, a[i].value) : std::max(best.value, a[i].value);
  return best;
}

}  // namespace

const Unit* findUnit(std::string_view name) {
  for (const Unit& u : kUnits)
    if (u.name == name) return &u;
  return nullptr;
}

OwnUnit ownUnit(std::string_view label) {
  if (label == "%") return {K::Percent, 0.01};
  if (label == "1/m") return {K::PerLength, 1};
  if (const Unit* u = findUnit(label)) return {u->kind, u->factor};
  return {};
}

const char* kindName(UnitKind kind) {
  switch (kind) {
    case K::None:
      return "A plain number";
    case K::Length:
      return "A length";
    case K::PerLength:
      return "A number per length";
    case K::Angle:
      return "An angle";
    case K::Temperature:
      return "A temperature";
    case K::Stops:
      return "A number of stops";
    case K::Percent:
      return "A percentage";
  }
  return "";
}

Result<double> inOwnUnit(const Quantity& q, const OwnUnit& own) {
  if (q.kind == K::None) return q.value;
  if (q.kind == own.kind) return q.value / own.factor;
  if (q.kind == K::Percent && own.kind == K::None) return q.value;
  if (q.kind == K::Percent)
    return fail(Code::Arguments, "Per cent here needs + or -= in front: of the value there is.");
  if (own.kind == K::None) return fail(Code::Arguments, "{} does not fit this value.", kindName(q.kind));
  return fail(Code::Arguments, "{} is needed, not {}.", kindName(own.kind), [&] {
    std::string other = kindName(q.kind);
    other[0] = 'a';
    return other;
  }());
}

Result<Quantity> callFunction(std::string_view name, const Quantity* a, int count) {
  for (const Function& f : kFunctions) {
    if (f.name != name) continue;
    if (count != 1) return fail(Code::Arguments, "{}() takes one value.", name);
    return callOne(f, a[0]);
  }
  const int wanted = name == "clamp"                                                      ? 3
                     : name == "min" || name == "max" || name == "pow" || name == "atan2" ? 2
                                                                                          : 0;
  if (wanted == 0) return fail(Code::Arguments, "There is no function {}().", name);
  const bool three = (name == "min" || name == "max") && count == 3;
  if (count != wanted && !three) return fail(Code::Arguments, "{}() takes {} values.", name, wanted);
  return callMany(name, a, count);
}

}  // namespace pileus::editor
