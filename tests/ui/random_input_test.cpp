// Two thousand random events into the real window: it must stay alive, log no error, keep its memory and
// answer afterwards. $PILEUS_RANDOM_SEED chooses others. Fewer under LeakSanitizer: it must have lost
// nothing.
#include <random>

#include "nodes/file/serialize.h"
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

constexpr int kEvents = 2000, kBatch = 20, kEventsForLeaks = 400;

constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [96, 54] },
  "nodes": {
    "Ball": { "type": "volume.sphere", "at": [0, 0], "params": { "density": 3 } },
    "Box": { "type": "volume.box", "at": [0, 130], "params": {} },
    "Sun": { "type": "light.sun", "at": [0, 260], "params": {} },
    "Map": { "type": "shadow.extinction", "at": [260, 130], "params": { "resolution": 64 } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [780, 0], "params": {} }
  },
  "links": ["Ball.volume -> Render.volumes", "Box.volume -> Map.volumes", "Sun.light -> Map.light",
            "Map.light -> Render.lights", "Render.image -> View.image"]
}
)";

/// Words for xdotool, from one generator: the same seed, the same session.
class Monkey {
 public:
  Monkey(unsigned seed, ivec2 screen) : random_(seed), screen_(screen) {}

  std::vector<std::string> next() {
    switch (pick(10)) {
      case 0:
      case 1:
        return moveTo();
      case 2:
      case 3:
        return join(moveTo(), {"click", std::to_string(1 + pick(3))});
      case 4:
        return join(moveTo(), {"click", "--repeat", std::to_string(1 + pick(4)), "--delay", "5",
                               std::to_string(4 + pick(2))});
      case 5:
      case 6: {
        const std::string button = std::to_string(1 + pick(3));
        return join(join(join(moveTo(), {"mousedown", button}), moveTo()),
                    join(moveTo(), {"mouseup", button}));
      }
      case 7:
        return {"type", "--delay", "2", "--", kTexts[pick(kTexts.size())]};
      default:
        return {"key", modifiers() + kKeys[pick(kKeys.size())]};
    }
  }

 private:
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  static std::vector<std::string> join(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }
  std::vector<std::string> moveTo() {
    return {"mousemove", std::to_string(pick(std::size_t(screen_.x))),
            std::to_string(pick(std::size_t(screen_.y)))};
  }
  std::string modifiers() {
    std::string out;
    if (pick(4) == 0) out += "ctrl+";
    if (pick(4) == 0) out += "shift+";
    if (pick(8) == 0) out += "alt+";
    return out;
  }
  // Without q: Ctrl+Q after a discarded question is a clean end, not a finding.
  const std::vector<std::string> kKeys = {
      "a",     "b",    "c",      "d",     "e",      "f",      "g",     "h",           "i",
      "j",     "k",    "l",      "m",     "n",      "o",      "p",     "r",           "s",
      "t",     "u",    "v",      "w",     "x",      "y",      "z",     "0",           "1",
      "2",     "5",    "9",      "Tab",   "Return", "Escape", "space", "BackSpace",   "Delete",
      "Home",  "End",  "Prior",  "Next",  "Left",   "Right",  "Up",    "Down",        "F1",
      "F2",    "F3",   "F5",     "F6",    "F7",     "F8",     "F11",   "bracketleft", "bracketright",
      "minus", "plus", "period", "comma", "slash"};
  const std::vector<std::string> kTexts = {
      "sphere", "0.5", "1e9", "-3", "nan", "2*(3+", "\xc3\xa9\xe2\x82\xac", "a/b", "%s%n", "0"};
  std::mt19937 random_;
  ivec2 screen_;
};

/// KiB of resident memory.
long residentKiB(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
  return 0;
}

bool alive(pid_t process) { return ::kill(process, 0) == 0 && ::waitpid(process, nullptr, WNOHANG) == 0; }

