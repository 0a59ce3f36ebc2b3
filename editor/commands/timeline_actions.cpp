// Commands of the timeline: frames, playback, keys.
#include "editor/commands/table.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/time/timeline_edits.h"
#include "editor/timeline_view/timeline_clipboard.h"
#include "editor/timeline_view/timeline_state.h"

namespace pileus::editor {
namespace {

using P = Panel;

bool playing(const Editor& e) { return e.clock.play.playing(); }
bool hasKeys(const Editor& e) { return !e.clock.keys.selected.empty(); }
void next(Editor& e) { stepFrame(e.clock, 1); }
void previous(Editor& e) { stepFrame(e.clock, -1); }
void nextKey(Editor& e) { goToKey(e.messages, e.session, e.clock, 1); }
void previousKey(Editor& e) { goToKey(e.messages, e.session, e.clock, -1); }

const Action kActions[] = {
    {.id = "timeline.play",
     .label = "Play or Pause",
     .menu = "View/Animation",
     .panel = P::Global,
     .run = [](Editor& e) { togglePlay(e.messages, e.requests, e.session, e.clock); },
     .checked = playing},
    {.id = "timeline.next",
     .label = "Next Frame",
     .menu = "View/Animation",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_PERIOD), plain(GLFW_KEY_RIGHT)},
     .run = next},
    {.id = "timeline.previous",
     .label = "Previous Frame",
     .menu = "View/Animation",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_COMMA), plain(GLFW_KEY_LEFT)},
     .run = previous},
    {.id = "timeline.next_key",
     .label = "Next Key",
     .menu = "View/Animation",
     .panel = P::Timeline,
     .keys = {shift(GLFW_KEY_PERIOD)},
     .run = nextKey},
    {.id = "timeline.previous_key",
     .label = "Previous Key",
     .menu = "View/Animation",
     .panel = P::Timeline,
     .keys = {shift(GLFW_KEY_COMMA)},
     .run = previousKey},
    {.id = "timeline.play_back",
     .label = "Play Backward",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_J)},
     .run = [](Editor& e) { play(e.messages, e.requests, e.session, e.clock, -1); }},
    {.id = "timeline.stop",
     .label = "Stop",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_K)},
     .run = [](Editor& e) { stopPlayback(e.clock); }},
    {.id = "timeline.play_forward",
     .label = "Play Forward",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_L)},
     .run = [](Editor& e) { play(e.messages, e.requests, e.session, e.clock, 1); }},
    {.id = "timeline.start",
     .label = "To the First Frame",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_HOME)},
     .run = [](Editor& e) { goToEnd(e.session, e.clock, -1); }},
    {.id = "timeline.end",
     .label = "To the Last Frame",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_END)},
     .run = [](Editor& e) { goToEnd(e.session, e.clock, 1); }},
    {.id = "timeline.frame",
     .label = "Show the Frame Range",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_F)},
     .run = [](Editor& e) { e.timeline.fitted = false; }},
    {.id = "timeline.key",
     .label = "Set Keys of All Rows",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_I)},
     .run = [](Editor& e) { keyShownRows(e.messages, e.session, e.clock); }},
    {.id = "timeline.select_all",
     .label = "Select All Keys",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_A)},
     .run = [](Editor& e) { selectAllKeys(e.session, e.clock); }},
    {.id = "timeline.cut",
     .label = "Cut Keys",
     .panel = P::Timeline,
     .keys = {ctrl(GLFW_KEY_X)},
     .run = [](Editor& e) { cutSelectedKeys(e.messages, e.session, e.clock); },
     .enabled = hasKeys},
    {.id = "timeline.copy",
     .label = "Copy Keys",
     .panel = P::Timeline,
     .keys = {ctrl(GLFW_KEY_C)},
     .run = [](Editor& e) { copySelectedKeys(e.messages, e.session, e.clock); },
     .enabled = hasKeys},
    {.id = "timeline.paste",
     .label = "Paste Keys",
     .panel = P::Timeline,
     .keys = {ctrl(GLFW_KEY_V)},
     .run = [](Editor& e) { pasteKeys(e.messages, e.session, e.clock); }},
    {.id = "timeline.delete",
     .label = "Delete Keys",
     .panel = P::Timeline,
     .keys = {plain(GLFW_KEY_DELETE)},
     .run = [](Editor& e) { deleteSelectedKeys(e.messages, e.session, e.clock); },
     .enabled = hasKeys},
};

}  // namespace

std::span<const Action> timelineActions() { return kActions; }

}  // namespace pileus::editor
