// value.number: one number for many parameters.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  double value = 0;
};

struct Out {
  double value = 0;
};

void describe(Describe<In, Out>& d) {
  d.name("Number").category("Value").keywords("float constant slider control");
  d.help("A number to link to parameters, so that one value drives several of them.");
  d.in("value", &In::value).soft(-10, 10).help("What it gives.");
  d.out("value", &Out::value).help("The value.");
}

Result<Out> evaluate(const In& in, EvalContext&) { return Out{in.value}; }

}  // namespace

NodeType node_value_number() { return makeNode<In, Out>("value.number", 1, describe, evaluate); }

}  // namespace pileus::nodes
