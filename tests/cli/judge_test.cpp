// `pileus judge` on the command line: what it prints, what it writes and how it exits.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

namespace fs = std::filesystem;

/// A lit box whose shadow is marched; `render` is the type of the node and its parameters, `more` further
/// nodes and links, each beginning with a comma.
fs::path writeGraph(const fs::path& path, const std::string& render, const std::string& moreNodes = "",
                    const std::string& moreLinks = "") {
  std::ofstream(path, std::ios::binary) << R"({ "pileus": 2, "settings": { "size": [48, 27] }, "nodes": {
    "Box": { "type": "volume.box", "at": [0, 0], "params": { "density": 2 } },
    "Sun": { "type": "light.sun", "at": [0, 0], "params": {} },
    "Shadow": { "type": "shadow.ray_march", "at": [0, 0], "params": {} },
    "Render": { "at": [0, 0], )" << render
                                        << R"( },
    "View": { "type": "output.view", "at": [0, 0], "params": {} })"
                                        << moreNodes << R"( },
  "links": [ "Box.volume -> Shadow.volumes", "Sun.light -> Shadow.light", "Shadow.light -> Render.lights",
             "Box.volume -> Render.volumes", "Render.image -> View.image")"
                                        << moreLinks << " ] }";
  return path;
}
constexpr char kVolume[] = R"("type": "render.volume", "params": { "samples": 16, "step_scale": 0.5 })";

TEST(Judge, PrintsItsFiguresAndTheBoundDecidesTheExitCode) {
  const fs::path folder = test::scratchFolder(), file = writeGraph(folder / "box.json", kVolume);
  const auto r = test::pileus({"judge", file, "--samples", "32"});
  ASSERT_EQ(r.exitCode, 0) << r.out << r.err;
  for (const char* words :
       {"View (48 x 27) against single scattering", "\nscaled relMSE   ", "\nratio of means  ",
        "\njudge           32 samples, standard error", "\norder 1 "})
    EXPECT_NE(r.out.find(words), std::string::npos) << words << " in\n" << r.out;
  EXPECT_EQ(r.out.find("order 2"), std::string::npos) << r.out;
  EXPECT_NE(r.err.find("Tracing the judge"), std::string::npos) << r.err;

  EXPECT_EQ(test::pileus({"judge", file, "--samples", "32", "--max-relmse", "0.5"}).exitCode, 0);
  // Everything but single scattering is missing.
  const auto all = test::pileus(
      {"judge", file, "--samples", "32", "--size", "32x18", "--bounces", "-1", "--max-relmse", "0.001"});
  EXPECT_EQ(all.exitCode, 6) << all.out << all.err;
  EXPECT_NE(all.err.find("exceeds the bound 0.001"), std::string::npos) << all.err;
  for (const char* words :
       {"(32 x 18) against all orders", "order 1 ", "order 2 ", "order 3-4 ", "order 5-8 ", "beyond "})
    EXPECT_NE(all.out.find(words), std::string::npos) << words << " in\n" << all.out;
  // A bound that the judge is too noisy for is not held.
  const auto noisy = test::pileus({"judge", file, "--samples", "2", "--max-relmse", "1e-7"});
  EXPECT_EQ(noisy.exitCode, 6) << noisy.out << noisy.err;
}

