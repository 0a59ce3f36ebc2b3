#include "editor/commands/relink.h"

#include <fmt/core.h>

#include <map>

#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/parameters/file_state.h"
#include "editor/toolkit/file_listing.h"
#include "editor/toolkit/modals.h"
#include "nodes/graph/graph_animation.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr int kMostEntries = 100000;  // looked at below a folder
constexpr int kDeepest = 8;

void collect(const Session& session, const nodes::Graph& graph, const std::string& prefix,
             std::vector<MissingFile>& out) {
  for (const auto& [name, node] : graph.nodes) {
    if (node->group) collect(session, *node->group, prefix + name + "/", out);
    const nodes::NodeType* type = nodes::findNodeType(node->type);
    if (!type) continue;
    for (const nodes::ParamSpec& spec : type->params) {
      if (spec.type != nodes::ParamType::File || spec.writes) continue;
      for (const auto& [value, frame] : nodes::heldValues(*node, spec.id)) {
        const auto* text = std::get_if<std::string>(&value);
        std::error_code ec;
        if (text && !text->empty() && !fs::exists(firstOfPattern(absoluteFile(session, *text)), ec))
          out.push_back({prefix + name, spec.id, *text, frame});
      }
    }
  }
}

std::string fileName(const MissingFile& missing) { return fs::path(missing.text).filename().string(); }

bool names(const std::string& wanted, const std::string& name) {
  return isPattern(wanted) ? matchesPattern(wanted, name) : wanted == name;
}

/// Where each of these names is found, the nearest place of each.
std::map<std::string, fs::path> findBelow(const fs::path& folder, const std::vector<MissingFile>& missing) {
  std::map<std::string, fs::path> found;
  std::map<std::string, int> depths;
  std::error_code ec;
  int entries = 0;
  for (auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, ec);
       !ec && it != fs::recursive_directory_iterator() && entries < kMostEntries;
       it.increment(ec), ++entries) {
    if (it.depth() >= kDeepest) it.disable_recursion_pending();
    std::error_code ignored;
    if (!it->is_regular_file(ignored)) continue;
    const std::string name = it->path().filename().string();
    for (const MissingFile& m : missing) {
      const std::string wanted = fileName(m);
      if (!names(wanted, name) || (found.contains(wanted) && depths[wanted] <= it.depth())) continue;
      found[wanted] = it->path().parent_path() / wanted;
      depths[wanted] = it.depth();
    }
  }
  return found;
}

}  // namespace

std::vector<MissingFile> missingFiles(const Session& session) {
  std::vector<MissingFile> out;
  collect(session, session.document.root(), "", out);
  return out;
}

Result<nodes::Graph> relinked(const nodes::Graph& root, const std::vector<MissingFile>& missing,
                              const fs::path& folder, int& found) {
  const std::map<std::string, fs::path> places = findBelow(folder, missing);
  Result<nodes::Graph> graph = root;
  found = 0;
  for (const MissingFile& m : missing) {
    const auto place = places.find(fileName(m));
    if (!graph || place == places.end()) continue;
    graph = nodes::setParamAt(*graph, m.node, m.param, place->second.string(), m.frame.value_or(0));
    ++found;
  }
  return graph;
}

void showMissing(Editor& editor) {
  editor.modals.missing.clear();
  for (const MissingFile& m : missingFiles(editor.session)) {
    const std::string at = m.frame ? fmt::format(", frame {}", *m.frame) : "";
    editor.modals.missing.push_back(
        {m.node + "." + m.param + at, absoluteFile(editor.session, m.text).string()});
  }
  if (editor.modals.missing.empty()) editor.messages.hint("No file is missing.");
}

void askRelink(Editor& editor) {
  BrowserRequest request;
  request.title = "Find missing files in a folder";
  request.button = "Find Here";
  request.kinds = {"vdb"};
  request.folder = true;
  request.done = [&editor](const fs::path& folder) {
    const std::vector<MissingFile> missing = missingFiles(editor.session);
    int found = 0;
    Result<nodes::Graph> graph = relinked(editor.session.document.root(), missing, folder, found);
    if (found == 0)
      editor.messages.warn("None of the missing files is in " + folder.string());
    else if (tryEditRoot(editor.session, editor.messages, std::move(graph), "Find missing files"))
      editor.messages.info(fmt::format("{} of {} missing files found", found, missing.size()));
    if (found < static_cast<int>(missing.size())) showMissing(editor);
  };
  editor.modals.browser.open(editor.settings, std::move(request));
}

void tellMissing(Editor& editor) {
  const std::vector<MissingFile> missing = missingFiles(editor.session);
  if (missing.empty()) return;
  editor.messages.offer(missing.size() == 1 ? fmt::format("A file is missing: {}", fileName(missing.front()))
                                            : fmt::format("{} files are missing", missing.size()),
                        "Find\xe2\x80\xa6", "file.missing");
}

}  // namespace pileus::editor
