// Compare mode and ray scope in a real window with real input.
#include "tests/ui/ui_session.h"

namespace pileus::test {
namespace {

/// Two boxes above each other under a Euclidean Fourier map that must be wrong.
constexpr char kGraph[] = R"({
  "pileus": 1,
  "settings": { "size": [480, 270], "frames": [1, 1], "fps": 24, "ocio": "", "workingSpace": "ACEScg" },
  "nodes": {
    "Top": { "type": "volume.box", "at": [0, 0], "params": { "center": [0, 1.2, 0], "size": [1.8, 0.5, 1.4], "density": 2 } },
    "Bottom": { "type": "volume.box", "at": [0, 120], "params": { "center": [0.2, -0.9, 0], "size": [1.6, 0.8, 1.2], "density": 2 } },
    "Sun": { "type": "light.sun", "at": [0, 260], "params": { "elevation": 80 } },
    "Camera": { "type": "camera.perspective", "at": [0, 380], "params": { "eye": [2.2, 0.8, 6] } },
    "Map": { "type": "shadow.extinction", "at": [260, 60], "params": { "resolution": 128, "basis": "fourier", "coefficients": 5 } },
    "Render": { "type": "render.volume", "at": [520, 0], "params": { "samples": 4 } },
    "View": { "type": "output.view", "at": [780, 0] }
  },
  "links": [
    "Top.volume -> Map.volumes",
    "Bottom.volume -> Map.volumes",
    "Sun.light -> Map.light",
    "Top.volume -> Render.volumes",
    "Bottom.volume -> Render.volumes",
    "Map.light -> Render.lights",
    "Camera.camera -> Render.camera",
    "Render.image -> View.image"
  ]
}
)";

std::filesystem::path graphFile() {
  const std::filesystem::path path = scratchFolder() / "boxes.json";
  std::ofstream(path) << kGraph;
  return path;
}

double number(const json& trace, const char* note) {
  return std::atof(trace["notes"].value(note, "-1").c_str());
}

bool truthComplete(const json& t) { return t["notes"].value("compare progress", "") == "Truth complete"; }

TEST(Compare, WipeHalvesAndErrorOfAWrongMap) {
  UiSession ui({1280, 720}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) {
        return t["complete"] == true && t["notes"].value("picture", "").ends_with("samples 4");
      },
      60))
      << ui.log();
  const std::string picture = ui.trace()["notes"]["picture"];

  ui.move(ui.center("viewport"));
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("compare/line"));
  ASSERT_TRUE(ui.waitFor(truthComplete, 120)) << ui.trace()["notes"];
  EXPECT_EQ(ui.trace()["notes"]["picture"], picture) << "comparing does not begin the picture anew";
  EXPECT_TRUE(ui.trace()["complete"]);
  ui.screenshot("20-wipe");
  const json done = ui.trace();
  EXPECT_GT(number(done, "compare shadow mean"), 0.01) << done["notes"];
  EXPECT_GT(number(done, "compare shadow max"), number(done, "compare shadow p95"));
  EXPECT_GT(number(done, "compare shadow p95"), number(done, "compare shadow mean"));
  EXPECT_GT(number(done, "compare relmse"), 1e-5);

  // The line follows the pointer, and the camera stays.
  const json camera = done["document"]["nodes"]["Camera"];
  const Point line = ui.center("compare/line");
  ui.drag(line, {line.x - 120, line.y + 10});
  EXPECT_NEAR(ui.center("compare/line").x, line.x - 120, 3);
  EXPECT_EQ(ui.trace()["document"]["nodes"]["Camera"], camera);
  EXPECT_TRUE(truthComplete(ui.trace())) << "moving the line costs no truth";

  ui.click("compare/of/shadow");
  ui.screenshot("21-wipe-shadow");
  ui.click("compare/side_by_side");
  ui.screenshot("22-halves");
  ui.click("compare/error");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("compare legend"); }));
  EXPECT_EQ(ui.trace()["notes"]["compare legend"], "+0.1");
  ui.screenshot("23-error-shadow");
  ui.click("compare/worst");
  ui.screenshot("24-error-worst");
  ui.click("compare/of/radiance");
  ui.screenshot("25-error-radiance");

  // A better map: the comparison starts over, and the error is smaller.
  ui.click("header/Map");
  ASSERT_TRUE(ui.waitRect("param/coefficients"));
  const Point field = ui.center("param/coefficients");
  ui.click(field, {"ctrl"});
  ui.type("15");
  ui.key("Return");
  const double before = number(done, "compare shadow mean");
  EXPECT_TRUE(ui.waitFor(
      [&](const json& t) {
        return truthComplete(t) && number(t, "compare shadow mean") < 0.7 * before &&
               number(t, "compare shadow mean") > 0;
      },
      120))
      << ui.trace()["notes"];

  ui.move(ui.center("viewport"));
  ui.key("Tab");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("compare/close"); }));
  ui.key("ctrl+q");
  ui.click("dialog/discard");
  EXPECT_EQ(ui.waitExit(), 0) << ui.log();
}