TEST(RandomInput, TwoThousandEvents) {
  const char* chosen = std::getenv("PILEUS_RANDOM_SEED");
  const unsigned seed = chosen ? static_cast<unsigned>(std::strtoul(chosen, nullptr, 10)) : 1;
  const fs::path file = scratchFolder() / "scene.json";
  std::ofstream(file) << kGraph;
  UiSession ui({1100, 720}, {file.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  // What random keys name as a file is looked for beside the graph, and is not there.
  ui.expectLogged(file.parent_path().string());
  ui.finishPicture();
  Monkey monkey(seed, {1100, 720});
  std::vector<std::string> history;
  long early = 0;
  for (int done = 0; done < kEvents; done += kBatch) {
    std::vector<std::string> batch;
    for (int i = 0; i < kBatch; ++i) {
      const std::vector<std::string> event = monkey.next();
      batch.insert(batch.end(), event.begin(), event.end());
      std::string text;
      for (const std::string& word : event) text += word + " ";
      history.push_back(text);
    }
    ui.input(batch);
    if (!alive(ui.process())) {
      std::string last;
      for (std::size_t i = history.size() - std::min<std::size_t>(history.size(), 60); i < history.size();
           ++i)
        last += history[i] + "\n";
      std::string crash;
      std::error_code ec;
      for (fs::directory_iterator it(ui.folder() / "state" / "pileus" / "crashes", ec), end; !ec && it != end;
           it.increment(ec))
        crash += textOf(it->path());
      FAIL() << "seed " << seed << ": it ended after " << history.size() << " events, the last being\n"
             << last << "\n"
             << crash << "\n"
             << ui.log();
    }
    if (done == kEvents / 4) early = residentKiB(ui.process());
  }
  ui.screenshot("random-input");
  const long late = residentKiB(ui.process());
  EXPECT_LT(late, early + 400 * 1024) << "it grew from " << early << " KiB";
  RecordProperty("residentKiB", std::to_string(late));
  const std::string log = ui.log();
  // A refused edit is a hint; what these words name never is.
  for (const char* word : {"NaN", "not a number", "GL error", "assert", "terminate called", "out of memory"})
    EXPECT_EQ(log.find(word), std::string::npos) << word << " in\n" << log;

  // It still answers: everything that is open is closed, then a new document takes a node by search.
  for (int i = 0; i < 6; ++i) {
    ui.key("Escape");
    if (ui.shows("dialog/cancel")) ui.click("dialog/cancel");
  }
  ui.key("ctrl+n");
  // A new document has a sky and what belongs to it.
  const auto isNew = [](const json& t) {
    return t["document"]["nodes"].size() < 12 && t["document"]["nodes"].contains("Sky");
  };
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["rects"].contains("dialog/discard") || isNew(t); }));
  if (ui.shows("dialog/discard")) ui.click("dialog/discard");
  EXPECT_TRUE(ui.waitFor(isNew)) << ui.trace()["document"];
  if (!ui.shows("canvas")) ui.key("alt+2");  // it was hidden
  ASSERT_TRUE(ui.waitRect("canvas"));
  ui.move(ui.emptySpot());
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("search/field")) << ui.trace()["rects"];
  ui.type("sphere");
  ui.key("Return");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return t["document"]["nodes"].contains("Sphere"); }))
      << ui.trace()["document"];
}

/// The leaks of a report but those of libraries that were unloaded before it was made: the driver's. We
/// unload none.
std::string leaksOf(const std::string& report) {
  std::string ours;
  for (std::size_t at = report.find(" leak of "); at != std::string::npos;) {
    const std::size_t next = report.find(" leak of ", at + 1);
    const std::string leak = report.substr(at, next == std::string::npos ? next : next - at);
    const std::size_t caller = leak.find("#1 ");
    const std::string line =
        caller == std::string::npos ? "" : leak.substr(caller, leak.find('\n', caller) - caller);
    if (line.find("<unknown module>") == std::string::npos) ours += leak;
    at = next;
  }
  return ours;
}

// LeakSanitizer stands in for malloc and looks, when the program ends, for blocks nothing points at any more.
TEST(RandomInput, LosesNoMemory) {
  const fs::path sanitizer = "/usr/lib/x86_64-linux-gnu/liblsan.so.0";
  if (!fs::exists(sanitizer)) GTEST_SKIP() << "LeakSanitizer's library, a part of GCC, is not here";
  const fs::path folder = scratchFolder(), file = folder / "scene.json", report = folder / "leaks";
  std::ofstream(file) << kGraph;
  // What the driver's libraries keep for the life of the process.
  std::ofstream(folder / "others")
      << "leak:swrast_dri\nleak:libLLVM\nleak:libGLX\nleak:libGLdispatch\nleak:libX11\n";
  UiSession ui({1100, 720}, {file.string()}, json::object(), {},
               {"LD_PRELOAD=" + sanitizer.string(), "LSAN_OPTIONS=exitcode=0:log_path=" + report.string() +
                                                        ":suppressions=" + (folder / "others").string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  // What random keys name as a file is looked for beside the graph, and is not there.
  ui.expectLogged(file.parent_path().string());
  ui.finishPicture();
  Monkey monkey(3, {1100, 720});
  for (int done = 0; done < kEventsForLeaks; done += kBatch) {
    std::vector<std::string> batch;
    for (int i = 0; i < kBatch; ++i) {
      const std::vector<std::string> event = monkey.next();
      batch.insert(batch.end(), event.begin(), event.end());
    }
    ui.input(batch);
  }
  for (int i = 0; i < 6; ++i) {
    ui.key("Escape");
    if (ui.shows("dialog/cancel")) ui.click("dialog/cancel");
  }
  ui.key("ctrl+q");
  if (ui.waitRect("dialog/discard")) ui.click("dialog/discard");  // or it has ended
  const int code = ui.waitExit(150);                              // the look for leaks takes its time
  if (ui.log().find("LeakSanitizer has encountered a fatal error") != std::string::npos)
    GTEST_SKIP() << "LeakSanitizer may not trace here";
  EXPECT_EQ(code, 0) << ui.log();
  std::string found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with("leaks")) found += leaksOf(textOf(entry.path()));
  EXPECT_EQ(found, "");
}

}  // namespace
}  // namespace pileus::test
