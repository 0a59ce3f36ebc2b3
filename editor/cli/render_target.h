#pragma once
// Where `pileus render` writes: the frame in a file's name, what stands in the way, and the ways to write.
#include <filesystem>
#include <string>
#include <string_view>

#include "renderer/base/result.h"

namespace pileus::cli {

/// A name with a place for the frame. Only the file's own name is looked at: a folder called "shot#2" has
/// none.
struct FramePattern {
  std::string before, after;
  int width = 0;  ///< digits, filled up with zeros; 0: there is no place, every frame has the same name

  bool hasFrame() const { return width > 0; }
  std::string path(int frame) const;
};

/// The last run of '#' is the frame, else the last "%d", "%04d", "$F" or "$F4" (no letter may follow the
/// ones without digits: "100%done" is a name). Error (Arguments): two kinds of them in one name.
Result<FramePattern> framePattern(const std::string& out);

/// What `-o` can be.
enum class TargetKind { Exr, Png, StandardOutput };
/// "-" is standard output, "x.png" a PNG; "x.exr", and any device or pipe, an EXR. Error (Arguments): another
/// ending.
Result<TargetKind> targetKind(const std::string& out);

/// May the target be written? Asked before any work is done. Error (Input).
Result<void> checkTarget(const std::filesystem::path& path);

/// Error (Input).
Result<void> writeStandardOutput(std::string_view bytes);

}  // namespace pileus::cli
