// pileus: the editor, the command line, and the child process that reads VDB files.
#include <string_view>

#include "editor/app/app.h"
#include "editor/app/bench_window.h"
#include "editor/cli/cli.h"
#include "editor/commands/keyboard.h"
#include "renderer/volume/vdb_child.h"

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "import") return pileus::volume::importChildMain(argc, argv);
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
  return pileus::cli::run(argc, argv, side);
}
