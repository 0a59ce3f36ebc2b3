// value.color: one colour for many parameters.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  Color value;
};

struct Out {
  Color value;
};

void describe(Describe<In, Out>& d) {
  d.name("Colour").category("Value").keywords("rgb color tint constant");
  d.help("A colour in the working space to link to parameters.");
  d.in("value", &In::value).range(0, 1e6).soft(0, 1).help("What it gives.");
  d.out("value", &Out::value).help("The value.");
}

Result<Out> evaluate(const In& in, EvalContext&) { return Out{in.value}; }

}  // namespace

NodeType node_value_color() { return makeNode<In, Out>("value.color", 1, describe, evaluate); }

}  // namespace pileus::nodes
