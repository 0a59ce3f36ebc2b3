#pragma once
// Charts over ImGui's draw lists: a frame with ticks, lines and filled areas. A Plot is a value for one
// frame.
#include <imgui.h>

#include <functional>
#include <span>
#include <string>

#include "editor/toolkit/theme.h"
#include "renderer/base/math.h"

namespace pileus::editor {

struct Plot {
  ImDrawList* draw = nullptr;
  const Theme* theme = nullptr;
  vec2 lo{0}, hi{0};       ///< pixels of the frame: values grow to the right and up
  dvec2 x{0, 1}, y{0, 1};  ///< values at its edges
  bool logX = false, logY = false;

  float px(double value) const;
  float py(double value) const;
  vec2 at(double vx, double vy) const { return {px(vx), py(vy)}; }
  double xAt(float pixel) const;
  bool hovered() const;  ///< the pointer is inside, and the window has it
};

/// 1, 2 or 5 times a power of ten: about `count` of them in a range.
double tickStep(double range, int count);
/// "0.25", "12", "1e-05": as few digits as a step of `step` needs.
std::string tickText(double value, double step);

/// What a frame shows of x.
enum class AxisX { None, Grid, Labels };
/// Ground, grid lines and tick labels: left of the frame, and below it for AxisX::Labels. `unit` stands
/// behind the last label of x.
void plotFrame(const Plot& plot, AxisX axis, const char* unit = "", int ticksY = 4);
void plotLine(const Plot& plot, std::span<const double> x, std::span<const double> y, ImU32 color,
              float width);
/// Between two curves: one colour where `b` is above `a`, the other where it is below.
void plotBetween(const Plot& plot, std::span<const double> x, std::span<const double> a,
                 std::span<const double> b, ImU32 above, ImU32 below);
/// Between a curve and a level.
void plotArea(const Plot& plot, std::span<const double> x, std::span<const double> y, double level,
              ImU32 color);
void plotVertical(const Plot& plot, double x, ImU32 color, bool dashed);
void plotDot(const Plot& plot, double x, double y, ImU32 color, float radius);

/// y at x by straight lines; x rising.
double interpolated(std::span<const double> x, std::span<const double> y, double at);

}  // namespace pileus::editor
