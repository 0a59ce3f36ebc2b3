// value.frame: the time, for parameters that move.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  double offset = 0;
  double speed = 1;
};

struct Out {
  double frame = 0;
  double seconds = 0;
};

void describe(Describe<In, Out>& d) {
  d.name("Frame").category("Value").keywords("time seconds animation current clock");
  d.help("The frame that is made, as a number: what is linked to it moves without keys.");
  d.uses(UsesFrame | UsesRate);
  d.in("offset", &In::offset).unit("frames").soft(-100, 100).help("Added to the frame.");
  d.in("speed", &In::speed).range(-1000, 1000).soft(-4, 4).help("Frames that pass for each frame.");
  d.out("frame", &Out::frame).help("The frame times speed, plus offset.");
  d.out("seconds", &Out::seconds).help("The same in seconds, at the document's frames per second.");
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  const double frame = ctx.frame() * in.speed + in.offset;
  return Out{frame, frame / ctx.fps()};
}

}  // namespace

NodeType node_value_frame() { return makeNode<In, Out>("value.frame", 1, describe, evaluate); }

}  // namespace pileus::nodes
