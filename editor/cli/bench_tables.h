#pragma once
// The tables `pileus bench` prints, one function and one file each.
#include <filesystem>

#include "renderer/view/renderer.h"

namespace pileus::cli {

struct BenchSetup {
  view::Renderer* renderer = nullptr;
  std::filesystem::path data;   ///< test volumes; empty: tables that need them return Error (Input)
};

/// Cold (empty caches) and warm start to the first lit picture, each in a process of its own.
Result<void> benchFirstPicture(const BenchSetup& setup);
inline constexpr const char* kFirstPictureChild = "first-picture-child";
int firstPictureChild();

/// Mean |dT| of ray family "two" for the paper's budgets (docs/bench.md).
Result<void> benchFigure2(const BenchSetup& setup);

/// The window itself, in a process of its own: what the interface costs and how long a drag waits.
Result<void> benchEditor(const BenchSetup& setup);
inline constexpr const char* kEditorChild = "editor-child";

/// Every representation on 76 clouds: error, memory, time.
Result<void> benchCloudField(const BenchSetup& setup);
/// Picture error and lookup cost on three clouds one behind the other.
Result<void> benchThreeClouds(const BenchSetup& setup);

/// Frame time and radiance difference of the map against the march.
Result<void> benchSpeed(const BenchSetup& setup);

}  // namespace pileus::cli
