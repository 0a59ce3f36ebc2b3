// pileus: the editor, the command line, and the child process that reads VDB files.
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "editor/app/app.h"
#include "editor/app/bench_window.h"
#include "editor/cli/cli.h"
#include "editor/commands/keyboard.h"
#include "editor/document/preset_shelf.h"
#include "editor/preferences/settings.h"
#include "editor/start/start_view.h"
#include "renderer/base/file.h"
#include "renderer/base/jobs.h"
#include "renderer/image/environment_import.h"
#include "renderer/volume/vdb_child.h"

namespace {

/// Mesa maps the files of its shader cache: on a full disk the first write to them is a bus error, which ends
/// the process. There it goes without; our own caches say that they cannot be written to.
void spareShaderCacheOnAFullDisk() {
  namespace fs = std::filesystem;
  constexpr std::uintmax_t kEnough = std::uintmax_t(16) << 20;
  const char* asked = std::getenv("MESA_SHADER_CACHE_DIR");
  fs::path folder = asked ? fs::path(asked) : pileus::cacheFolder();
  std::error_code ec;
  while (!fs::exists(folder, ec) && folder.has_relative_path()) folder = folder.parent_path();
  const fs::space_info space = fs::space(folder, ec);
  if (!ec && space.available < kEnough) ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
}

}  // namespace

int main(int argc, char** argv) {
  if (pileus::image::isEnvironmentChild(argc, argv)) return pileus::image::environmentChildMain(argc, argv);
  if (argc > 1 && std::string_view(argv[1]) == "import") return pileus::volume::importChildMain(argc, argv);
  spareShaderCacheOnAFullDisk();
  pileus::cli::EditorSide side;
  side.open = [](const std::filesystem::path& file) {
    pileus::editor::EditorOptions options;
    options.file = file;
    return pileus::editor::runEditor(options);
  };
  side.keys = [](bool markdown) {
    return markdown ? pileus::editor::keyboardMarkdown() : pileus::editor::keyboardText();
  };
  side.measure = pileus::editor::benchWindow;
  side.shippedPresets = [] {
    std::vector<pileus::cli::ShippedPreset> all;
    for (const pileus::editor::PresetText& p : pileus::editor::galleryTexts())
      all.push_back({p.file, p.name, p.about, pileus::nodes::presetTags(p.tags)});
    return all;
  };
  side.presetFolders = [] {
    return pileus::editor::presetFolders(pileus::editor::loadSettings(pileus::configFolder()));
  };
  const int code = pileus::cli::run(argc, argv, side);
  pileus::joinRetiredJobs();
  return code;
}
