// volume.merge: many volumes as one list.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volumes;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Merge").category("Volume").keywords("join combine add union list");
  d.help(
      "Joins volumes into one list, each keeping its own place and medium. Where they overlap their "
      "extinction adds.");
  d.in("volumes", &In::volumes).many().help("The volumes to join, in this order.");
  d.out("volume", &Out::volume).help("All of them.");
}

Result<Out> evaluate(const In& in, EvalContext&) { return Out{in.volumes}; }

}  // namespace

NodeType node_volume_merge() { return makeNode<In, Out>("volume.merge", 1, describe, evaluate); }

}  // namespace pileus::nodes
