// value.math: arithmetic on numbers.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

enum class Operation {
  Add,
  Subtract,
  Multiply,
  Divide,
  Power,
  Minimum,
  Maximum,
  Mix,
  Sine,
  Cosine,
  Absolute,
  Floor,
  Round,
  Modulo,
  Clamp,
  Remap
};
constexpr auto enumInfo(Operation*) {
  using O = Operation;
  return std::array{
      EnumItem<O>{O::Add, "add", "Add", "a + b."},
      EnumItem<O>{O::Subtract, "subtract", "Subtract", "a - b."},
      EnumItem<O>{O::Multiply, "multiply", "Multiply", "a b."},
      EnumItem<O>{O::Divide, "divide", "Divide", "a / b; 0 where b is 0."},
      EnumItem<O>{O::Power, "power", "Power", "a to the power of b; 0 where that is no number."},
      EnumItem<O>{O::Minimum, "min", "Minimum", "The smaller one."},
      EnumItem<O>{O::Maximum, "max", "Maximum", "The larger one."},
      EnumItem<O>{O::Mix, "mix", "Mix", "From a to b by c: c = 0 is a, 1 is b."},
      EnumItem<O>{O::Sine, "sine", "Sine", "c + b sin(a), a in degrees."},
      EnumItem<O>{O::Cosine, "cosine", "Cosine", "c + b cos(a), a in degrees."},
      EnumItem<O>{O::Absolute, "abs", "Absolute", "a without its sign."},
      EnumItem<O>{O::Floor, "floor", "Floor", "The whole number at or below a."},
      EnumItem<O>{O::Round, "round", "Round", "The nearest whole number to a."},
      EnumItem<O>{O::Modulo, "modulo", "Modulo",
                  "What is left of a after whole steps of b, at least 0; 0 where b is 0."},
      EnumItem<O>{O::Clamp, "clamp", "Clamp", "a, held between b and c."},
      EnumItem<O>{O::Remap, "remap", "Remap", "a from the range 0 to 1 to the range b to c."}};
}

struct In {
  Operation operation = Operation::Add;
  double a = 0;
  double b = 1;
  double c = 0;
};

struct Out {
  double value = 0;
};

void describe(Describe<In, Out>& d) {
  d.name("Math").category("Value").keywords(
      "add subtract multiply divide sine mix clamp calculate arithmetic");
  d.help("Calculates a number from up to three. What is no finite number becomes 0.");
  d.in("operation", &In::operation).help("What to calculate.");
  d.in("a", &In::a).soft(-10, 10).socket().help("The first number.");
  d.in("b", &In::b)
      .soft(-10, 10)
      .socket()
      .help("The second number; with sine and cosine the height of the wave.");
  d.in("c", &In::c)
      .soft(-10, 10)
      .socket()
      .help("The third number: how far to mix, the upper end of a range, the middle of a wave.");
  d.out("value", &Out::value).help("The result.");
}

double calculate(const In& in) {
  const auto [operation, a, b, c] = in;
  switch (operation) {
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return b == 0 ? 0 : a / b;
    case Operation::Power:
      return std::pow(a, b);
    case Operation::Minimum:
      return std::min(a, b);
    case Operation::Maximum:
      return std::max(a, b);
    case Operation::Mix:
      return a + (b - a) * c;
    case Operation::Sine:
      return c + b * std::sin(glm::radians(a));
    case Operation::Cosine:
      return c + b * std::cos(glm::radians(a));
    case Operation::Absolute:
      return std::abs(a);
    case Operation::Floor:
      return std::floor(a);
    case Operation::Round:
      return std::round(a);
    case Operation::Modulo:
      return b == 0 ? 0 : a - std::abs(b) * std::floor(a / std::abs(b));
    case Operation::Clamp:
      return std::max(std::min(a, std::max(b, c)), std::min(b, c));
    case Operation::Remap:
      return b + a * (c - b);
  }
  return 0;
}

Result<Out> evaluate(const In& in, EvalContext&) {
  const double value = calculate(in);
  return Out{std::isfinite(value) ? value : 0};
}

}  // namespace

NodeType node_value_math() { return makeNode<In, Out>("value.math", 1, describe, evaluate); }

}  // namespace pileus::nodes