TEST(Judge, WritesJsonAndLayers) {
  const fs::path folder = test::scratchFolder(), out = folder / "box.exr",
                 file = writeGraph(folder / "box.json", kVolume);
  const std::vector<std::string> arguments{"judge",  file,    "--bounces", "2",  "--samples", "32",
                                           "--size", "32x18", "--json",    "-o", out};
  const auto r = test::pileus(arguments);
  ASSERT_EQ(r.exitCode, 0) << r.out << r.err;
  const nlohmann::json j = nlohmann::json::parse(r.out);
  EXPECT_EQ(j["output"], "View");
  EXPECT_EQ(j["size"], nlohmann::json::array({32, 18}));
  EXPECT_EQ(j["bounces"], 2);
  EXPECT_EQ(j["judge"]["samples"], 32);
  EXPECT_EQ(j["judge"]["endedByTime"], false);
  EXPECT_GT(j["judge"]["noise"].get<double>(), 0);
  EXPECT_GT(j["scaledRelMse"]["value"].get<double>(), 0);
  EXPECT_GT(j["scaledRelMse"]["standardError"].get<double>(), 0);
  EXPECT_GT(j["scaledRelMse"]["pixels"].get<int>(), 50);
  const double ratio = j["ratioOfMeans"]["value"];
  EXPECT_NEAR(ratio, j["picture"]["mean"].get<double>() / j["judge"]["mean"].get<double>(), 1e-4);
  EXPECT_LT(ratio, 0.95) << "orders 2 and 3 are missing";
  double sum = 0;
  std::vector<std::string> names;
  for (const auto& order : j["orders"]) {
    sum += order["mean"].get<double>();
    names.push_back(order["layer"]);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"order1", "order2", "order3_4"}));
  EXPECT_NEAR(sum, j["judge"]["mean"].get<double>(), 1e-4 * sum);

  const auto picture = image::readExr(out);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->size, ivec2(32, 18));
  EXPECT_EQ(picture->layers.size(), 7u);
  for (const char* name : {"", "judge", "difference", "variance", "order1", "order2", "order3_4"}) {
    ASSERT_TRUE(picture->layer(name)) << name;
    EXPECT_EQ(picture->layer(name)->channels, std::string(name) == "difference" ? 3 : 4) << name;
  }
  const std::size_t centre = 9 * 32 + 16;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto at = [&](const char* name) { return picture->layer(name)->pixels[4 * centre + c]; };
    EXPECT_NEAR(picture->layer("difference")->pixels[3 * centre + c], at("") - at("judge"), 1e-6);
    EXPECT_NEAR(at("order1") + at("order2") + at("order3_4"), at("judge"), 1e-4 * double(at("judge")));
    EXPECT_GT(at("variance"), 0);
  }
  EXPECT_EQ(picture->metadata.at("judge:bounces"), "2");
  EXPECT_TRUE(picture->metadata.count("judge:scaledRelMse"));

  const auto again = test::pileus(arguments);
  EXPECT_EQ(again.exitCode, 3) << again.err;
  EXPECT_NE(again.err.find("--overwrite"), std::string::npos) << again.err;
}

TEST(Judge, APathTracedPictureIsJudgedByItsOwnBounces) {
  const fs::path folder = test::scratchFolder();
  const fs::path file = writeGraph(
      folder / "traced.json", R"("type": "render.path_trace", "params": { "samples": 64, "bounces": 1 })");
  const auto r = test::pileus({"judge", file, "--samples", "64", "--size", "32x18", "--json"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const nlohmann::json j = nlohmann::json::parse(r.out);
  EXPECT_EQ(j["bounces"], 1);
  EXPECT_EQ(j["orders"].size(), 2u);
  EXPECT_NEAR(j["ratioOfMeans"]["value"].get<double>(), 1, 0.05);
  EXPECT_GT(j["scaledRelMse"]["value"].get<double>(), 0) << "its noise is not the judge's";
}

TEST(Judge, TimeEndsIt) {
  const fs::path folder = test::scratchFolder(), file = writeGraph(folder / "box.json", kVolume);
  const auto r =
      test::pileus({"judge", file, "--samples", "1000000", "--seconds", "2", "--size", "16x9", "--json"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const nlohmann::json j = nlohmann::json::parse(r.out);
  EXPECT_EQ(j["judge"]["endedByTime"], true);
  EXPECT_LT(j["judge"]["samples"].get<int>(), 1000000);
}

TEST(Judge, RefusesWhatItCannotJudge) {
  const fs::path folder = test::scratchFolder(), file = writeGraph(folder / "box.json", kVolume);
  const auto expect = [&](const std::vector<std::string>& arguments, int code, const std::string& words) {
    std::vector<std::string> all{"judge"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto r = test::pileus(all);
    EXPECT_EQ(r.exitCode, code) << r.out << r.err;
    EXPECT_NE(r.err.find(words), std::string::npos) << "'" << words << "' is not in: " << r.err;
    EXPECT_EQ(r.out, "");
  };
  expect({}, 2, "file");
  expect({file, "--size", "0x9"}, 2, "--size");
  expect({file, "--bounces", "-2"}, 2, "--bounces");
  expect({file, "--samples", "1"}, 2, "--samples");
  expect({file, "--max-relmse", "-1"}, 2, "--max-relmse");
  expect({file, "--output", "Nobody"}, 2, "Nobody");
  expect({file, "-o", folder / "a.png"}, 2, ".exr");
  expect({file, "-o", folder / "none" / "a.exr"}, 3, "none");
  expect({folder / "missing.json"}, 3, "missing.json");
  expect({writeGraph(folder / "two.json", kVolume,
                     R"(, "Other": { "type": "output.view", "at": [0, 0], "params": {} })",
                     R"(, "Render.image -> Other.image")")},
         2, "--output");
  expect(
      {writeGraph(
           folder / "empty.json", R"("type": "render.volume", "params": { "samples": 1 })",
           R"(, "Eye": { "type": "camera.perspective", "at": [0, 0], "params": { "eye": [0, 0, 9], "target": [0, 0, 99] } })",
           R"(, "Eye.camera -> Render.camera")"),
       "--samples", "2"},
      3, "no pixel");
}

}  // namespace
}  // namespace pileus
