#pragma once
// The document that is open, with what is known of its file and what keeps its unsaved work.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "editor/document/recovery.h"
#include "nodes/graph/document.h"
#include "renderer/base/hash.h"

namespace pileus::editor {

class Messages;

struct Session {
  nodes::Document document;
  Key diskStamp{};                          ///< of the document's file as it was last read or written here
  std::uint64_t generation = 0;             ///< counts the documents that were put in place
  std::optional<nodes::Link> selectedLink;  ///< links are selected apart from nodes, and never part of undo
  Recovery recovery;
};

/// An edit that may be refused: shows the reason in the status line, returns whether it was made.
bool tryEdit(Session& session, Messages& messages, Result<nodes::Graph> graph, const std::string& label,
             std::string_view mergeKey = {});
/// The same for the whole document, whatever scope the canvas shows.
bool tryEditRoot(Session& session, Messages& messages, Result<nodes::Graph> root, const std::string& label,
                 std::string_view mergeKey = {});
/// Name for titles: "harbour.json" or "Untitled".
std::string documentName(const Session& session);

}  // namespace pileus::editor
