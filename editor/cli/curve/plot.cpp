#include "editor/cli/curve/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pileus::cli {
namespace {

constexpr double kWidth = 250, kHeight = 190;  // of a panel
constexpr double kLeft = 78, kTop = 84;        // of the first one
constexpr double kStepX = 280, kStepY = 262;   // from one to the next
constexpr double kGoal = 0.02;
constexpr const char* kFront = "#1f6fb4";
constexpr const char* kBefore = "#c8372d";
constexpr const char* kPresent = "#1d8a4a";

/// A logarithmic axis of a row of panels.
struct Axis {
  double least = 1, most = 10;
  std::vector<double> ticks;
  double part(double value) const {
    return std::clamp(std::log(value / least) / std::log(most / least), 0.0, 1.0);
  }
};

/// Around all values, with ticks at 1, 2 and 5.
Axis around(const std::vector<double>& values) {
  Axis axis;
  axis.least = *std::min_element(values.begin(), values.end()) / 1.15;
  axis.most = *std::max_element(values.begin(), values.end()) * 1.15;
  for (int decade = -6; decade < 7; ++decade)
    for (const double digit : {1.0, 2.0, 5.0})
      if (const double v = digit * std::pow(10.0, decade); v >= axis.least && v <= axis.most)
        axis.ticks.push_back(v);
  return axis;
}

/// One row of panels: a cost against an error.
struct Kind {
  const char *title, *cost, *error;
  double (*x)(const CurveMeasure&);
  double (*y)(const CurveMeasure&);
};
constexpr Kind kKinds[] = {
    {"Picture against memory", "MiB of the map", "error of radiance",
     [](const CurveMeasure& m) { return double(m.bytes) / (1 << 20); },
     [](const CurveMeasure& m) { return m.radiance; }},
    {"Picture against time", "processor time of map and picture, s", "error of radiance",
     [](const CurveMeasure& m) { return 1e-3 * (m.mapMs + m.pictureMs); },
     [](const CurveMeasure& m) { return m.radiance; }},
    {"T^0.28 against memory", "MiB of the map", "error of T^0.28",
     [](const CurveMeasure& m) { return double(m.bytes) / (1 << 20); },
     [](const CurveMeasure& m) { return m.scattered; }},
};

std::string text(double x, double y, const std::string& what, const std::string& more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, more, what);
}

std::string diamond(dvec2 at, double r) {
  return fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}l{2} {2}l-{2} {2}l-{2} -{2}z\" fill=\"{3}\" stroke=\"#fff\"/>\n", at.x,
      at.y - r, r, kPresent);
}

std::string square(dvec2 at, double r) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"#fff\"/>\n", at.x - r,
      at.y - r, 2 * r, 2 * r, kBefore);
}

std::string dot(dvec2 at, const std::string& title) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"><title>{}</title></circle>\n", at.x, at.y,
                     title);
}

/// Frame, grid and the numbers of its axes.
std::string grid(const Axis& x, const Axis& y, dvec2 at, bool numbers) {
  std::string out;
  for (const double tick : x.ticks) {
    const double px = at.x + kWidth * x.part(tick);
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}v{}\"/>\n", px, at.y, kHeight);
    out += text(px, at.y + kHeight + 14, fmt::format("{:g}", tick), "class=\"tick\" text-anchor=\"middle\"");
  }
  for (const double tick : y.ticks) {
    const double py = at.y + kHeight * (1 - y.part(tick));
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}h{}\"/>\n", at.x, py, kWidth);
    if (numbers)
      out += text(at.x - 6, py + 4, fmt::format("{:g} %", 100 * tick), "class=\"tick\" text-anchor=\"end\"");
  }
  if (const double part = y.part(kGoal); part > 0 && part < 1)
    out += fmt::format("<path class=\"goal\" d=\"M{:.1f} {:.1f}h{}\"/>\n", at.x, at.y + kHeight * (1 - part),
                       kWidth);
  return out + fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\"/>\n",
                           at.x, at.y, kWidth, kHeight);
}