TEST(Compare, ADraftOfTheTruthComesWhileTheFinalPictureIsAtWork) {
  std::string text = kGraph;
  const std::string samples = R"("samples": 4)";
  text.replace(text.find(samples), samples.size(), R"("samples": 4096)");
  const std::filesystem::path path = scratchFolder() / "long.json";
  std::ofstream(path) << text;
  UiSession ui({1280, 720}, {path.string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].contains("picture"); }, 60)) << ui.log();
  ui.move(ui.center("viewport"));
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("compare/line"));
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        const std::string right = t["notes"].value("compare right", "");
        return right.starts_with("Ray marched") && !right.ends_with("soon");
      },
      20))
      << ui.trace()["notes"];
  EXPECT_EQ(ui.trace()["complete"], false) << "the picture itself is far from finished";
  // The small one goes on beside it, and says how long all of it takes.
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        const std::string progress = t["notes"].value("compare progress", "");
        return progress.starts_with("Truth 0.") && progress.ends_with(" left");
      },
      40))
      << ui.trace()["notes"];
  EXPECT_TRUE(ui.waitFor([](const json& t) { return number(t, "compare relmse") > 0; }, 60))
      << ui.trace()["notes"];
  ui.screenshot("27-truth-while-refining");
}

// The other truth: paths. It is chosen in the bar, begins anew, and finds the wrong map as well.
TEST(Compare, WithTheJudge) {
  UiSession ui({1280, 720}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 60)) << ui.log();
  ui.move(ui.center("viewport"));
  ui.key("Tab");
  ASSERT_TRUE(ui.waitRect("compare/against/judge"));
  ui.click("compare/against/judge");
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["notes"].value("compare right", "").starts_with("Judge"); }, 20))
      << ui.trace()["notes"];
  ASSERT_TRUE(ui.waitFor(truthComplete, 200)) << ui.trace()["notes"];
  EXPECT_EQ(ui.trace()["notes"]["compare right"], "Judge");
  EXPECT_GT(number(ui.trace(), "compare relmse"), 1e-5);
  EXPECT_GT(number(ui.trace(), "compare shadow mean"), 0.01);
  ui.screenshot("26-judge");
  // Shadows are always compared with marched ones.
  ui.click("compare/of/shadow");
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("compare right", "") == "Ray marched" &&
           !t["rects"].contains("compare/against/judge");
  }));
  ui.click("compare/of/radiance");
  ui.click("compare/against/marched");
  EXPECT_TRUE(ui.waitFor(
      [](const json& t) {
        return truthComplete(t) && t["notes"].value("compare right", "") == "Ray marched";
      },
      120))
      << ui.trace()["notes"];
  ui.key("ctrl+q");
  EXPECT_EQ(ui.waitExit(), 0) << ui.log();
}

