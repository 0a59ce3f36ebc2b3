#pragma once
// A graph of any size, as a file holds it: a small scene that is rendered, and beside it chains of volumes,
// lights and shadow maps that nothing needs, so that showing it costs what showing costs.
#include <nlohmann/json.hpp>
#include <string>

namespace pileus::cli {

inline std::string bigGraph(int count) {
  using nlohmann::json;
  json nodes, links = json::array(), frames = json::array();
  const auto add = [&](const std::string& name, const char* type, double x, double y,
                       json params = json::object()) {
    nodes[name] = {{"type", type}, {"at", {x, y}}, {"params", std::move(params)}};
  };
  add("Box", "volume.box", 0, 0, {{"density", 3}});
  add("Sun", "light.sun", 0, 130, {{"elevation", 30}});
  add("Map", "shadow.extinction", 260, 60, {{"resolution", 64}});
  add("Render", "render.volume", 520, 0, {{"samples", 1}});
  add("View", "output.view", 780, 0);
  for (const char* link :
       {"Box.volume -> Map.volumes", "Sun.light -> Map.light", "Box.volume -> Render.volumes",
        "Map.light -> Render.lights", "Render.image -> View.image"})
    links.push_back(link);
  // Rows of six nodes, twelve rows to a column.
  for (int i = 0; static_cast<int>(nodes.size()) < count; ++i) {
    const std::string n = " " + std::to_string(i + 1);
    const double x = 1700.0 * (i / 12), y = 420.0 + 330.0 * (i % 12);
    const auto left = [&] { return count - static_cast<int>(nodes.size()); };
    add("Cloud" + n, "volume.box", x, y, {{"density", 0.1 * (i + 1)}});
    if (left() > 0) add("Sunlight" + n, "light.sun", x, y + 130, {{"elevation", 5 + i % 60}});
    if (left() > 0) add("Medium" + n, "volume.medium", x + 270, y);
    if (left() > 0) add("Metric" + n, "shadow.pseudometric", x + 540, y + 40, {{"resolution", 64}});
    if (left() > 0) add("Shadow" + n, "shadow.extinction", x + 810, y + 40, {{"resolution", 64}});
    if (left() > 0) add("Picture" + n, "render.volume", x + 1080, y);
    const auto link = [&](const char* from, const char* out, const char* to, const char* in) {
      if (nodes.contains(from + n) && nodes.contains(to + n))
        links.push_back(from + n + "." + out + " -> " + to + n + "." + in);
    };
    link("Cloud", "volume", "Medium", "volume");
    link("Medium", "volume", "Metric", "volumes");
    link("Sunlight", "light", "Metric", "light");
    link("Metric", "metric", "Shadow", "metric");
    link("Medium", "volume", "Picture", "volumes");
    link("Shadow", "light", "Picture", "lights");
    if (i % 12 == 0)
      frames.push_back({{"title", "Clouds" + n},
                        {"color", i % 24 == 0 ? "#3d6590" : "#4d7a45"},
                        {"at", {x - 40, 340.0}},
                        {"size", {1400.0, 4000.0}}});
  }
  return json{
      {"pileus", 1},
      {"settings",
       {{"size", {96, 54}}, {"frames", {1, 1}}, {"fps", 24}, {"ocio", ""}, {"workingSpace", "ACEScg"}}},
      {"nodes", nodes},
      {"links", links},
      {"frames", frames}}
      .dump(1);
}

}  // namespace pileus::cli
