#pragma once
// What lies behind curves and ramps: the range their 0 .. 1 stands for, and the histogram of the densities
// there.
#include <imgui.h>

#include <optional>

#include "editor/parameters/param_widgets.h"
#include "renderer/volume/density_histogram.h"

namespace pileus::editor {

struct DataBehind {
  double lowest = 0;
  std::optional<double> highest;  ///< none: the largest density of an input that is not known yet
  const volume::DensityHistogram* histogram = nullptr;
};

/// From the node's input as evaluated last, and its parameters.
DataBehind dataBehind(const ParamWidget& w);
/// Bars between two corners, as high as the logarithm of their counts.
void drawHistogram(const ParamWidget& w, const DataBehind& data, ImVec2 lo, ImVec2 hi);
/// The range's ends and what they are, in a line `width` wide at the cursor.
void drawRange(const ParamWidget& w, const DataBehind& data, float width);

/// Fields of the selected point: an edit's effect on the drag that goes on, once it has been applied.
void followField(const ParamWidget& w, const NumberEdit& edit);
/// A small drop-down of an enum's values; the chosen one.
template <class E>
std::optional<E> shapeField(const ParamWidget& w, E now, float width);

}  // namespace pileus::editor
