#pragma once
// The search that adds nodes: fuzzy, recent types first; after a link was dropped on empty canvas it lists
// only what fits, socket by socket.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/graph_view/interaction.h"

namespace pileus::editor {

class PresetShelf;
struct Canvas;
struct GraphRoom;
struct Session;

/// The end of a dragged link that a new node must fit.
struct LinkFilter {
  bool fromOutput = true;
  nodes::SocketType type = nodes::SocketType::Volume;
};

struct SearchItem {
  const nodes::NodeType* type = nullptr;  ///< null: a preset of several nodes
  std::string socket;                     ///< which socket to link; "" without a filter
  std::string label;  ///< "Extinction Map", or "Extinction Map: Light" where several sockets fit
  std::filesystem::path preset = {};  ///< of one's own, of nodes or of a type's parameters; "" = none
  std::string about = {};             ///< of the preset
  std::string words = {};             ///< that find the preset besides its name
};

/// "Shadow"; presets are one of their own.
const std::string& categoryOf(const SearchItem& item);

/// Every node type (and socket) that fits, in menu order.
std::vector<SearchItem> searchItems(const std::optional<LinkFilter>& filter);
/// Presets of nodes and parameters; damaged ones and those of unknown types are left out.
std::vector<SearchItem> presetItems(const PresetShelf& shelf);
/// Indices into `items`, best first: by score, with an empty query recent types (newest first) before the
/// others.
std::vector<int> rankItems(const std::vector<SearchItem>& items, std::string_view query,
                           const std::vector<std::string>& recent);

struct NodeSearch {
  bool opening = false, open = false;
  vec2 at{0};     ///< screen position of the popup
  vec2 place{0};  ///< canvas position of the new node, or of its linked socket
  std::optional<LinkDrag> link;
  std::string query;
  std::string category;  ///< "" = all
  int chosen = 0;
  bool scrollToChosen = false;
  unsigned shelf = 0;  ///< the revision of the presets in `items`
  std::vector<SearchItem> items;
};

void openSearch(const Session& session, Canvas& canvas, vec2 screen, vec2 place,
                std::optional<LinkDrag> link = {});
/// Once a frame, after the canvas.
void drawSearch(const GraphRoom& room);

}  // namespace pileus::editor
