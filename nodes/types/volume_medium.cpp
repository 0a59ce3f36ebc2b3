// volume.medium: what density means optically.
#include <fmt/format.h>

#include <cmath>

#include "nodes/declare/describe.h"
#include "renderer/scene/phase.h"

namespace pileus::nodes {
namespace {

enum class PhaseKind { HenyeyGreenstein, DoubleHenyeyGreenstein, Rayleigh, Draine, Droplets };
constexpr auto enumInfo(PhaseKind*) {
  using P = PhaseKind;
  return std::array{
      EnumItem<P>{P::HenyeyGreenstein, "hg", "Henyey-Greenstein", "One lobe: 'Anisotropy' says how sharp."},
      EnumItem<P>{P::DoubleHenyeyGreenstein, "double_hg", "Two Lobes",
                  "A lobe forward and one back, blended: smoke, dust, snow."},
      EnumItem<P>{P::Rayleigh, "rayleigh", "Rayleigh",
                  "What is far smaller than light's waves: air. As much back as forward."},
      EnumItem<P>{P::Draine, "draine", "Draine",
                  "Henyey-Greenstein times 1 + alpha cos^2: fine dust. Alpha 1 is Cornette and Shanks."},
      EnumItem<P>{P::Droplets, "droplets", "Droplets",
                  "Water in air, by the diameter of its droplets: clouds, fog, haze."}};
}

struct In {
  VolumeValue volume;
  double extinction = 1;
  Color extinction_color{vec3(1.0f)};
  Color albedo{vec3(1.0f)};
  PhaseKind phase = PhaseKind::HenyeyGreenstein;
  double anisotropy = 0;
  double anisotropy_back = -0.3;
  double blend = 0.2;
  double draine_alpha = 1;
  double droplet_diameter = 10;
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
  d.in("extinction_color", &In::extinction_color)
      .label("Extinction colour")
      .range(0, 100)
      .soft(0, 1)
      .help(
          "Tint of the extinction: what passes takes the other colors. Where volumes differ in it, 'Volume "
          "Render' makes three shadows of each light, one for each channel.");
  d.in("albedo", &In::albedo)
      .range(0, 1)
      .help("The scattered part of what is extinguished; 1 absorbs nothing.");
  d.in("phase", &In::phase).label("Phase function").help("How scattered light is spread over directions.");
  d.in("anisotropy", &In::anisotropy)
      .range(-1, 1)
      .soft(-0.9, 0.9)
      .help(
          "g of Henyey-Greenstein and Draine: above 0 scatters forward, below 0 back, 0 evenly. Beyond "
          "0.9999 it is that.");
  d.in("anisotropy_back", &In::anisotropy_back)
      .range(-1, 1)
      .soft(-0.9, 0)
      .label("Anisotropy back")
      .help("g of the second of 'Two Lobes'.");
  d.in("blend", &In::blend).range(0, 1).help("Share of the second of 'Two Lobes'.");
  d.in("draine_alpha", &In::draine_alpha)
      .range(0, 1e4)
      .soft(0, 4)
      .label("Alpha")
      .help("Of 'Draine': 0 is Henyey-Greenstein; with anisotropy 0 and alpha 1 it is Rayleigh.");
  d.in("droplet_diameter", &In::droplet_diameter)
      .unit("um")
      .range(0, scene::kLargestDroplet)
      .soft(0, 50)
      .label("Droplet diameter")
      .help("Of 'Droplets', in micrometres: haze 0.1 to 1, fog and clouds 5 to 30. Larger ones are sharper.");
  d.out("volume", &Out::volume).help("The same volumes with this medium.");
}

scene::Phase phaseOf(const In& in) {
  switch (in.phase) {
    case PhaseKind::DoubleHenyeyGreenstein:
      return scene::doubleHenyeyGreenstein(in.anisotropy, in.anisotropy_back, in.blend);
    case PhaseKind::Rayleigh:
      return scene::rayleigh();
    case PhaseKind::Draine:
      return scene::draine(in.anisotropy, in.draine_alpha);
    case PhaseKind::Droplets:
      return scene::droplets(in.droplet_diameter);
    case PhaseKind::HenyeyGreenstein:
      break;
  }
  return scene::henyeyGreenstein(in.anisotropy);
}

void warnOfClamps(const In& in, EvalContext& ctx) {
  const bool one = in.phase == PhaseKind::HenyeyGreenstein || in.phase == PhaseKind::Draine,
             two = in.phase == PhaseKind::DoubleHenyeyGreenstein;
  if (((one || two) && std::abs(in.anisotropy) > scene::kSharpestPhase) ||
      (two && std::abs(in.anisotropy_back) > scene::kSharpestPhase))
    ctx.warn(
        fmt::format("anisotropy: a lobe of +-1 has no width; rendered with +-{}", scene::kSharpestPhase));
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  warnOfClamps(in, ctx);
  Out out{in.volume};
  for (volume::Instance& instance : out.volume.items)
    instance.medium = {in.extinction, in.albedo.rgb, phaseOf(in), in.extinction_color.rgb};
  return out;
}

}  // namespace

NodeType node_volume_medium() { return makeNode<In, Out>("volume.medium", 1, describe, evaluate); }

}  // namespace pileus::nodes
