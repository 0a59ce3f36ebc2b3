#pragma once
// The measured curve as a picture: errors of maps against what they cost, a column for each scene. Pure.
#include <string>
#include <vector>

#include "editor/cli/curve/measure.h"

namespace pileus::cli {

/// A map that was measured on every scene.
struct CurveRow {
  std::string name;
  shadow::ShadowSpec spec;
  bool before = false;                 ///< the default of format 1
  bool present = false;                ///< the default of today
  std::vector<CurveMeasure> measures;  ///< in the order of the scenes
  std::vector<double> seconds;         ///< of the whole process; empty where not measured
};

/// Of points (cost, error) those that none beats in both, by rising cost.
std::vector<std::size_t> paretoFront(const std::vector<dvec2>& points);

/// SVG, light on white, with the front of each panel drawn as a line.
std::string curvePlot(const std::vector<std::string>& scenes, const std::vector<CurveRow>& rows);

}  // namespace pileus::cli
