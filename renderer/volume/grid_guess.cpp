#include "renderer/volume/grid_guess.h"
#include "renderer/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

#include <fmt/core.h>

namespace pileus::volume {
namespace {

/// "Density[2]" -> "density", "vel.x" -> "vel".
std::string baseName(std::string_view name) {
  if (const auto bracket = name.rfind('['); bracket != std::string_view::npos && name.ends_with(']'))
    name = name.substr(0, bracket);
  for (const char* part : {".x", ".y", ".z", "_x", "_y", "_z"})
    if (name.size() > 2 && name.ends_with(part)) name.remove_suffix(2);
  return lowered(name);
}

bool isFog(const GridInfo& g) { return g.gridClass == "fog volume"; }
bool isFloating(const GridInfo& g) {
  return g.valueType == "float" || g.valueType == "half" || g.valueType == "double";
}

int rank(const GridInfo& g) {
  if (!g.drawable) return 9;
  if (g.gridClass == "level set") return 6;  // fog before surfaces
  const GridRole role = roleOfGrid(g.name);
  if (isFloating(g) && role == GridRole::Density) return isFog(g) ? 0 : 1;
  if (role != GridRole::Unknown && role != GridRole::Density) return 5;
  if (isFog(g)) return isFloating(g) ? 2 : 3;
  return isFloating(g) ? 3 : 4;
}

std::string_view roleText(GridRole role) {
  switch (role) {
    case GridRole::Temperature:
      return "temperature: a Black Body behind a VDB File of this grid shows it glow";
    case GridRole::Flame:
      return "flames: a Black Body behind a VDB File of this grid shows them glow";
    case GridRole::Fuel:
      return "fuel: not drawn";
    case GridRole::Velocity:
      return "velocity: motion blur is not rendered yet, so it is left out";
    case GridRole::Color:
      return "colour: colour grids are not rendered yet; set the medium's albedo instead";
    case GridRole::Shadow:
      return "a baked shadow: not needed, shadows are computed";
    case GridRole::Density:
      return "another density: set the node's grid to it, or add a second node";
    case GridRole::Unknown:
      break;
  }
  return "not used";
}

}  // namespace

GridRole roleOfGrid(std::string_view name) {
  static const std::map<std::string, GridRole, std::less<>> kRoles = {
      {"density", GridRole::Density},
      {"smoke", GridRole::Density},
      {"soot", GridRole::Density},
      {"dens", GridRole::Density},
      {"temperature", GridRole::Temperature},
      {"heat", GridRole::Temperature},
      {"temp", GridRole::Temperature},
      {"flame", GridRole::Flame},
      {"flames", GridRole::Flame},
      {"burn", GridRole::Flame},
      {"fire", GridRole::Flame},
      {"emission", GridRole::Flame},
      {"fuel", GridRole::Fuel},
      {"v", GridRole::Velocity},
      {"vel", GridRole::Velocity},
      {"velocity", GridRole::Velocity},
      {"cd", GridRole::Color},
      {"color", GridRole::Color},
      {"colour", GridRole::Color},
      {"shadow", GridRole::Shadow},
  };
  const auto it = kRoles.find(baseName(name));
  return it == kRoles.end() ? GridRole::Unknown : it->second;
}

std::string_view confidenceText(Confidence confidence) {
  switch (confidence) {
    case Confidence::Sure:
      return "sure";
    case Confidence::Likely:
      return "likely";
    case Confidence::Guess:
      break;
  }
  return "a guess";
}

GridGuess guessGrid(std::span<const GridInfo> grids) {
  GridGuess out;
  const auto best = std::min_element(grids.begin(), grids.end(),
                                     [](const GridInfo& a, const GridInfo& b) { return rank(a) < rank(b); });
  if (best == grids.end() || rank(*best) == 9) {
    out.why = "the file holds no grid that can be drawn";
    for (const GridInfo& g : grids)
      out.notes.push_back(fmt::format("{}: {}", g.name, g.reason.empty() ? "not drawn" : g.reason));
    return out;
  }
  out.grid = best->name;
  const GridRole role = roleOfGrid(best->name);
  const auto fogs = std::count_if(grids.begin(), grids.end(),
                                  [](const GridInfo& g) { return g.drawable && isFog(g) && isFloating(g); });
  if (best->gridClass == "level set") {
    out.why = "a level set, drawn as fog inside its surface";
    out.confidence = Confidence::Likely;
  } else if (role == GridRole::Density) {
    out.why = fmt::format("by its name{}", isFog(*best) ? ", and it is a fog volume" : "");
    out.confidence = isFog(*best) ? Confidence::Sure : Confidence::Likely;
  } else if (isFog(*best) && role == GridRole::Unknown) {
    out.why = fogs == 1 ? "the only fog volume" : "the first fog volume";
    out.confidence = fogs == 1 ? Confidence::Likely : Confidence::Guess;
  } else {
    out.why = "no grid is called density or smoke; this one has numbers to show";
  }
  std::vector<std::string> names;
  for (const GridInfo& g : grids)
    if (g.name != best->name) names.push_back(g.name);
  out.notes = notesOnOthers(names);
  return out;
}

std::string whyByName(std::string_view chosen) {
  switch (roleOfGrid(chosen)) {
    case GridRole::Density:
      return "chosen by its name (sure)";
    case GridRole::Unknown:
      return "chosen by its class, no grid is called density or smoke (a guess)";
    default:
      return "no grid is called density or smoke; shown as density (a guess)";
  }
}

std::vector<std::string> notesOnOthers(std::span<const std::string> names) {
  std::vector<std::string> out;
  std::string rest;
  std::array<bool, 8> said{};  // the three components of a velocity need one sentence
  for (const std::string& name : names) {
    const GridRole role = roleOfGrid(name);
    if (role == GridRole::Unknown) {
      rest += (rest.empty() ? "" : ", ") + name;
      continue;
    }
    if (role != GridRole::Density && std::exchange(said[static_cast<std::size_t>(role)], true)) continue;
    out.push_back(fmt::format("'{}' looks like {}", name, roleText(role)));
  }
  if (!rest.empty()) out.push_back("Not used: " + rest);
  return out;
}

}  // namespace pileus::volume
