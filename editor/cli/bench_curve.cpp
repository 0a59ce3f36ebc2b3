#include <algorithm>
#include <array>
#include <cstdio>

#include <fmt/ranges.h>

#include "editor/cli/bench_tables.h"
#include "editor/cli/curve/plot.h"
#include "renderer/base/file.h"

namespace pileus::cli {
namespace {

using shadow::ShadowSpec;
using shadow::Storage;
using shadow::Weighting;

constexpr ivec2 kPicture{640, 360};   ///< of the errors
constexpr ivec2 kProcess{1280, 720};  ///< of whole processes

ShadowSpec map(int intervals, Storage ends, bool compact, int coefficients, Storage stored, int resolution,
               Weighting weighting, double horizon) {
  ShadowSpec s;
  s.metric.intervals = intervals;
  s.metric.storage = ends;
  s.metric.compact = compact;
  s.metric.weighting = weighting;
  s.metric.horizon = horizon;
  s.extinction.coefficients = coefficients;
  s.extinction.storage = stored;
  return shadow::withResolution(s, resolution);
}

/// Short and complete: what differs along the lines stands in it.
std::string nameOf(const ShadowSpec& s) {
  const shadow::MetricOptions& m = s.metric;
  const char* ends = m.compact ? "8 bits" : m.storage == Storage::Half ? "16 bits" : "float";
  return fmt::format("K={} {}{}{} + {} {}, {}", m.intervals, ends,
                     m.weighting == Weighting::Root ? ", weights" : "",
                     m.horizon > 0 ? fmt::format(", horizon {:g}", m.horizon) : "", s.extinction.coefficients,
                     s.extinction.storage == Storage::Half ? "half" : "float", s.extinction.resolution);
}

/// The default of format 1, lines through one point along every parameter, and what lies off them.
std::vector<CurveRow> rows(const ShadowSpec& present) {
  std::vector<ShadowSpec> specs;
  const auto add = [&](const ShadowSpec& s) {
    if (std::find(specs.begin(), specs.end(), s) == specs.end()) specs.push_back(s);
  };
  const ShadowSpec before = map(4, Storage::Float, false, 8, Storage::Float, 1024, Weighting::Root, 5.5);
  const ShadowSpec base = map(4, Storage::Float, false, 16, Storage::Half, 512, Weighting::Root, 5.5);
  add(before);
  add(present);
  add(base);
  const auto line = [&](const auto& values, const auto& set) {
    for (const auto& v : values) {
      ShadowSpec s = base;
      set(s, v);
      add(s);
    }
  };
  line(std::array{8, 12, 24, 32}, [](ShadowSpec& s, int n) { s.extinction.coefficients = n; });
  line(std::array{1, 2, 8}, [](ShadowSpec& s, int k) { s.metric.intervals = k; });
  line(std::array{Storage::Half}, [](ShadowSpec& s, Storage e) { s.metric.storage = e; });
  line(std::array{true}, [](ShadowSpec& s, bool c) { s.metric.compact = c; });
  line(std::array{Storage::Float}, [](ShadowSpec& s, Storage e) { s.extinction.storage = e; });
  line(std::array{256, 1024}, [](ShadowSpec& s, int n) { s = shadow::withResolution(s, n); });
  line(std::array{Weighting::None}, [](ShadowSpec& s, Weighting w) { s.metric.weighting = w; });
  line(std::array{0.0, 8.0, 12.0, 16.0}, [](ShadowSpec& s, double h) { s.metric.horizon = h; });
  // Around the knee.
  for (const int resolution : {256, 384, 512})
    for (const int coefficients : {24, 32}) {
      add(map(4, Storage::Float, false, coefficients, Storage::Half, resolution, Weighting::Root, 5.5));
      add(map(4, Storage::Float, false, coefficients, Storage::Half, resolution, Weighting::Root, 8));
    }
  // Corners of two and three parameters.
  for (const int resolution : {256, 512})
    for (const int intervals : {2, 4})
      for (const int coefficients : {12, 16, 24}) {
        add(map(intervals, Storage::Float, false, coefficients, Storage::Half, resolution, Weighting::None,
                8));
        add(map(intervals, Storage::Float, false, coefficients, Storage::Half, resolution, Weighting::None,
                0));
      }
  std::vector<CurveRow> out;
  for (const ShadowSpec& s : specs) {
    CurveRow row;
    row.name = nameOf(s);
    row.spec = s;
    row.before = s == before;
    row.present = s == present;
    out.push_back(std::move(row));
  }
  return out;
}

template <class Get>
std::string cells(const CurveRow& row, const char* format, const Get& get) {
  std::string out;
  for (const CurveMeasure& m : row.measures)
    out += (out.empty() ? "" : " / ") + fmt::format(fmt::runtime(format), get(m));
  return out;
}

void print(const CurveRow& row) {
  std::string seconds;
  for (const double s : row.seconds) seconds += (seconds.empty() ? "" : " / ") + fmt::format("{:.2f}", s);
  const char* mark = row.present ? "**" : "";
  fmt::print("| {}{}{}{} | {:.0f} | {:.1f} | {} | {} | {} | {} | {} |\n", mark, row.name, mark,
             row.before ? " (format 1)" : "", row.measures.front().bytesPerTexel,
             double(row.measures.front().bytes) / (1 << 20),
             cells(row, "{:.2f}", [](const CurveMeasure& m) { return 100 * m.radiance; }),
             cells(row, "{:.2f}", [](const CurveMeasure& m) { return 100 * m.scattered; }),
             cells(row, "{:.0f}", [](const CurveMeasure& m) { return m.mapMs; }),
             cells(row, "{:.0f}", [](const CurveMeasure& m) { return m.pictureMs; }), seconds);
  std::fflush(stdout);
}

/// Rows whose whole process is timed: both defaults, and what none beats in bytes and worst error.
std::vector<std::size_t> timedRows(const std::vector<CurveRow>& rows) {
  std::vector<dvec2> points;
  for (const CurveRow& row : rows) {
    double worst = 0;
    for (const CurveMeasure& m : row.measures) worst = std::max(worst, m.radiance);
    points.emplace_back(double(row.measures.front().bytes), worst);
  }
  std::vector<std::size_t> timed = paretoFront(points);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if ((rows[i].before || rows[i].present) && std::find(timed.begin(), timed.end(), i) == timed.end())
      timed.push_back(i);
  return timed;
}

}  // namespace

Result<void> benchCurve(const BenchSetup& setup) {
  if (setup.data.empty())
    return fail(Code::Input, "needs smoke1.vdb and others: set PILEUS_TEST_DATA or --data");
  PILEUS_TRY(const std::vector<CurveScene> scenes, curveScenes(setup.data));
  PILEUS_TRY(const ShadowSpec present, defaultShadow(scenes.front()));
  std::vector<CurveRow> table = rows(present);
  std::vector<std::string> names;
  for (const CurveScene& scene : scenes) {
    PILEUS_TRY(const CurveTruth truth, curveTruth(*setup.renderer, scene, kPicture));
    for (CurveRow& row : table) {
      PILEUS_TRY(const CurveMeasure m, measureCurve(*setup.renderer, truth, row.spec));
      row.measures.push_back(m);
    }
    names.push_back(scene.name);
  }
  for (const std::size_t i : timedRows(table))
    for (const CurveScene& scene : scenes) {
      PILEUS_TRY(const nodes::Graph graph, withShadow(scene, table[i].spec));
      PILEUS_TRY(const double seconds, renderSeconds(graph, kProcess));
      table[i].seconds.push_back(seconds);
    }
  fmt::print(
      "Each cell: {}. {} x {} pixels, one sample. Errors: sqrt(mean (a - b)^2) / mean b in percent, of "
      "radiance "
      "where alpha > 0.01 and of T^{} at what camera rays meet. Times are processor times; the whole process "
      "is `pileus render` at {} x {}, median of three.\n\n",
      fmt::join(names, " / "), kPicture.x, kPicture.y, kScatteredPower, kProcess.x, kProcess.y);
  fmt::print(
      "| map | bytes a texel | MiB | error of radiance, % | error of T^{}, % | map, ms | picture, ms | whole "
      "process, s |\n|---|---|---|---|---|---|---|---|\n",
      kScatteredPower);
  for (const CurveRow& row : table) print(row);
  if (!setup.plot.empty()) PILEUS_CHECK(writeFileAtomic(setup.plot, curvePlot(names, table)));
  return {};
}

}  // namespace pileus::cli
