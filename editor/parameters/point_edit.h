#pragma once
// What the widgets of curves and ramps keep between frames.
#include <map>
#include <memory>
#include <string>

#include "renderer/base/jobs.h"
#include "renderer/base/math.h"
#include "renderer/volume/density_histogram.h"

namespace pileus::editor {

struct PointEdit {
  std::string key;        ///< "Node.param" whose point or stop is selected
  int selected = -1;      ///< its number; may be out of range after an edit elsewhere
  bool dragging = false;  ///< the selected one follows the pointer
  dvec2 raw{0};           ///< where it would be without snapping
  bool removing = false;  ///< the right button that removed one is still down: it opens no menu

  /// The selected one of `of` among `count`; -1: none.
  int of(const std::string& which, std::size_t count) const {
    return which == key && selected >= 0 && static_cast<std::size_t>(selected) < count ? selected : -1;
  }
};

/// Histograms of densities, counted in the background; kept by content.
struct DensityHistograms {
  std::map<Key, LooseJob<volume::DensityHistogram>> jobs;
};

/// What is known now: null until it has been counted.
const volume::DensityHistogram* histogramOf(DensityHistograms& histograms, const volume::InstanceList& list);

}  // namespace pileus::editor