TEST(RayScope, PicksExplainsAndMutes) {
  UiSession ui({1440, 900}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 60)) << ui.log();
  ui.move(ui.center("viewport"));
  ui.key("s");
  ASSERT_TRUE(ui.waitRect("scope"));
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["complete"] == true; }, 60));
  ui.screenshot("30-scope-empty");

  // A click picks and leaves the camera alone; a drag still orbits.
  const json camera = ui.trace()["document"]["nodes"]["Camera"];
  const json view = ui.trace()["rects"]["viewport"];
  const Point lower{0.5 * (view[0].get<double>() + view[2].get<double>()),
                    view[1].get<double>() + 0.66 * (view[3].get<double>() - view[1].get<double>())};
  ui.click(lower);
  ASSERT_TRUE(ui.waitRect("scope/transmittance")) << ui.trace()["notes"];
  EXPECT_EQ(ui.trace()["document"]["nodes"]["Camera"], camera);
  const Point mark = ui.center("scope/mark");
  EXPECT_NEAR(mark.x, lower.x, 2);
  EXPECT_NEAR(mark.y, lower.y, 2);
  ui.screenshot("31-scope");
  const std::string flags = ui.trace()["notes"].value("scope flags", "");
  EXPECT_NE(flags.find("Transmittance rises by"), std::string::npos) << flags;
  EXPECT_NE(flags.find("Extinction is negative on"), std::string::npos) << flags;

  ui.move(ui.center("scope/transmittance"));
  EXPECT_TRUE(ui.waitFor([](const json& t) {
    return t["notes"].value("scope hover", "").find("by the map") != std::string::npos;
  }));
  ui.screenshot("32-scope-hover");
  ui.click("scope/coefficient/1");
  ASSERT_TRUE(ui.waitRect("scope/unmute"));
  ui.screenshot("33-scope-muted");
  ui.click("scope/unmute");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("scope/unmute"); }));

  ui.drag(lower, {lower.x + 60, lower.y});
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"]["Camera"] != camera; }));
  ui.click("scope/close");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("scope"); }));
}

TEST(Lab, TunesAndWritesIntoTheNodesAndComparesAll) {
  UiSession ui({1440, 900}, {graphFile().string()});
  ASSERT_TRUE(ui.running()) << ui.log();
  ui.move(ui.center("viewport"));
  ui.key("F7");
  ASSERT_TRUE(ui.waitRect("tune/run"));
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) {
        return t["complete"] == true &&
               t["notes"].value("tune note", "").starts_with("Searches the parameters of Map");
      },
      60))
      << ui.trace()["notes"];
  ui.screenshot("40-tune-before");
  ui.click("tune/run");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].value("tune head", "") == "Best"; }, 200))
      << ui.trace()["notes"];
  ui.screenshot("41-tune");

  // Any dot can be chosen; writing is one undo step.
  const json trace = ui.trace();
  const json before = trace["document"]["nodes"]["Map"];
  const std::string best = trace["notes"]["tune what"];
  ui.click("tune/dot/1");
  ASSERT_TRUE(ui.waitFor([](const json& t) { return t["notes"].value("tune head", "") == "Chosen"; }))
      << ui.trace()["notes"];
  ui.screenshot("42-tune-chosen");
  ui.click("tune/best");
  ASSERT_TRUE(ui.waitFor([&](const json& t) { return t["notes"].value("tune what", "") == best; }));
  ui.click("tune/write");
  ASSERT_TRUE(ui.waitFor([&](const json& t) {
    return t["document"]["nodes"]["Map"] != before && t["undo"] == "Tune shadows";
  })) << ui.trace()["message"];
  ui.move(ui.center("viewport"));
  ui.key("ctrl+z");
  EXPECT_TRUE(ui.waitFor([&](const json& t) { return t["document"]["nodes"]["Map"] == before; }));

  // The shoot-out fills its table while it runs, and can be stopped.
  ui.key("F6");
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) { return t["complete"] == true && t["rects"].contains("shootout/run"); }, 60));
  ui.click("shootout/run");
  ASSERT_TRUE(ui.waitFor(
      [](const json& t) {
        return t["notes"].value("shootout rows", "").find("Fourier opacity 11") != std::string::npos;
      },
      200))
      << ui.trace()["notes"];
  ui.click("shootout/cancel");
  ASSERT_TRUE(ui.waitRect("shootout/run"));
  const auto rows = [&] { return ui.trace()["notes"].value("shootout rows", ""); };
  // One more may have been finished before it stopped.
  EXPECT_TRUE(rows().starts_with("Ray march\n") &&
              rows().find("Fourier opacity 11\nFourier opacity 7\nFourier opacity 3") != std::string::npos)
      << "least mean error first: " << rows();
  ui.click("shootout/column/2");
  EXPECT_TRUE(ui.waitFor([&](const json&) { return rows().starts_with("Ray march\nFourier opacity 3\n"); }))
      << "and the largest: " << rows();
  ui.screenshot("43-shootout");
  const json row = ui.trace()["rects"]["shootout/row/Fourier opacity 3"];
  ui.move({row[0].get<double>() + 40, row[1].get<double>() + 12});
  ui.screenshot("44-shootout-hover");
  ui.key("F6");
  EXPECT_TRUE(ui.waitFor([](const json& t) { return !t["rects"].contains("lab"); }));
}

}  // namespace
}  // namespace pileus::test
