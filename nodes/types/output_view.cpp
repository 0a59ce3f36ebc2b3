// output.view: what the viewport shows.
#include "nodes/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  ImageValue image;
  std::string display;
  std::string view;
  double exposure = 0;
};

struct Out {};

void describe(Describe<In, Out>& d) {
  d.name("View").category("Output").keywords("viewer display monitor ocio");
  d.help("Shows a picture in the viewport through the colour configuration's display transform. Only what is shown changes: files stay "
         "scene-linear.");
  d.output();
  d.in("image", &In::image).required().help("The picture to show.");
  d.in("display", &In::display).help("Display of the colour configuration; empty: its default.");
  d.in("view", &In::view).help("View of that display; empty: its default.");
  d.in("exposure", &In::exposure).unit("stops").range(-24, 24).soft(-6, 6).help("Gain before the view transform, in stops.");
}

Result<Out> evaluate(const In&, EvalContext&) { return Out{}; }

}  // namespace

NodeType node_output_view() { return makeNode<In, Out>("output.view", 1, describe, evaluate); }

}  // namespace pileus::nodes
