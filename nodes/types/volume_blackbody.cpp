// volume.blackbody: fire, a volume that glows as hot as its values say.
#include "nodes/types/volume_common.h"
#include "renderer/volume/emission.h"
#include "renderer/volume/fire_fit.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volume;
  DataCurve data;
  double coolest = 1000;
  double hottest = 2200;
  double strength = 1;
};

void describe(Describe<In, VolumeOut>& d) {
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
  describeStretch(d, "value", "the curve", "its");
  describeCurve(
      d, "value",
      "How hot a value is, from Coolest (0) to Hottest (1). Exactly 0 does not glow at all. Takes no "
      "keys and no link.");
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
  d.out("volume", &VolumeOut::volume).help("The same volumes, glowing.");
}

Result<VolumeOut> evaluate(const In& in, EvalContext& ctx) {
  VolumeOut out{in.volume};
  PILEUS_TRY(const auto data, stretchOf(in.data, in.volume, "value"));
  if (!data) return out;
  const volume::FireRange range{data->lowest, data->highest, {in.coolest, in.hottest, in.strength}};
  const volume::RemapPtr table = volume::makeEmission(
      range.lowest, range.highest, [&](double part) { return curveAt(in.data.curve, part); }, range.body);
  for (volume::Instance& i : out.volume.items) {
    if (i.emission) continue;
    i.emission = volume::emissionBehind(i.remap, table);
    i.remap = nullptr;
  }
  ctx.note(volume::fireNote(range, data->most));
  return out;
}

}  // namespace

NodeType node_volume_blackbody() {
  return makeNode<In, VolumeOut>("volume.blackbody", 1, describe, evaluate);
}

}  // namespace pileus::nodes
