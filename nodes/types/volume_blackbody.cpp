// volume.blackbody: fire, a volume that glows as hot as its values say.
#include <algorithm>

#include "nodes/declare/describe.h"
#include "renderer/volume/emission.h"
#include "renderer/volume/fire_fit.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volume;
  double inputMin = 0;
  double inputMax = 0;
  Curve curve{{{0, 0}, {1, 1}}, CurveShape::Smooth};
  double coolest = 1000;
  double hottest = 2200;
  double strength = 1;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Black Body")
      .category("Volume")
      .keywords("fire flame emission temperature heat glow kelvin burn explosion light");
  d.help(
      "Makes a temperature or flame grid, or any volume, glow as a black body does. What comes out only "
      "emits: "
      "it scatters no light and casts no shadow, and Medium and Remap behind it leave it as it is; draw "
      "smoke "
      "beside it, from a grid of its own. Smoke in front dims it, but it does not light smoke or solids: add "
      "a "
      "Point light for that.");
  d.in("volume", &In::volume).required().help("Whose values are temperatures, in any unit.");
  d.in("input_min", &In::inputMin)
      .range(0, 1e6)
      .soft(0, 10)
      .help("The value at the left of the curve; lower ones count as this.");
  d.in("input_max", &In::inputMax)
      .range(0, 1e6)
      .soft(0, 10)
      .help("The value at its right; higher ones count as this. 0: the largest value of the volumes.");
  d.in("curve", &In::curve)
      .over("volume", "input_min", "input_max", "value")
      .help(
          "How hot a value is, from Coolest (0) to Hottest (1). Exactly 0 does not glow at all. Takes no "
          "keys "
          "and no link.");
  d.in("coolest", &In::coolest)
      .unit("K")
      .range(500, 20000)
      .soft(600, 2000)
      .help(
          "Temperature at the bottom of the curve. Below some 900 K hardly anything is seen beside the "
          "rest.");
  d.in("hottest", &In::hottest)
      .unit("K")
      .range(500, 20000)
      .soft(1200, 6000)
      .help("Temperature at its top: candles and wood some 1900 K, hot gas 2200 K and more.");
  d.in("strength", &In::strength)
      .unit("W/(m^3 sr)")
      .range(0, 1e6)
      .soft(0, 10)
      .help(
          "Radiance gained per metre at the hottest. Cooler parts follow by Planck's law, which makes them "
          "redder and much darker.");
  d.out("volume", &Out::volume).help("The same volumes, glowing.");
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  Out out{in.volume};
  double most = 0;
  for (const volume::Instance& i : out.volume.items)
    if (!i.emission) most = std::max(most, volume::largestDensity(i));
  if (most <= 0) return out;
  const double highest = in.inputMax > 0 ? in.inputMax : most;
  if (in.inputMin >= highest)
    return fail(Code::Input, "input_min: {} is not below {}, {}", formatNumber(in.inputMin),
                formatNumber(highest), in.inputMax > 0 ? "input_max" : "the largest value");
  const volume::RemapPtr table =
      volume::makeEmission(in.inputMin, highest, [&](double part) { return curveAt(in.curve, part); },
                           {in.coolest, in.hottest, in.strength});
  for (volume::Instance& i : out.volume.items) {
    if (i.emission) continue;
    i.emission = volume::emissionBehind(i.remap, table);
    i.remap = nullptr;
  }
  ctx.note(volume::fireNote({in.inputMin, highest, {in.coolest, in.hottest, in.strength}}, most));
  return out;
}

}  // namespace

NodeType node_volume_blackbody() { return makeNode<In, Out>("volume.blackbody", 1, describe, evaluate); }

}  // namespace pileus::nodes
