#pragma once
// The child process that parses VDB files, and what it says to its parent. See vdb_import.h.
#include <optional>
#include <string>
#include <string_view>

#include "renderer/base/result.h"
#include "renderer/volume/vdb_import.h"

namespace pileus::volume {

/// The hidden subcommand: argv = <exe> import inspect FILE MEMORY CPU | <exe> import grid FILE NAME STORE
/// LEVELSETS MEMORY CPU (limits in bytes and seconds). Speaks on standard output as import_child.h says.
/// Returns the exit status.
int importChildMain(int argc, char** argv);

/// Begins a note of a store that names another grid of the file (a warning never begins so).
inline constexpr std::string_view kOtherGrid = "\x01grid ";

/// The note that says that the grid was a level set.
inline constexpr std::string_view kWasLevelSet = "\x01level set";

std::string encodeInfo(const VdbInfo& info);
std::optional<VdbInfo> decodeInfo(std::string_view bytes);

}  // namespace pileus::volume
