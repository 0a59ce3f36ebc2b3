#pragma once
// Environments decoded by a child process under limits (renderer/base/import_child.h). Any thread.
#include "renderer/base/import_child.h"
#include "renderer/image/environment_file.h"

namespace pileus::image {

/// decodeEnvironment() in a child. Errors as there, and Cancelled.
Result<EnvironmentFile> importEnvironment(const std::filesystem::path& path, JobControl& control,
                                          const ImportLimits& limits = {});

/// The hidden subcommand: argv = <exe> import environment FILE MEMORY CPU. Returns the exit status.
int environmentChildMain(int argc, char** argv);
/// Are these arguments for it?
bool isEnvironmentChild(int argc, char** argv);

}  // namespace pileus::image
