// output.exr: a still or sequence on disk.
#include "nodes/declare/describe.h"
#include "renderer/image/exr.h"

namespace pileus::nodes {
namespace {

struct In {
  ImageValue image;
  FilePath file;
  image::PixelType type = image::PixelType::Half;
  image::Compression compression = image::Compression::Zip;
  bool depth = false;
  bool lights = false;
  bool orders = false;
  bool light_groups = false;
};

struct Out {};

void describe(Describe<In, Out>& d) {
  d.name("EXR File").category("Output").keywords("write save export openexr still");
  d.help(
      "Names an OpenEXR file for a picture: scene-linear ACEScg with its chromaticities, never "
      "display-referred. Written by File > "
      "Export EXR and by `pileus render`.");
  d.output();
  d.in("image", &In::image).required().help("The picture to write.");
  d.in("file", &In::file)
      .file({"exr"}, true)
      .help(
          "Target; the last run of #, or the last %04d or $F, stands for the frame. `pileus render -o` "
          "overrides it.");
  d.in("type", &In::type).help("Precision of the stored pixels.");
  d.in("compression", &In::compression).help("Compression of the file.");
  d.in("depth", &In::depth)
      .help(
          "Adds depth.Z in 32 bits: metres along the viewing axis to the mean point that scatters or "
          "reflects; 0 where nothing does.");
  d.in("lights", &In::lights)
      .label("Light layers")
      .help(
          "Adds a layer for each light node, by its name (Sun.R, Sun.G ...): its part of the picture, and "
          "emission.R ... where something emits. Their sum is the picture. Names are made of letters, digits "
          "and underscores; a soft sun takes about as long as the picture for each sample of its disc.");
  d.in("orders", &In::orders)
      .label("Scattering layers")
      .help(
          "Adds single.R ..., light that was scattered once (and what is seen of lights and emission), and "
          "multiple.R ..., what the picture has beside that. Their sum is the picture.");
  d.in("light_groups", &In::light_groups)
      .label("Layers by group")
      .help(
          "Adds a layer for each group of lights, by its name, and one for each light without a group: what "
          "they light and what is seen of them. With emission.R ... where something emits, their sum is the "
          "picture. Instead of the light layers.");
}

Result<Out> evaluate(const In&, EvalContext&) { return Out{}; }

}  // namespace

NodeType node_output_exr() { return makeNode<In, Out>("output.exr", 1, describe, evaluate); }

}  // namespace pileus::nodes
