// value.vector: three numbers for many parameters.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 value{0};
};

struct Out {
  dvec3 value{0};
};

void describe(Describe<In, Out>& d) {
  d.name("Vector").category("Value").keywords("xyz position constant direction");
  d.help("Three numbers to link to parameters.");
  d.in("value", &In::value).soft(-10, 10).help("What it gives.");
  d.out("value", &Out::value).help("The value.");
}

Result<Out> evaluate(const In& in, EvalContext&) { return Out{in.value}; }

}  // namespace

NodeType node_value_vector() { return makeNode<In, Out>("value.vector", 1, describe, evaluate); }

}  // namespace pileus::nodes
