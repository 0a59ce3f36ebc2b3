// `pileus check` and `pileus nodes`: faults by node and key, exit codes, where things are printed.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "nodes/file/docs_export.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

class Check : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    const auto path = folder_ / name;
    std::ofstream(path) << text;
    return path.string();
  }
  static std::string graph(const std::string& nodes, const std::string& links) {
    return R"({"pileus": 1, "nodes": {)" + nodes + R"(}, "links": [)" + links + "]}";
  }
  std::filesystem::path folder_ = test::scratchFolder();
};

const std::string kScene =
    R"("Box": {"type": "volume.box"}, "Sun": {"type": "light.sun"}, "Render": {"type": "render.volume"},
                              "View": {"type": "output.view"})";
const std::string kLinks =
    R"("Box.volume -> Render.volumes", "Sun.light -> Render.lights", "Render.image -> View.image")";

TEST_F(Check, AGoodFileIsOk) {
  const std::string file = write("good.json", graph(kScene, kLinks));
  const auto run = test::pileus({"check", file});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.out, file + ": ok\n");
  EXPECT_EQ(run.err, "");
}

TEST_F(Check, WarningsAloneExitZero) {
  const std::string file =
      write("odd.json", graph(kScene + R"(, "X": {"type": "volume.from_mars"})", kLinks));
  const auto run = test::pileus({"check", file});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(run.err, file + ": warning: X: unknown node type 'volume.from_mars'; kept as it is\n");
  EXPECT_EQ(run.out, file + ": 0 errors, 1 warning\n");
}

TEST_F(Check, EveryFaultOfEveryFileIsPrinted) {
  const std::string bad =
      write("bad.json", graph(kScene + R"(, "V": {"type": "volume.vdb_file", "params": {"file": "none.vdb"}},
      "S": {"type": "light.sun", "params": {"elevation": 120, "angle": "wide"}}, "A": {"type": "volume.merge"}, "B": {"type": "volume.merge"})",
                              kLinks + R"(, "A.volume -> B.volumes", "B.volume -> A.volumes")"));
  const std::string broken = write("broken.json", "{\n  \"pileus\": 1,,\n}");
  const std::string absent = (folder_ / "absent.json").string();
  const auto run = test::pileus({"check", bad, broken, absent});
  EXPECT_EQ(run.exitCode, 3);
  for (const std::string& line :
       {bad + ": error: S.elevation: 120 is outside -90..90",
        bad + ": error: S.angle: 'wide' is not a number", bad + ": error: links: cycle: A -> B -> A",
        bad + ": error: V.file: " + (folder_ / "none.vdb").string() + ": there is no such file",
        broken + ": error: line 2, column 15: not JSON", absent + ": error: "})
    EXPECT_NE(run.err.find(line), std::string::npos) << line << "\nin\n" << run.err;
}

TEST_F(Check, EveryFileOfAKeyedParameterIsLookedFor) {
  write("a.vdb", "not looked into");
  const std::string file = write(
      "keyed.json",
      graph(
          kScene +
              R"(, "V": {"type": "volume.vdb_file", "params": {"file": {"keys": [[1, "a.vdb"], [7, "b.vdb"]]}}})",
          kLinks));
  const auto run = test::pileus({"check", file});
  EXPECT_EQ(run.exitCode, 3) << run.err;
  EXPECT_NE(run.err.find("error: V.file: " + (folder_ / "b.vdb").string() +
                         ": there is no such file (key of frame 7)"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(run.err.find("a.vdb: "), std::string::npos) << run.err;
}

TEST_F(Check, WhatARenderNeedsIsAnErrorAndTheRestAWarning) {
  const std::string loose = R"(, "Loose": {"type": "volume.transform"}, "V": {"type": "volume.vdb_file"})";
  const auto dangling = test::pileus({"check", write("a.json", graph(kScene + loose, kLinks))});
  EXPECT_EQ(dangling.exitCode, 0) << dangling.err;
  EXPECT_NE(dangling.err.find("warning: Loose.volume: nothing is linked"), std::string::npos) << dangling.err;
  const auto needed = test::pileus(
      {"check", write("b.json", graph(kScene + loose, kLinks + R"(, "V.volume -> Render.volumes")"))});
  EXPECT_EQ(needed.exitCode, 3);
  EXPECT_NE(needed.err.find("error: V.file: no file chosen"), std::string::npos) << needed.err;
}

TEST(Nodes, AreListedAsTextMarkdownAndJson) {
  const auto text = test::pileus({"nodes"}), markdown = test::pileus({"nodes", "--markdown"}),
             json = test::pileus({"nodes", "--json"});
  EXPECT_EQ(text.exitCode + markdown.exitCode + json.exitCode, 0);
  EXPECT_EQ(text.out, nodes::nodesText());
  EXPECT_EQ(markdown.out, nodes::nodesMarkdown());
  const auto parsed = nlohmann::json::parse(json.out);
  EXPECT_EQ(parsed["nodes"][0]["id"], "volume.vdb_file");
  EXPECT_EQ(parsed["nodes"][0]["params"][0]["kinds"], "vdb");
}

}  // namespace
}  // namespace pileus
