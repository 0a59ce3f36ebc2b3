// output.view: what the viewport shows.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  ImageValue image;
  std::string display;
  std::string view;
  std::string look;
  double exposure = 0;
  double gamma = 1;
};

struct Out {};

void describe(Describe<In, Out>& d) {
  d.name("View").category("Output").keywords("viewer display monitor ocio");
  d.help(
      "Shows a picture in the viewport through the colour configuration's display transform. Only what is "
      "shown changes: files stay "
      "scene-linear.");
  d.output();
  d.in("image", &In::image).required().help("The picture to show.");
  d.in("display", &In::display).help("Display of the colour configuration; empty: its default.");
  d.in("view", &In::view).help("View of that display; empty: its default.");
  d.in("look", &In::look)
      .help(
          "Look of the colour configuration, instead of those the view itself asks for; empty: as the view "
          "has it.");
  d.in("exposure", &In::exposure)
      .unit("stops")
      .range(-24, 24)
      .soft(-6, 6)
      .help("Gain before the view transform, in stops.");
  d.in("gamma", &In::gamma)
      .range(0.1, 10)
      .soft(0.25, 4)
      .logarithmic()
      .help("Behind the view transform: above 1 it brightens the middle of the range.");
}

Result<Out> evaluate(const In&, EvalContext&) { return Out{}; }

}  // namespace

NodeType node_output_view() { return makeNode<In, Out>("output.view", 1, describe, evaluate); }

}  // namespace pileus::nodes
