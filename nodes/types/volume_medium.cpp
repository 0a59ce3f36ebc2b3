// volume.medium: what density means optically.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volume;
  double extinction = 1;
  Color albedo{vec3(1.0f)};
  double anisotropy = 0;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Medium").category("Volume").keywords("extinction albedo scattering phase density shader material");
  d.help("Says how a volume attenuates and scatters light; replaces the medium of everything linked.");
  d.in("volume", &In::volume).required().help("Whose medium is set.");
  d.in("extinction", &In::extinction)
      .unit("1/m")
      .range(0, 1e6)
      .soft(0, 20)
      .help("sigma_t per unit of density.");
  d.in("albedo", &In::albedo)
      .range(0, 1)
      .help("The scattered part of what is extinguished; 1 absorbs nothing.");
  d.in("anisotropy", &In::anisotropy)
      .range(-0.99, 0.99)
      .soft(-0.9, 0.9)
      .help("g of Henyey-Greenstein: above 0 scatters forward, below 0 back, 0 evenly.");
  d.out("volume", &Out::volume).help("The same volumes with this medium.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  Out out{in.volume};
  for (volume::Instance& instance : out.volume.items)
    instance.medium = {in.extinction, in.albedo.rgb, in.anisotropy};
  return out;
}

}  // namespace

NodeType node_volume_medium() { return makeNode<In, Out>("volume.medium", 1, describe, evaluate); }

}  // namespace pileus::nodes
