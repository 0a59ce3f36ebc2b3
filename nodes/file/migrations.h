#pragma once
// Old file formats, brought up to date step by step as JSON, before anything else reads them.
#include <nlohmann/json_fwd.hpp>
#include <span>

namespace pileus::nodes {

/// Rewrites a file of format `from` as one of format `from + 1`. Pure; may assume only that the file is an
/// object.
struct Migration {
  int from = 1;
  void (*apply)(nlohmann::json& file) = nullptr;
};

/// All of them, in order. A change of a default adds one that writes the old value out.
std::span<const Migration> migrations();

/// Applies the steps a file of format `version` needs and sets its "pileus".
void migrate(nlohmann::json& file, int version, std::span<const Migration> steps);

}  // namespace pileus::nodes
