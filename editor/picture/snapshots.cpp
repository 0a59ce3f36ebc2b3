#include "editor/picture/snapshots.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"

namespace pileus::editor {
namespace {

std::string timeText() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::localtime_r(&now, &parts);
  return fmt::format("{:02}:{:02}:{:02}", parts.tm_hour, parts.tm_min, parts.tm_sec);
}

std::size_t freeSlot(const Snapshots& snapshots) {
  for (std::size_t slot = 0;; ++slot)
    if (std::none_of(snapshots.all.begin(), snapshots.all.end(),
                     [&](const Snapshot& s) { return s.slot == slot; }))
      return slot;
}

}  // namespace

std::size_t Snapshots::bytes() const {
  std::size_t sum = 0;
  for (const Snapshot& s : all) sum += s.picture->color.bytes();
  return sum;
}

void takeSnapshot(Messages& messages, Session& session, Shown& shown) {
  Snapshots& s = shown.snapshots;
  const auto& picture = shown.preview.picture();
  if (!picture) return messages.hint("There is no picture to keep yet.");
  if (s.all.size() >= Snapshots::kMost)
    return messages.hint(fmt::format("{} stills are kept at most: delete one first.", Snapshots::kMost));
  auto still = view::stillOf(*picture);
  if (!still) return messages.error(still.error().message);
  s.all.push_back({freeSlot(s), fmt::format("Still {}", s.next++), timeText(), std::move(*still),
                   session.document.root()});
  messages.note(s.all.back().name + " kept with its graph");
}

void toggleSnapshotWipe(Messages& messages, Shown& shown) {
  Snapshots& s = shown.snapshots;
  if (s.all.empty()) return messages.hint("There is no still to compare with: Shift+Enter keeps one.");
  s.wiping = !s.wiping;
  if (!s.wiping) return;
  shown.compare.on = false;
  if (!s.valid(s.left)) s.left = Snapshots::kPicture;
  if (!s.valid(s.right) || s.right == s.left) s.right = static_cast<int>(s.all.size()) - 1;
}

void deleteSnapshot(Messages& messages, Shown& shown, std::size_t index) {
  Snapshots& s = shown.snapshots;
  if (index >= s.all.size()) return;
  messages.note(s.all[index].name + " deleted");
  s.all.erase(s.all.begin() + static_cast<std::ptrdiff_t>(index));
  const auto gone = static_cast<int>(index);
  for (int* side : {&s.left, &s.right}) {
    if (*side == gone)
      s.wiping = false, *side = Snapshots::kPicture;
    else if (*side > gone)
      --*side;
  }
}

void restoreSnapshot(Messages& messages, Session& session, const Shown& shown, std::size_t index) {
  const Snapshots& s = shown.snapshots;
  if (index >= s.all.size()) return;
  if (s.all[index].graph == session.document.root())
    return messages.note("The graph is already that of " + s.all[index].name);
  session.document.endMerge();
  tryEditRoot(session, messages, s.all[index].graph, "Restore " + s.all[index].name);
  messages.note("Graph of " + s.all[index].name + " restored");
}

}  // namespace pileus::editor
