#pragma once
// The command line: parses and dispatches. Exit codes are those of pileus::Code.
#include <filesystem>
#include <functional>

namespace pileus::cli {

/// `openEditor` is called for `pileus [FILE]`; returns the exit code.
int run(int argc, char** argv, const std::function<int(const std::filesystem::path&)>& openEditor);

}  // namespace pileus::cli
