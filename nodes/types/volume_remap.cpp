// volume.remap: another density and colour for each density of a volume.
#include <algorithm>

#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volume;
  double inputMin = 0;
  double inputMax = 0;
  Curve curve{{{0, 0}, {1, 1}}, CurveShape::Smooth};
  double strength = 1;
  Ramp color{{{0, dvec3(1)}, {1, dvec3(1)}}, RampShape::Linear};
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Remap").category("Volume").keywords(
      "density curve ramp levels contrast threshold erode tint colour");
  d.help(
      "Puts each density through a curve, and colours what scatters by a ramp. The voxels stay as they are, "
      "so "
      "that edits show at once; far away, where coarser voxels are seen, the curve acts on their means. "
      "Nothing is added outside the volume's box.");
  d.in("volume", &In::volume).required().help("Whose densities are remapped.");
  d.in("input_min", &In::inputMin)
      .range(0, 1e6)
      .soft(0, 10)
      .help("The density at the left of curve and ramp; lower ones count as this.");
  d.in("input_max", &In::inputMax)
      .range(0, 1e6)
      .soft(0, 10)
      .help("The density at their right; higher ones count as this. 0: the largest density of the volumes.");
  d.in("curve", &In::curve)
      .over("volume", "input_min", "input_max")
      .help(
          "The density that comes out, as a part of input_max, over the one that comes in. Takes no keys and "
          "no link.");
  d.in("strength", &In::strength).range(0, 1e6).soft(0, 10).help("Multiplies the density that comes out.");
  d.in("color", &In::color)
      .over("volume", "input_min", "input_max")
      .range(0, 1)
      .help(
          "Multiplies the medium's albedo, by the density that comes in. White leaves it as it is. Takes no "
          "keys and no link.");
  d.out("volume", &Out::volume).help("The same volumes with these densities and colours.");
}

struct Mapping {
  const In& in;
  double lowest, highest;

  vec4 at(double part) const {
    return {vec3(rampAt(in.color, part)),
            static_cast<float>(in.strength * highest * curveAt(in.curve, part))};
  }
  volume::RemapPtr table() const {
    std::vector<vec4> entries;
    for (int i = 0; i < volume::kRemapEntries; ++i)
      entries.push_back(at(static_cast<double>(i) / (volume::kRemapEntries - 1)));
    return volume::makeRemap(lowest, highest, std::move(entries));
  }
};

Result<Out> evaluate(const In& in, EvalContext&) {
  Out out{in.volume};
  double most = 0;
  for (const volume::Instance& i : out.volume.items)
    if (!i.emission) most = std::max(most, volume::largestDensity(i));
  const Mapping mapping{in, in.inputMin, in.inputMax > 0 ? in.inputMax : most};
  if (most <= 0) return out;
  if (mapping.lowest >= mapping.highest)
    return fail(Code::Input, "input_min: {} is not below {}, {}", formatNumber(mapping.lowest),
                formatNumber(mapping.highest), in.inputMax > 0 ? "input_max" : "the largest density");
  // What changes nothing leaves not even a table: the picture is the same to the last bit.
  if (isIdentity(in.curve) && isWhite(in.color) && in.strength == 1 && in.inputMin == 0 &&
      mapping.highest >= most)
    return out;
  const volume::RemapPtr table = mapping.table();
  for (volume::Instance& i : out.volume.items) {
    if (i.emission) continue;
    if (i.shape == volume::Shape::Grid) {
      i.remap = volume::composed(i.remap, table);
      continue;
    }
    const double part =
        std::clamp((i.density - mapping.lowest) / (mapping.highest - mapping.lowest), 0.0, 1.0);
    i.medium.albedo *= vec3(mapping.at(part));
    i.density = in.strength * mapping.highest * curveAt(in.curve, part);
  }
  return out;
}

}  // namespace

NodeType node_volume_remap() { return makeNode<In, Out>("volume.remap", 1, describe, evaluate); }

}  // namespace pileus::nodes
