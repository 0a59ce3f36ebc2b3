// The figure of a medium's phase function below its parameters.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

constexpr char kScene[] = R"({ "pileus": 2,
  "links": ["Box.volume -> Fog.volume", "Fog.volume -> Render.volumes", "Sun.light -> Render.lights",
            "Render.image -> View.image"],
  "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0] },
    "Fog": { "type": "volume.medium", "at": [220, 0] },
    "Sun": { "type": "light.sun", "at": [220, 200] },
    "Render": { "type": "render.volume", "at": [440, 0] },
    "View": { "type": "output.view", "at": [660, 0] } } })";

TEST(PhasePlot, FollowsTheParameters) {
  const std::filesystem::path file = scratchFolder() / "fog.json";
  std::ofstream(file) << kScene;
  UiSession ui({1380, 860}, {file.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.click("header/Fog");
  ASSERT_TRUE(ui.waitRect("phase plot"));
  const auto says = [&](const std::string& text) {
    return ui.waitFor(
        [&](const json& t) { return t["notes"].value("phase", "").find(text) != std::string::npos; }, 8);
  };
  EXPECT_TRUE(says("mean cosine 0.000, 0.0796 /sr ahead, 0.0796 /sr back"));
  ui.click(ui.center("param/anisotropy"), {"ctrl"});
  ui.type("0.5");
  ui.key("Return");
  EXPECT_TRUE(says("mean cosine 0.500"));
  ui.screenshot("phase-plot");
}

}  // namespace
}  // namespace pileus::test
