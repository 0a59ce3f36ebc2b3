// A long day in one window: what is changed over and over takes no more memory in the end than at its noon.
#include <cstdlib>

#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

constexpr int kNoon = 50, kEvening = 75;

/// A map of several MiB, so that what is kept fills its room before noon.
fs::path graphFile(const std::string& name, int density) {
  const fs::path file = scratchFolder() / name;
  std::ofstream(file) << R"({ "pileus": 2, "settings": { "size": [96, 54] }, "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": )"
                      << density << R"( } },
    "Cloud": { "type": "volume.cloud", "at": [0, 150], "params": { "resolution": 48, "size": [2, 1, 2] } },
    "Sun": { "type": "light.sun", "at": [0, 300] },
    "Map": { "type": "shadow.extinction", "at": [300, 150], "params": { "storage": "float" } },
    "Render": { "type": "render.volume", "at": [560, 0], "params": { "samples": 1 } },
    "View": { "type": "output.view", "at": [820, 0] } },
  "links": [ "Box.volume -> Map.volumes", "Sun.light -> Map.light",
             "Box.volume -> Render.volumes", "Cloud.volume -> Render.volumes", "Map.light -> Render.lights",
             "Render.image -> View.image" ] })";
  return file;
}

double residentMib(const UiSession& ui) {
  const std::string text = textOf("/proc/" + std::to_string(ui.process()) + "/status");
  const std::size_t at = text.find("VmRSS:");
  return at == std::string::npos ? 0 : std::atof(text.c_str() + at + 6) / 1024;
}

/// Does `change` until the evening, and compares that with noon.
void expectNoGrowth(const UiSession& ui, const char* what, const std::function<void(int)>& change) {
  double noon = 0, kept = 0;
  for (int i = 1; i <= kEvening; ++i) {
    change(i);
    ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true && t["error"] == ""; }, 30)) << i;
    if (i == kNoon) noon = residentMib(ui), kept = ui.trace()["keptBytes"].get<double>() / 1048576;
  }
  const double evening = residentMib(ui), keptThen = ui.trace()["keptBytes"].get<double>() / 1048576;
  std::printf("%s: %.0f MiB at noon, %.0f in the evening; kept %.0f, %.0f\n", what, noon, evening, kept,
              keptThen);
  EXPECT_LE(evening, 1.05 * noon) << what;
  EXPECT_LE(keptThen, std::max(1.05 * kept, 512.0)) << what;
}

void typeInto(const UiSession& ui, const std::string& rect, const std::string& text) {
  ui.click(ui.center(rect), {"ctrl"});
  ui.type(text);
  ui.key("Return");
}

TEST(LongDay, OfMovingSuns) {
  UiSession ui({1280, 800}, {graphFile("day.json", 2).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ui.click("header/Sun");
  ASSERT_TRUE(ui.waitRect("param/elevation"));
  expectNoGrowth(ui, "suns", [&](int i) { typeInto(ui, "param/elevation", std::to_string(10 + 0.5 * i)); });
}

TEST(LongDay, OfOtherSeeds) {
  UiSession ui({1280, 800}, {graphFile("day.json", 2).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  ui.click("header/Cloud");
  ASSERT_TRUE(ui.waitRect("param/seed"));
  expectNoGrowth(ui, "seeds", [&](int i) { typeInto(ui, "param/seed", std::to_string(i)); });
}

TEST(LongDay, OfManyDocuments) {
  UiSession ui({1280, 800}, {graphFile("day.json", 2).string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.finishPicture();
  expectNoGrowth(ui, "documents", [&](int i) {
    const fs::path file = graphFile("day" + std::to_string(i % 9) + ".json", 1 + i % 9);
    ui.key("ctrl+o");
    ASSERT_TRUE(ui.waitRect("browser/name"));
    ui.type(file.string());
    ui.key("Return");
    ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["path"] == file.string(); })) << i;
  });
}

}  // namespace
}  // namespace pileus::test
