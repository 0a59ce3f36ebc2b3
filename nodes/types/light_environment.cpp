// light.environment: light from everywhere, by a picture of it.
#include <cmath>

#include "nodes/declare/describe.h"
#include "renderer/base/file.h"
#include "renderer/base/jobs.h"
#include "renderer/image/environment_import.h"
#include "renderer/scene/environment_strata.h"
#include "renderer/scene/environment_suns.h"

namespace pileus::nodes {
namespace {

struct In {
  FilePath file;
  std::string colorspace;
  double rotation = 0;
  double exposure = 0;
  Color tint{vec3(1.0f)};
  bool visible = true;
  std::string group;
};

struct Out {
  LightValue light;
};

void describe(Describe<In, Out>& d) {
  d.name("Environment").category("Light").keywords("hdri hdr image based lighting ibl dome sky latlong");
  d.help(
      "Light from everywhere, by a lat-long picture: OpenEXR or Radiance HDR, whose values are radiance and "
      "whose data window is the map. Up to four bright discs become suns with shadows of their own; the "
      "rest is one light, of which 'Path Trace' takes all and 'Volume Render' sixteen other directions for "
      "each sample.");
  d.uses(UsesColors);
  d.in("file", &In::file)
      .file({"exr", "hdr"})
      .help("The picture. Its middle column shows azimuth 0, its top row straight up.");
  d.in("colorspace", &In::colorspace)
      .label("Colour space")
      .help(
          "Of the file, by its name in the document's colour configuration (else $OCIO, else the shipped "
          "one). "
          "Empty: linear Rec. 709.");
  d.in("rotation", &In::rotation)
      .unit("deg")
      .range(-36000, 36000)
      .soft(-180, 180)
      .help(
          "Added to every azimuth: turns it about the vertical. A drag sideways over the picture does so "
          "while "
          "this node is selected.");
  d.in("exposure", &In::exposure).unit("stops").range(-40, 40).soft(-8, 8).help("Twice as bright for each.");
  d.in("tint", &In::tint)
      .range(0, 1e6)
      .soft(0, 1)
      .help("Multiplies the radiance; linear, in the working space.");
  d.in("visible", &In::visible).help("Is it seen behind the media? Alpha stays that of the media.");
  d.in("group", &In::group)
      .forEditor()
      .help("Lights of one group are balanced together in the light mixer. Empty: it stands for itself.");
  d.out("light", &Out::light).help("Its suns, and the rest as one light.");
}

/// What a file comes to, whatever way it is turned and however bright.
struct Read {
  std::vector<scene::Light> suns;
  scene::Environment rest;
  std::vector<std::string> warnings;
  ivec2 size{0};
};

Result<Read> readMap(const std::string& path, const std::string& colorspace, const std::string& ocio,
                     JobControl& control) {
  Read read;
  PILEUS_TRY(image::EnvironmentFile file, image::importEnvironment(path, control));
  PILEUS_TRY(const auto config,
             colorspace.empty() ? image::ColorConfig::shipped() : image::ColorConfig::load(ocio));
  read.size = file.map.size;
  PILEUS_TRY(scene::EnvironmentMap map,
             image::environmentFrom(std::move(file), colorspace, *config, read.warnings));
  if (control.cancelled()) return fail(Code::Cancelled, "cancelled");
  read.suns = scene::extractSuns(map);
  read.rest = scene::environmentOf(std::move(map));
  read.rest.strata = scene::strataOf(read.rest);
  return read;
}

/// Turning and brightening it reads nothing anew.
struct Import {
  std::string path, colorspace, ocio;
  Key stamp;  ///< of the picture and of the configuration
  LooseJob<Read> job;
};

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  if (in.file.path.empty()) return fail(Code::Input, "file: no file chosen");
  Import& import = ctx.lasting<Import>();
  auto& job = import.job;
  const std::string ocio = in.colorspace.empty() ? "" : ctx.ocio();  // linear Rec. 709 needs none
  const Key stamp = Hasher().add(fileStamp(in.file.path)).add(fileStamp(ocio)).key();
  if (!job || import.path != in.file.path || import.colorspace != in.colorspace || import.ocio != ocio ||
      import.stamp != stamp) {
    import.path = in.file.path, import.colorspace = in.colorspace, import.ocio = ocio, import.stamp = stamp;
    job = looseJob<Read>([path = in.file.path, space = in.colorspace, ocio](JobControl& control) {
      return readMap(path, space, ocio, control);
    });
  }
  if (!job->done()) {
    ctx.pending(job->progress(), "Reading " + std::filesystem::path(in.file.path).filename().string());
    return Out{};
  }
  if (!job->result()) {
    const Error error = job->result().error();
    job.reset();
    return Error{error.code, "file: " + error.message, error.passing};
  }
  const Read& read = *job->result();
  for (const std::string& warning : read.warnings) ctx.warn(warning);
  auto environment = std::make_shared<scene::Environment>(read.rest);
  environment->rotation = in.rotation;
  environment->scale = in.tint.rgb * float(std::exp2(in.exposure));
  environment->visible = in.visible;
  Out out;
  for (scene::Light sun : read.suns) {
    sun.towards = scene::turned(sun.towards, in.rotation);
    sun.emitted *= environment->scale;
    out.light.items.push_back({sun, nullptr});
  }
  out.light.items.push_back({scene::environmentLight(environment), nullptr});
  ctx.note(fmt::format("{} x {}; {} {} taken out of it", read.size.x, read.size.y, read.suns.size(),
                       read.suns.size() == 1 ? "sun is" : "suns are"));
  return out;
}

}  // namespace

NodeType node_light_environment() { return makeNode<In, Out>("light.environment", 1, describe, evaluate); }

}  // namespace pileus::nodes
