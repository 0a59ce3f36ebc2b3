#pragma once
// The tables `pileus bench` prints, one function and one file each.
#include <filesystem>

#include "renderer/view/renderer.h"
#include "renderer/volume/instance.h"

namespace pileus::cli {

struct BenchSetup {
  view::Renderer* renderer = nullptr;
  std::filesystem::path data;  ///< test volumes; empty: tables that need them return Error (Input)
  std::filesystem::path plot;  ///< where the plot of the curve goes; empty: nowhere
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

/// Largest error at a silhouette.
Result<void> benchSilhouette(const BenchSetup& setup);
/// Error and size of compressed deep maps of smoke1.vdb.
Result<void> benchDeep(const BenchSetup& setup);
/// What maps of many parameters err by and cost on four scenes; the curve the defaults are the knee of.
Result<void> benchCurve(const BenchSetup& setup);
/// smoke1.vdb of the test volumes, extinction 0.5.
Result<volume::Instance> benchSmoke(const BenchSetup& setup);

/// A cloud under light from everywhere, against paths.
Result<void> benchEnvironments(const BenchSetup& setup);
/// render.volume, marched and by maps, against single scattering by paths on the scenes of the curve.
Result<void> benchJudge(const BenchSetup& setup);
/// Multiple scattering by lattices, octaves and none, against all orders by paths.
Result<void> benchScattering(const BenchSetup& setup);
/// Variance times processor time of the judge's ways to reach lights.
Result<void> benchJudgeSpeed(const BenchSetup& setup);

/// Frame time and radiance difference of the map against the march.
Result<void> benchSpeed(const BenchSetup& setup);

}  // namespace pileus::cli
