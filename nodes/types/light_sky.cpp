// light.sky: the sky of the Earth, and the sun seen through it.
#include <cmath>

#include "nodes/declare/describe.h"
#include "renderer/base/jobs.h"
#include "renderer/scene/environment_strata.h"
#include "renderer/scene/sky.h"

namespace pileus::nodes {
namespace {

struct In {
  double azimuth = 45;
  double elevation = 35;
  double irradiance = 10;
  double exposure = 0;
  double altitude = 0;
  double height = 1000;
  double air = 1;
  double aerosol = 1;
  double ozone = 1;
  double ground_albedo = 0.3;
  bool visible = true;
  std::string group;
};

struct Out {
  LightValue light, sun, sky;
};

void describe(Describe<In, Out>& d) {
  d.name("Sky").category("Light").keywords("atmosphere sun daylight physical dusk dawn sunset");
  d.help(
      "The sky of the Earth and the sun seen through its air, all orders of scattering in it, and the "
      "ground's "
      "light. Sun and sky fit together at every hour, also when the sun has set.");
  d.in("azimuth", &In::azimuth)
      .unit("deg")
      .range(-36000, 36000)
      .soft(-180, 180)
      .help(
          "Of the sun, from +Z towards +X. A drag sideways over the picture turns it while this node is "
          "selected.");
  d.in("elevation", &In::elevation)
      .unit("deg")
      .range(-90, 90)
      .help("Of the sun's middle above the horizon, without refraction.");
  d.in("irradiance", &In::irradiance)
      .unit("W/m^2")
      .range(0, 1e9)
      .soft(0, 50)
      .help("Of the sun above the air; the sky in proportion.");
  d.in("exposure", &In::exposure).unit("stops").range(-40, 40).soft(-8, 8).help("Twice as bright for each.");
  d.in("altitude", &In::altitude)
      .unit("m")
      .range(-500, 90000)
      .soft(0, 5000)
      .help("Of the height 0 of the scene, above the sea.");
  d.in("height", &In::height)
      .unit("m")
      .range(0, 90000)
      .soft(0, 15000)
      .help("In the scene, at which the sky is seen: that of the clouds. The sun follows every point's.");
  d.in("air", &In::air).range(0, 100).soft(0, 4).help("Molecules; 1 is the Earth's, 0 none.");
  d.in("aerosol", &In::aerosol).range(0, 100).soft(0, 8).help("Haze; 1 is a clear day.");
  d.in("ozone", &In::ozone).range(0, 100).soft(0, 4).help("Makes dusk blue; 1 is the usual amount.");
  d.in("ground_albedo", &In::ground_albedo)
      .range(0, 1)
      .label("Ground albedo")
      .help("What the ground sends back of its light: 0.06 the sea, 0.2 land, 0.9 snow.");
  d.in("visible", &In::visible).help("Is it seen behind the media? Alpha stays that of the media.");
  d.in("group", &In::group)
      .forEditor()
      .help("Lights of one group are balanced together in the light mixer. Empty: it stands for itself.");
  d.out("light", &Out::light).help("Sun and sky.");
  d.out("sun", &Out::sun).help("The sun alone.");
  d.out("sky", &Out::sky).help("The sky and the ground alone.");
}

/// What a sky comes to, wherever the sun stands to the north or south, and however bright it is shown.
struct Made {
  std::shared_ptr<const scene::Atmosphere> atmosphere;  ///< its tables serve every hour and every height
  scene::Environment environment;
  std::shared_ptr<const scene::SunAir> air;  ///< what the sun is seen through
};

struct Asked {
  scene::Air air;
  scene::Sky sky;
  double altitude = 0;

  bool operator==(const Asked&) const = default;
};

Asked askedBy(const In& in) {
  return {{in.air, in.aerosol, in.ozone, in.ground_albedo},
          {in.elevation, in.irradiance, std::clamp(in.altitude + in.height, 0.0, 0.99 * scene::kAirTop)},
          in.altitude};
}

/// `known`: an atmosphere that may be the one that is needed; or null.
Made make(const Asked& a, const std::shared_ptr<const scene::Atmosphere>& known) {
  Made made;
  made.atmosphere = known && known->air() == a.air ? known : std::make_shared<const scene::Atmosphere>(a.air);
  made.environment = scene::environmentOf(scene::skyMap(*made.atmosphere, a.sky));
  made.environment.strata = scene::strataOf(made.environment);
  made.air = std::make_shared<const scene::SunAir>(scene::sunAir(a.air, a.sky.elevation, a.altitude));
  return made;
}

struct Work {
  Asked asked;
  std::shared_ptr<const scene::Atmosphere> atmosphere;  ///< the last that was made
  LooseJob<Made> job;
};

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  Work& work = ctx.lasting<Work>();
  auto& job = work.job;
  if (const Asked asked = askedBy(in); !job || work.asked != asked) {
    work.asked = asked;
    job = looseJob<Made>(
        [asked, known = work.atmosphere](JobControl&) -> Result<Made> { return make(asked, known); });
  }
  if (!job->done()) {
    ctx.pending(job->progress(), "Making the sky");
    return Out{};
  }
  if (!job->result()) return job->result().error();
  const Made& made = *job->result();
  work.atmosphere = made.atmosphere;
  const double exposed = std::exp2(in.exposure);
  auto environment = std::make_shared<scene::Environment>(made.environment);
  environment->rotation = in.azimuth;
  environment->scale = vec3(float(exposed));
  environment->visible = in.visible;
  Out out;
  if (scene::sunIsUp(*made.air)) {
    scene::Light sun;
    sun.kind = scene::LightKind::Sun;
    sun.towards = scene::sunDirection(in.azimuth, in.elevation);
    sun.emitted = vec3(scene::sunAbove(in.irradiance) * exposed);
    sun.air = made.air;
    out.sun.items.push_back({sun, nullptr});
  }
  if (scene::sunThrough(*made.air, in.height) == vec3(0)) ctx.note("The sun has set");
  out.sky.items.push_back({scene::environmentLight(environment), nullptr});
  out.light.items = out.sun.items;
  out.light.items.insert(out.light.items.end(), out.sky.items.begin(), out.sky.items.end());
  return out;
}

}  // namespace

NodeType node_light_sky() { return makeNode<In, Out>("light.sky", 1, describe, evaluate); }

}  // namespace pileus::nodes
