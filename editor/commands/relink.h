#pragma once
// Files that the document reads and that are not there: which, and finding all of them in another folder.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::editor {

struct Editor;
struct Session;

struct MissingFile {
  std::string node, param;      ///< node: its path
  std::string text;             ///< as the parameter has it
  std::optional<double> frame;  ///< of the key that has it; none: it is constant
};
/// In the order of nodes; those of groups too. Asks the disk.
std::vector<MissingFile> missingFiles(const Session& session);

/// Each missing file that is somewhere in the folder, by its name, is taken from there; `found`: how many
/// were. Of several the one nearest to the folder counts.
Result<nodes::Graph> relinked(const nodes::Graph& root, const std::vector<MissingFile>& missing,
                              const std::filesystem::path& folder, int& found);

/// The dialog that lists them.
void showMissing(Editor& editor);
/// Asks for a folder and takes from it what is there: one undo step.
void askRelink(Editor& editor);
/// A notice, where some are missing.
void tellMissing(Editor& editor);

}  // namespace pileus::editor
