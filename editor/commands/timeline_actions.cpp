// Commands of the timeline: frames, playback, keys.
#include "editor/commands/table.h"
#include "editor/time/playback.h"
#include "editor/time/timeline_clipboard.h"
#include "editor/time/timeline_edits.h"

namespace pileus::editor {
namespace {

using P = Panel;

bool playing(const Editor& e) { return e.timeline.clock.playing(); }
bool hasKeys(const Editor& e) { return !e.timeline.selected.empty(); }
void next(Editor& e) { stepFrame(e, 1); }
void previous(Editor& e) { stepFrame(e, -1); }
void nextKey(Editor& e) { goToKey(e, 1); }
void previousKey(Editor& e) { goToKey(e, -1); }

const Action kActions[] = {
    {"timeline.play", "Play or Pause", "View/Animation", P::Global, {}, togglePlay, nullptr, playing},
    {"timeline.next",
     "Next Frame",
     "View/Animation",
     P::Timeline,
     {plain(GLFW_KEY_PERIOD), plain(GLFW_KEY_RIGHT)},
     next},
    {"timeline.previous",
     "Previous Frame",
     "View/Animation",
     P::Timeline,
     {plain(GLFW_KEY_COMMA), plain(GLFW_KEY_LEFT)},
     previous},
    {"timeline.next_key", "Next Key", "View/Animation", P::Timeline, {shift(GLFW_KEY_PERIOD)}, nextKey},
    {"timeline.previous_key",
     "Previous Key",
     "View/Animation",
     P::Timeline,
     {shift(GLFW_KEY_COMMA)},
     previousKey},
    {"timeline.play_back",
     "Play Backward",
     "",
     P::Timeline,
     {plain(GLFW_KEY_J)},
     [](Editor& e) { play(e, -1); }},
    {"timeline.stop", "Stop", "", P::Timeline, {plain(GLFW_KEY_K)}, stopPlayback},
    {"timeline.play_forward",
     "Play Forward",
     "",
     P::Timeline,
     {plain(GLFW_KEY_L)},
     [](Editor& e) { play(e, 1); }},
    {"timeline.start",
     "To the Start",
     "",
     P::Timeline,
     {plain(GLFW_KEY_HOME)},
     [](Editor& e) { goToEnd(e, -1); }},
    {"timeline.end", "To the End", "", P::Timeline, {plain(GLFW_KEY_END)}, [](Editor& e) { goToEnd(e, 1); }},
    {"timeline.frame",
     "Show the Frame Range",
     "",
     P::Timeline,
     {plain(GLFW_KEY_F)},
     [](Editor& e) { e.timeline.fitted = false; }},
    {"timeline.key", "Set Keys of All Rows", "", P::Timeline, {plain(GLFW_KEY_I)}, keyShownRows},
    {"timeline.select_all", "Select All Keys", "", P::Timeline, {plain(GLFW_KEY_A)}, selectAllKeys},
    {"timeline.cut", "Cut Keys", "", P::Timeline, {ctrl(GLFW_KEY_X)}, cutSelectedKeys, hasKeys},
    {"timeline.copy", "Copy Keys", "", P::Timeline, {ctrl(GLFW_KEY_C)}, copySelectedKeys, hasKeys},
    {"timeline.paste", "Paste Keys", "", P::Timeline, {ctrl(GLFW_KEY_V)}, pasteKeys},
    {"timeline.delete",
     "Delete Keys",
     "",
     P::Timeline,
     {plain(GLFW_KEY_DELETE)},
     deleteSelectedKeys,
     hasKeys},
};

}  // namespace

std::span<const Action> timelineActions() { return kActions; }

}  // namespace pileus::editor
