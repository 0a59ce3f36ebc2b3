// output.exr: a still or sequence on disk.
#include "nodes/describe.h"
#include "renderer/image/exr.h"

namespace pileus::nodes {
namespace {

struct In {
  ImageValue image;
  FilePath file;
  image::PixelType type = image::PixelType::Half;
  image::Compression compression = image::Compression::Zip;
};

struct Out {};

void describe(Describe<In, Out>& d) {
  d.name("EXR File").category("Output").keywords("write save export openexr still");
  d.help("Names an OpenEXR file for a picture: scene-linear ACEScg with its chromaticities, never display-referred. Written by File > "
         "Export EXR and by `pileus render`.");
  d.output();
  d.in("image", &In::image).required().help("The picture to write.");
  d.in("file", &In::file).file("exr", true).help("Target; #, ####, %04d or $F stand for the frame. `pileus render -o` overrides it.");
  d.in("type", &In::type).help("Precision of the stored pixels.");
  d.in("compression", &In::compression).help("Compression of the file.");
}

Result<Out> evaluate(const In&, EvalContext&) { return Out{}; }

}  // namespace

NodeType node_output_exr() { return makeNode<In, Out>("output.exr", 1, describe, evaluate); }

}  // namespace pileus::nodes
