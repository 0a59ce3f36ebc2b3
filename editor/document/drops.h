#pragma once
// Files that come in from outside: dropped on the window, named on the command line or chosen for import. A
// job reads them; what becomes of them: commands/drop_commands.h.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nodes/graph/graph.h"
#include "renderer/base/jobs.h"
#include "renderer/volume/vdb_fit.h"

namespace pileus::editor {

class Messages;

enum class DropKind { Graph, Volume, Still, Environment, Unknown };
/// By the ending, whatever its case.
DropKind dropKind(const std::filesystem::path& path);
/// Why a file of no use was not taken, and what can be done instead.
std::string whyNotDropped(const std::filesystem::path& path);

/// What was read of dropped files, away from the UI thread.
struct DropContent {
  std::vector<std::filesystem::path> graphs;
  std::vector<volume::VdbFit> volumes;
  std::vector<std::pair<std::filesystem::path, std::string>> stills;  ///< with the graph's text they carry
  std::vector<std::filesystem::path> environments;                    ///< pictures of light from everywhere
  std::vector<std::string> refusals;                                  ///< one sentence a file
  std::vector<std::string> notes;                                     ///< another frame was taken, and which
};
DropContent readDrops(const std::vector<std::filesystem::path>& paths, JobControl& control);

class Drops {
 public:
  /// Any number of files, at any time; those that come while others are read wait.
  void take(std::vector<std::filesystem::path> paths);
  bool reading() const { return job_ != nullptr; }
  /// Once a frame: starts reading; what was read, once.
  std::optional<DropContent> step(Messages& messages);

 private:
  std::vector<std::filesystem::path> waiting_;
  std::unique_ptr<Job<DropContent>> job_;
};

}  // namespace pileus::editor
