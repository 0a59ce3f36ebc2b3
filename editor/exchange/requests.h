#pragma once
// What a room asks of those it does not know. Requests wait until the frame is drawn and are then carried out
// in order, so that nothing a frame has drawn with is replaced under it. UI thread.
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "editor/exchange/panel.h"
#include "renderer/base/math.h"

namespace pileus::editor {

struct Lost;  // editor/document/recovery.h

/// A row of the table of commands by its id ("file.save"), if it is enabled then.
struct RunCommand {
  std::string id;
};
/// A graph, volume or still takes the document's place, after a question where work is unsaved.
struct OpenFile {
  std::filesystem::path path;
};
/// The same of a preset that is part of the program ("default.json").
struct OpenPreset {
  std::string name;
};
/// A preset of one's own: a scene takes the document's place as OpenFile does, nodes are added, parameters go
/// to `node`, or to a new one.
struct UsePreset {
  std::filesystem::path file;
  std::string node;
  std::optional<dvec2> at;  ///< of nodes, canvas units; nothing: the middle of the canvas
};
struct ChangePreset {
  enum class How { Describe, Delete, Reveal };
  std::filesystem::path file;
  How how = How::Describe;
};
/// The same of work that an editor left behind.
struct OpenLost {
  std::shared_ptr<const Lost> lost;
};
/// Opens a panel where it cannot be seen, or hides it.
struct ShowPanel {
  Panel panel = Panel::Global;
  bool show = true;
};
using Request = std::variant<RunCommand, OpenFile, OpenPreset, UsePreset, ChangePreset, OpenLost, ShowPanel,
                             std::function<void()>>;

class Requests {
 public:
  void push(Request request) { waiting_.push_back(std::move(request)); }
  bool empty() const { return waiting_.empty(); }
  /// The oldest one, which is no longer in the queue.
  Request pop() {
    Request first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
  }

 private:
  std::deque<Request> waiting_;
};

}  // namespace pileus::editor
