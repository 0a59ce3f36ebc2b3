#include "nodes/file/migrations.h"

#include <nlohmann/json.hpp>

namespace pileus::nodes {

// Format 1 is the first.
std::span<const Migration> migrations() { return {}; }

void migrate(nlohmann::json& file, int version, std::span<const Migration> steps) {
  for (const Migration& step : steps) {
    if (step.from < version) continue;
    step.apply(file);
    file["pileus"] = step.from + 1;
  }
}

}  // namespace pileus::nodes
