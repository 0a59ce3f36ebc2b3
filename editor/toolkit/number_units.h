#pragma once
// The units that number fields understand, and the functions of their arithmetic. Pure.
#include <string_view>

#include "renderer/base/result.h"

namespace pileus::editor {

enum class UnitKind { None, Length, PerLength, Angle, Temperature, Stops, Percent };

struct Unit {
  std::string_view name;
  UnitKind kind;
  double factor;  ///< to m, rad, K, stops
};

/// A number in the base unit of its kind.
struct Quantity {
  double value = 0;
  UnitKind kind = UnitKind::None;
};

/// The unit a parameter is in.
struct OwnUnit {
  UnitKind kind = UnitKind::None;
  double factor = 1;
};

const Unit* findUnit(std::string_view name);  ///< null: none of that name
OwnUnit ownUnit(std::string_view label);      ///< a label that is no unit ("texels") has no kind
const char* kindName(UnitKind kind);          ///< "A length"

/// A plain number is in the own unit already; a quantity of another kind is an error in words.
Result<double> inOwnUnit(const Quantity& quantity, const OwnUnit& own);

/// sqrt, sin, min .. of `count` values.
Result<Quantity> callFunction(std::string_view name, const Quantity* arguments, int count);

}  // namespace pileus::editor
