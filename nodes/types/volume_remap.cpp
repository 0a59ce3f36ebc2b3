// volume.remap: another density and colour for each density of a volume.
#include "nodes/types/volume_common.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volume;
  DataCurve data;
  double strength = 1;
  Ramp color{{{0, dvec3(1)}, {1, dvec3(1)}}, RampShape::Linear};
};

void describe(Describe<In, VolumeOut>& d) {
  d.name("Remap").category("Volume").keywords(
      "density curve ramp levels contrast threshold erode tint colour");
  d.help(
      "Puts each density through a curve, and colours what scatters by a ramp. The voxels stay as they are, "
      "so "
      "that edits show at once; far away, where coarser voxels are seen, the curve acts on their means. "
      "Nothing is added outside the volume's box.");
  d.in("volume", &In::volume).required().help("Whose densities are remapped.");
  describeStretch(d, "density", "curve and ramp", "their");
  describeCurve(
      d, "density",
      "The density that comes out, as a part of input_max, over the one that comes in. Takes no keys and "
      "no link.");
  d.in("strength", &In::strength).range(0, 1e6).soft(0, 10).help("Multiplies the density that comes out.");
  d.in("color", &In::color)
      .over("volume", "input_min", "input_max")
      .range(0, 1)
      .help(
          "Multiplies the medium's albedo, by the density that comes in. White leaves it as it is. Takes no "
          "keys and no link.");
  d.out("volume", &VolumeOut::volume).help("The same volumes with these densities and colours.");
}

struct Mapping {
  const In& in;
  DataStretch data;

  double density(double part) const { return in.strength * data.highest * curveAt(in.data.curve, part); }
  vec4 at(double part) const { return {vec3(rampAt(in.color, part)), static_cast<float>(density(part))}; }
  volume::RemapPtr table() const {
    std::vector<vec4> entries;
    for (int i = 0; i < volume::kRemapEntries; ++i)
      entries.push_back(at(static_cast<double>(i) / (volume::kRemapEntries - 1)));
    return volume::makeRemap(data.lowest, data.highest, std::move(entries));
  }
};

Result<VolumeOut> evaluate(const In& in, EvalContext&) {
  VolumeOut out{in.volume};
  PILEUS_TRY(const auto data, stretchOf(in.data, in.volume, "density"));
  if (!data) return out;
  // What changes nothing leaves not even a table: the picture is the same to the last bit.
  if (isIdentity(in.data.curve) && isWhite(in.color) && in.strength == 1 && data->lowest == 0 &&
      data->highest >= data->most)
    return out;
  const Mapping mapping{in, *data};
  const volume::RemapPtr table = mapping.table();
  for (volume::Instance& i : out.volume.items) {
    if (i.emission) continue;
    if (i.shape == volume::Shape::Grid) {
      i.remap = volume::composed(i.remap, table);
      continue;
    }
    const double part = std::clamp((i.density - data->lowest) / (data->highest - data->lowest), 0.0, 1.0);
    i.medium.albedo *= vec3(mapping.at(part));
    i.density = mapping.density(part);
  }
  return out;
}

}  // namespace

NodeType node_volume_remap() { return makeNode<In, VolumeOut>("volume.remap", 1, describe, evaluate); }

}  // namespace pileus::nodes
