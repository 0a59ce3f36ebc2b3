#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "editor/cli/bench_tables.h"
#include "renderer/base/file.h"

namespace fs = std::filesystem;

namespace pileus::cli {

Result<void> benchEditor(const BenchSetup&) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
    return fail(Code::Input, "there is no display to open a window on (xvfb-run gives one)");
  std::string pattern = (fs::temp_directory_path() / "pileus-bench-XXXXXX").string();
  const fs::path home = ::mkdtemp(pattern.data());
  std::error_code ec;
  fs::create_directories(home / "config" / "pileus", ec);
  std::ofstream(home / "config" / "pileus" / "settings.json")
      << R"({ "window": [1280, 720], "showStart": false, "tourSeen": true })";
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("XDG_CONFIG_HOME", (home / "config").c_str(), 1);
    ::setenv("XDG_STATE_HOME", (home / "state").c_str(), 1);
    ::setenv("XDG_CACHE_HOME", (home / "cache").c_str(), 1);
    ::setenv("PILEUS_UI_SCALE", "1", 1);
    const std::string self = executablePath().string();
    ::execl(self.c_str(), self.c_str(), "bench", "--only", kEditorChild, nullptr);
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  fs::remove_all(home, ec);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return fail(Code::Internal, "the window's process failed");
  return {};
}

}  // namespace pileus::cli