std::string panel(const Kind& kind, const std::vector<CurveRow>& rows, std::size_t scene, const Axis& x,
                  const Axis& y, dvec2 at) {
  const auto place = [&](const dvec2& v) {
    return at + dvec2(kWidth * x.part(v.x), kHeight * (1 - y.part(v.y)));
  };
  std::vector<dvec2> points;
  for (const CurveRow& row : rows)
    points.emplace_back(kind.x(row.measures[scene]), kind.y(row.measures[scene]));
  std::string out = "<g class=\"point\">\n", marks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out += dot(place(points[i]),
               fmt::format("{}: {:.2g}, {:.2f} %", rows[i].name, points[i].x, 100 * points[i].y));
    if (rows[i].before) marks += square(place(points[i]), 5);
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].present) marks += diamond(place(points[i]), 7);
  out += "</g>\n<path class=\"front\" d=\"";
  char step = 'M';
  for (const std::size_t i : paretoFront(points)) {
    const dvec2 p = place(points[i]);
    out += fmt::format("{}{:.1f} {:.1f}", std::exchange(step, 'L'), p.x, p.y);
  }
  return out + "\"/>\n" + marks;
}

/// Above all panels.
std::string legend() {
  std::string out;
  double x = kLeft;
  const double y = 44;
  const auto entry = [&](const std::string& mark, const std::string& what, double width) {
    out += mark + text(x + 14, y + 4, what);
    x += width;
  };
  entry("<g class=\"point\">" + dot({x + 4, y}, "a map") + "</g>", "a map", 76);
  entry(fmt::format("<path class=\"front\" d=\"M{} {}h18\"/>", x - 8, y), "none is better in both", 176);
  entry(square({x + 4, y}, 5), "default of format 1", 158);
  entry(diamond({x + 4, y}, 7), "default", 84);
  entry(fmt::format("<path class=\"goal\" d=\"M{} {}h18\"/>", x - 8, y), "goal, 2 %", 0);
  return out;
}

}  // namespace

std::vector<std::size_t> paretoFront(const std::vector<dvec2>& points) {
  std::vector<std::size_t> order(points.size(), 0), front;
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
  });
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order)
    if (points[i].y < best) best = points[i].y, front.push_back(i);
  return front;
}

std::string curvePlot(const std::vector<std::string>& scenes, const std::vector<CurveRow>& rows) {
  const double width = kLeft + kStepX * double(scenes.size()),
               height = kTop + kStepY * std::size(kKinds) - 12;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\">\n"
      "<style>text{{font:12px sans-serif;fill:#333}}.title{{font-size:15px;font-weight:600}}"
      ".tick{{font-size:10.5px;fill:#666}}.head{{font-weight:600}}.grid{{stroke:#e4e4e4}}"
      ".frame{{fill:none;stroke:#999}}.point{{fill:#a9b4bf}}.goal{{stroke:#888;stroke-dasharray:5 4}}"
      ".front{{fill:none;stroke:{2};stroke-width:2}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height, kFront);
  out +=
      text(kLeft, 22, "Error of shadow maps against marched shadows, and what they cost", "class=\"title\"");
  out += legend();
  double top = kTop;
  for (const Kind& kind : kKinds) {
    std::vector<double> xs, ys{kGoal};
    for (const CurveRow& row : rows)
      for (const CurveMeasure& m : row.measures) xs.push_back(kind.x(m)), ys.push_back(kind.y(m));
    const Axis x = around(xs), y = around(ys);
    out += text(18, top + kHeight / 2, kind.error,
                fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {:.1f})\"", top + kHeight / 2));
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const dvec2 at(kLeft + kStepX * double(i), top);
      out += text(at.x, at.y - 8, i == 0 ? fmt::format("{}: {}", kind.title, scenes[i]) : scenes[i],
                  "class=\"head\"");
      out += grid(x, y, at, i == 0) + panel(kind, rows, i, x, y, at);
      out += text(at.x + kWidth / 2, at.y + kHeight + 30, kind.cost, "text-anchor=\"middle\"");
    }
    top += kStepY;
  }
  return out + "</svg>\n";
}

}  // namespace pileus::cli
