#include "editor/cli/info.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "renderer/volume/autofit.h"
#include "renderer/volume/vdb_import.h"

namespace pileus::cli {
namespace {

using volume::GridInfo;
using volume::VdbInfo;

struct Fit {
  std::string grid;
  volume::Autofit fit;
  std::uint64_t bricks = 0, bytes = 0;
};

/// Bytes that are no UTF-8 (a path may hold them) become U+FFFD.
std::string jsonString(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string number(double v) { return std::isfinite(v) ? fmt::format("{}", v) : "null"; }
std::string triple(const dvec3& v) {
  return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
}
std::string triple(const ivec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string bytesText(std::uint64_t bytes) {
  if (bytes < 10000) return fmt::format("{} B", bytes);
  if (bytes < 10000 * 1024ull) return fmt::format("{:.0f} KiB", double(bytes) / 1024);
  return fmt::format("{:.1f} MiB", double(bytes) / 1048576);
}

std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  return digits;
}

void printText(const std::filesystem::path& file, const VdbInfo& info, const Fit* fit) {
  fmt::print("{}: VDB written by library/format {}, {} grid{}\n", file.string(), info.version,
             info.grids.size(), info.grids.size() == 1 ? "" : "s");
  for (const auto& [key, value] : info.metadata) fmt::print("  {}: {}\n", key, value);
  for (const GridInfo& g : info.grids) {
    fmt::print("\n{}\n", g.name);
    fmt::print("  class      {}\n  type       {}\n", g.gridClass, g.valueType);
    fmt::print("  transform  {}, voxel {:.6g} x {:.6g} x {:.6g} m\n", g.transform, g.voxelSize.x,
               g.voxelSize.y, g.voxelSize.z);
    if (g.hasBounds) {
      fmt::print("  voxels     {} active, index [{}, {}, {}] to [{}, {}, {}]\n", grouped(g.activeVoxels),
                 g.indexMin.x, g.indexMin.y, g.indexMin.z, g.indexMax.x, g.indexMax.y, g.indexMax.z);
      if (!g.worldBounds.empty())
        fmt::print("  world      ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m\n",
                   g.worldBounds.min.x, g.worldBounds.min.y, g.worldBounds.min.z, g.worldBounds.max.x,
                   g.worldBounds.max.y, g.worldBounds.max.z);
    } else {
      fmt::print("  voxels     none active\n");
    }
    if (g.scalar)
      fmt::print("  values     {:.6g} to {:.6g}, background {:.6g}{}\n", g.minimum, g.maximum, g.background,
                 g.nonFinite ? fmt::format(", {} not finite", grouped(g.nonFinite)) : "");
    fmt::print("  memory     {}\n", bytesText(g.memoryBytes));
    if (!g.creator.empty()) fmt::print("  creator    {}\n", g.creator);
    fmt::print("  drawable   {}\n", g.drawable ? "yes" : fmt::format("no: {}", g.reason));
  }
  if (fit)
    fmt::print(
        "\nautofit: grid {}, extinction {:.4g} per metre and unit density (optical depth {:.3g} through the "
        "middle); {} bricks, {}\n",
        fit->grid, fit->fit.extinction, fit->fit.opticalDepth, grouped(fit->bricks), bytesText(fit->bytes));
  else
    fmt::print("\nautofit: nothing in this file can be drawn\n");
}

std::string jsonOf(const std::filesystem::path& file, const VdbInfo& info, const Fit* fit) {
  std::string out = fmt::format("{{\n  \"file\": {},\n  \"version\": {},\n  \"metadata\": {{",
                                jsonString(file.string()), jsonString(info.version));
  for (std::size_t i = 0; i < info.metadata.size(); ++i)
    out += fmt::format("{}{}: {}", i ? ", " : "", jsonString(info.metadata[i].first),
                       jsonString(info.metadata[i].second));
  out += "},\n  \"grids\": [";
  for (std::size_t i = 0; i < info.grids.size(); ++i) {
    const GridInfo& g = info.grids[i];
    out += fmt::format(
        "{}\n    {{\"name\": {}, \"class\": {}, \"type\": {}, \"transform\": {}, \"creator\": {},\n",
        i ? "," : "", jsonString(g.name), jsonString(g.gridClass), jsonString(g.valueType),
        jsonString(g.transform), jsonString(g.creator));
    out += "     \"worldFromIndex\": [";
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c)
        out += fmt::format("{}{}", r + c ? ", " : "", number(g.worldFromIndex[c][r]));
    out += fmt::format(
        "],\n     \"voxelSize\": {}, \"activeVoxels\": {}, \"memoryBytes\": {}, \"nonFinite\": {},\n",
        triple(g.voxelSize), g.activeVoxels, g.memoryBytes, g.nonFinite);
    if (g.hasBounds)
      out += fmt::format("     \"indexBounds\": [{}, {}], \"worldBounds\": [{}, {}],\n", triple(g.indexMin),
                         triple(g.indexMax), triple(g.worldBounds.min), triple(g.worldBounds.max));
    if (g.scalar)
      out += fmt::format("     \"minimum\": {}, \"maximum\": {}, \"background\": {},\n", number(g.minimum),
                         number(g.maximum), number(g.background));
    out += fmt::format("     \"drawable\": {}, \"reason\": {}}}", g.drawable, jsonString(g.reason));
  }
  out += info.grids.empty() ? "],\n" : "\n  ],\n";
  if (fit)
    out += fmt::format(
        "  \"autofit\": {{\"grid\": {}, \"extinction\": {}, \"opticalDepth\": {}, \"bricks\": {}, "
        "\"brickBytes\": {}}}\n}}",
        jsonString(fit->grid), number(fit->fit.extinction), number(fit->fit.opticalDepth), fit->bricks,
        fit->bytes);
  else
    out += "  \"autofit\": null\n}";
  return out;
}

int complain(const Error& e) {
  fmt::print(stderr, "pileus: {}\n", e.message);
  return static_cast<int>(e.code);
}

}  // namespace

namespace {

/// Its JSON goes to `json`, its text to standard output. Returns the exit code.
int listFile(const std::filesystem::path& file, std::string* json) {
  JobControl control;
  auto info = volume::inspectVdb(file, control);
  if (!info) return complain(info.error());
  std::optional<Fit> fit;
  const GridInfo* chosen = info->chosen >= 0 ? &info->grids[static_cast<std::size_t>(info->chosen)] : nullptr;
  if (chosen && chosen->drawable) {
    auto imported = volume::importVdb(file, chosen->name, control);
    if (!imported) return complain(imported.error());
    const volume::BrickGrid& g = *imported->grid;
    fit = Fit{chosen->name, volume::autofit(g), g.payloadCount,
              std::uint64_t(g.payloadCount) * volume::kStoredVoxels};
  }
  if (json)
    *json = jsonOf(file, *info, fit ? &*fit : nullptr);
  else
    printText(file, *info, fit ? &*fit : nullptr);
  std::fflush(stdout);
  for (const GridInfo& g : info->grids)
    if (g.damaged) return complain(fail(Code::Input, "{}: grid '{}': {}", file.string(), g.name, g.reason));
  return 0;
}

}  // namespace

int infoMain(const InfoOptions& options) {
  int status = 0;
  std::vector<std::string> objects;
  bool first = true;
  for (const std::filesystem::path& file : options.files) {
    if (!options.json && !std::exchange(first, false)) fmt::print("\n");
    std::string json;
    const int code = listFile(file, options.json ? &json : nullptr);
    if (status == 0) status = code;
    if (!json.empty()) objects.push_back(std::move(json));
  }
  if (options.json && options.files.size() == 1 && !objects.empty())
    fmt::print("{}\n", objects.front());
  else if (options.json && options.files.size() > 1)
    fmt::print("[\n{}\n]\n", fmt::join(objects, ",\n"));
  std::fflush(stdout);
  return status;
}

}  // namespace pileus::cli
