#pragma once
// Graph files for the tests of shootout and tune: two balls and a box in a row, with wide gaps, along the
// light.
#include <fstream>

#include "tests/support/support.h"

namespace pileus::test {

/// `shadow`: nodes between "Sun.light", "All.volume" and "Render.lights", with their links; each text begins
/// with a comma.
inline std::filesystem::path writeGapGraph(const std::filesystem::path& path, const std::string& shadowNodes,
                                           const std::string& shadowLinks) {
  std::ofstream(path, std::ios::binary) << R"({ "pileus": 1, "settings": { "size": [64, 36] }, "nodes": {
    "A": { "type": "volume.sphere", "at": [0, 0], "params": { "center": [-3, 0.2, 0], "radius": 0.7, "density": 1.4 } },
    "B": { "type": "volume.box", "at": [0, 0], "params": { "center": [0.5, 0, 0], "size": [0.4, 1.4, 1.4], "density": 1.5 } },
    "C": { "type": "volume.sphere", "at": [0, 0], "params": { "center": [3, -0.1, 0], "radius": 0.9, "density": 1.1 } },
    "All": { "type": "volume.merge", "at": [0, 0], "params": {} },
    "Sun": { "type": "light.sun", "at": [0, 0], "params": { "azimuth": -86, "elevation": 6 } },
    "Render": { "type": "render.volume", "at": [0, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [0, 0], "params": {} })"
                                        << shadowNodes << R"( },
  "links": [ "A.volume -> All.volumes", "B.volume -> All.volumes", "C.volume -> All.volumes", "All.volume -> Render.volumes", "Render.image -> View.image")"
                                        << shadowLinks << " ] }";
  return path;
}

inline std::filesystem::path writeIntervalGraph(const std::filesystem::path& path) {
  return writeGapGraph(
      path, R"(, "Metric": { "type": "shadow.pseudometric", "at": [0, 0], "params": { "resolution": 64 } },
    "Shadow": { "type": "shadow.extinction", "at": [0, 0], "params": {} })",
      R"(, "All.volume -> Metric.volumes", "Sun.light -> Metric.light", "Metric.metric -> Shadow.metric", "Shadow.light -> Render.lights")");
}

inline std::filesystem::path writeShadowGraph(const std::filesystem::path& path, const std::string& type) {
  return writeGapGraph(
      path, R"(, "Shadow": { "type": ")" + type + R"(", "at": [0, 0], "params": {} })",
      R"(, "All.volume -> Shadow.volumes", "Sun.light -> Shadow.light", "Shadow.light -> Render.lights")");
}

}  // namespace pileus::test
