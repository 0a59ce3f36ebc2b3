#pragma once
// Graph files: JSON, two-space indent, sorted keys, shortest round-trip numbers, byte-identical on re-save.
// Format: docs/architecture.md.
#include <filesystem>
#include <string>
#include <vector>

#include "nodes/graph/graph_animation.h"

namespace pileus::nodes {

inline constexpr int kFormatVersion = 4;
inline constexpr int kLargestSize = 32768;  ///< of a picture, along each side

struct Fault {
  bool error = false;  ///< else a warning
  std::string where;   ///< "Sun.elevation", "links[2]", "settings.size", "line 4, column 7"
  std::string text;
  bool lost = false;  ///< what it is about is not in the graph: saving the graph deletes it
};

struct Loaded {
  Graph graph;
  /// Everything found, in the order of a saved file. A graph with errors still loads what it can: values
  /// outside their range and impossible links stay (their node fails in evaluation), only links to missing
  /// nodes, repeated links and broken nodes are left out.
  std::vector<Fault> faults;

  /// Something of the file is not in the graph.
  bool loses() const;
};

/// Error (Input) only where nothing can be loaded: unreadable, not JSON (line and column), not a Pileus
/// graph, a volume or a picture instead, newer version, nested deeper than 64.
Result<Loaded> parseGraph(std::string_view text);
Result<Loaded> loadGraph(const std::filesystem::path& path);  ///< the same; messages begin with the path

std::string graphText(const Graph& graph);
/// Atomic. File parameters are written relative to `path`'s folder, absolute where they share no more than
/// the root with it; in memory they stay as typed. Relative ones in memory start in `folder` (the document's
/// before a "save as"; default: `path`'s). Where the file that is there loses something by being read
/// (Loaded::loses), a copy of it is kept first; `kept` is where.
Result<void> saveGraph(const std::filesystem::path& path, const Graph& graph,
                       const std::filesystem::path& folder = {}, std::filesystem::path* kept = nullptr);
/// Copies a file beside itself, as NAME.bak, or NAME.bak2 and so on where that holds something else. Gives
/// the copy's path.
Result<std::filesystem::path> backUp(const std::filesystem::path& path);
/// The text that saveGraph writes: also for files that carry a graph beside other things.
std::string graphTextFor(const std::filesystem::path& path, const Graph& graph,
                         const std::filesystem::path& folder = {});

/// The graph with file parameters, and the colour configuration, that start in `from` written as seen from
/// `to` (absolute paths where they share the root only).
Graph withRelativePaths(const Graph& graph, const std::filesystem::path& from,
                        const std::filesystem::path& to);

/// A part of a graph as text for the clipboard, and back with free names; `at` is where its centre goes.
/// Files are absolute there, as another document may lie elsewhere; relative ones start in `folder` (none:
/// they stay).
std::string copyText(const Graph& graph, const std::set<std::string>& names,
                     const std::filesystem::path& folder = {});
Result<Graph> pasteText(const Graph& graph, std::string_view text, dvec2 at,
                        std::set<std::string>* pasted = nullptr);
/// The same with the nodes of a file. Its relative paths become those of `folder`, absolute without one.
Result<Graph> mergeGraph(const Graph& graph, const std::filesystem::path& file,
                         const std::filesystem::path& folder, dvec2 at,
                         std::set<std::string>* pasted = nullptr);

/// Keys as text for the clipboard, and back: the earliest goes to `frame`, the others keep their distance,
/// keys that are there are replaced. Keys of one node go to the node `onto`, if that is not empty; else to
/// the nodes they were of. All or none.
std::string copyKeysText(const Graph& graph, const std::set<KeyAt>& keys);
Result<Graph> pasteKeysText(const Graph& graph, std::string_view text, double frame,
                            const std::string& onto = {}, std::set<KeyAt>* pasted = nullptr);

/// "error: where: text" as panels show it; the command line puts the file before it.
std::string faultText(const Fault& fault);

}  // namespace pileus::nodes
