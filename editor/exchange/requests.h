#pragma once
// What a room asks of those it does not know. Requests wait until the frame is drawn and are then carried out
// in order, so that nothing a frame has drawn with is replaced under it. UI thread.
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "editor/exchange/panel.h"

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
/// The same of work that an editor left behind.
struct OpenLost {
  std::shared_ptr<const Lost> lost;
};
/// Opens a panel where it cannot be seen, or hides it.
struct ShowPanel {
  Panel panel = Panel::Global;
  bool show = true;
};
using Request = std::variant<RunCommand, OpenFile, OpenPreset, OpenLost, ShowPanel, std::function<void()>>;

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
