#include "editor/parameters/grid_names.h"

#include <fmt/core.h>

namespace pileus::editor {
namespace {

constexpr std::size_t kMostFiles = 16;

std::string about(const volume::GridInfo& g) {
  std::string text = g.gridClass + ", " + g.valueType;
  if (g.hasBounds) {
    const ivec3 size = g.indexMax - g.indexMin + 1;
    text += fmt::format(", {} x {} x {}", size.x, size.y, size.z);
  }
  return g.drawable || g.reason.empty() ? text : text + ": " + g.reason;
}

}  // namespace

GridList gridsOf(GridNames& names, const std::filesystem::path& file) {
  GridList list;
  std::error_code ec;
  const auto stamp = std::filesystem::last_write_time(file, ec);
  if (ec) {
    list.ready = true;
    list.error = "The file cannot be read.";
    return list;
  }
  if (names.files.size() > kMostFiles && !names.files.contains(file.string())) names.files.clear();
  GridNames::File& known = names.files[file.string()];
  if (!known.job || (known.job->done() && known.stamp != stamp)) {
    known.stamp = stamp;
    known.job =
        looseJob<volume::VdbInfo>([file](JobControl& control) { return volume::inspectVdb(file, control); });
  }
  if (!known.job->done()) return list;
  list.ready = true;
  const Result<volume::VdbInfo>& info = known.job->result();
  if (!info)
    list.error = info.error().message;
  else
    for (const volume::GridInfo& g : info->grids) list.items.push_back({g.name, about(g), g.drawable});
  return list;
}

}  // namespace pileus::editor
