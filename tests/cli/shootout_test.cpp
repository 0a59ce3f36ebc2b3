// `pileus shootout`: the table, the contact sheet, and how it refuses.
#include <stb/stb_image.h>

#include <cmath>
#include <map>
#include <sstream>

#include "renderer/base/file.h"
#include "tests/cli/shadow_graphs.h"

namespace pileus {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

using Row = std::map<std::string, std::string>;

TEST(Shootout, MeasuresEveryRepresentation) {
  const fs::path folder = test::scratchFolder(), out = folder / "out";
  const auto r = test::pileus({"shootout", test::writeIntervalGraph(folder / "gap.json"), "-o", out, "--size",
                               "64x36", "--samples", "1", "--resolution", "192", "--points", "4000"},
                              280);
  ASSERT_EQ(r.exitCode, 0) << r.out << r.err;
  std::printf("%s", r.out.c_str());

  std::istringstream csv(*readFile(out / "shootout.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line,
            "group,representation,light,resolution,bytes_per_texel,bytes,build_ms,ns_per_lookup,mean_abs_dt,"
            "p95_abs_dt,max_abs_dt,mean_dt,picture_relmse");
  const std::vector<std::string> names = fields(line);
  std::vector<Row> rows;
  while (std::getline(csv, line)) {
    const std::vector<std::string> values = fields(line);
    ASSERT_EQ(values.size(), names.size()) << line;
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
  }
  ASSERT_EQ(rows.size(), 1 + 2 * 16u);
  EXPECT_EQ(rows[0]["group"], "truth");
  EXPECT_LT(std::stod(rows[0]["max_abs_dt"]), 1e-3) << "the march is the truth";
  std::map<std::string, std::map<std::string, Row>> by;
  for (Row& row : rows) {
    by[row["group"]][row["representation"]] = row;
    for (const char* value : {"ns_per_lookup", "max_abs_dt"})
      EXPECT_GE(std::stod(row[value]), 0) << row["representation"];
    EXPECT_LE(std::stod(row["mean_abs_dt"]), std::stod(row["max_abs_dt"]) + 1e-9);
    EXPECT_LE(std::abs(std::stod(row["mean_dt"])), std::stod(row["mean_abs_dt"]) + 1e-9);
    if (row["group"] == "truth") continue;
    EXPECT_GT(std::stod(row["build_ms"]), 0) << row["representation"];
    EXPECT_NEAR(std::stod(row["bytes"]),
                std::stod(row["bytes_per_texel"]) * std::pow(std::stod(row["resolution"]), 2),
                1e-3 * std::stod(row["bytes"]));
    if (row["group"] == "equal memory") {
      EXPECT_NEAR(std::stod(row["bytes"]), 32.0 * 192 * 192, 0.01 * 32 * 192 * 192) << row["representation"];
    } else {
      EXPECT_EQ(row["resolution"], "192");
    }
  }
  ASSERT_EQ(by["defaults"].size(), 16u);
  ASSERT_EQ(by["equal memory"].size(), 16u);
  Row &ours = by["equal memory"]["Interval 4 + cosine 8"],
      &fourier = by["equal memory"]["Fourier opacity 15"];
  EXPECT_LT(std::stod(ours["mean_abs_dt"]), 0.25 * std::stod(fourier["mean_abs_dt"]));
  EXPECT_LT(std::stod(ours["picture_relmse"]), 0.25 * std::stod(fourier["picture_relmse"]));
  EXPECT_LT(std::stod(by["defaults"]["Deep shadow map"]["p95_abs_dt"]), 0.02);

  int width = 0, height = 0, channels = 0;
  stbi_uc* pixels = stbi_load((out / "contact-sheet.png").c_str(), &width, &height, &channels, 0);
  ASSERT_TRUE(pixels) << "no PNG";
  EXPECT_EQ(width, 2 * 40 + 6 * (300 + 20) + 5 * 20);
  EXPECT_EQ(height, 118 + 40 + 2 * (62 + 3 * (2 * 36 + 84 + 24 + 20)));
  int bright = 0;
  for (int i = 0; i < width * height * channels; ++i) bright += pixels[i] > 200;
  EXPECT_GT(bright, 1000) << "no text";
  stbi_image_free(pixels);

  const auto again = test::pileus({"shootout", folder / "gap.json", "-o", out});
  EXPECT_EQ(again.exitCode, 3);
  EXPECT_NE(again.err.find("--overwrite"), std::string::npos) << again.err;
}

TEST(Shootout, RefusesFilesWithoutLightsOrVolumes) {
  const fs::path folder = test::scratchFolder();
  const auto expect = [&](const fs::path& file, const std::vector<std::string>& words) {
    const auto r = test::pileus({"shootout", file, "-o", folder / "out"});
    EXPECT_EQ(r.exitCode, 3) << r.err;
    for (const std::string& w : words)
      EXPECT_NE(r.err.find(w), std::string::npos) << "'" << w << "' is not in: " << r.err;
    EXPECT_FALSE(fs::exists(folder / "out"));
  };
  const auto write = [&](const std::string& name, const std::string& nodes, const std::string& links) {
    std::ofstream(folder / name) << R"({ "pileus": 1, "nodes": { )" << nodes << R"( }, "links": [ )" << links
                                 << " ] }";
    return folder / name;
  };
  const std::string sun = R"("Sun": { "type": "light.sun", "at": [0, 0], "params": {} })",
                    box = R"("Box": { "type": "volume.box", "at": [0, 0], "params": {} })",
                    render = R"("Render": { "type": "render.volume", "at": [0, 0], "params": {} })";
  expect(folder / "missing.json", {"missing.json"});
  expect(write("no-render.json", sun + "," + box, ""), {"no-render.json", "render.volume"});
  expect(write("no-lights.json", render + "," + box, R"("Box.volume -> Render.volumes")"),
         {"no-lights.json", "light", "Render"});
  expect(write("no-volumes.json", render + "," + sun, R"("Sun.light -> Render.lights")"),
         {"no-volumes.json", "volume", "Render"});
  EXPECT_EQ(test::pileus({"shootout"}).exitCode, 2);
  EXPECT_EQ(test::pileus({"shootout", folder / "no-volumes.json", "--size", "0x9"}).exitCode, 2);
  EXPECT_EQ(test::pileus({"shootout", test::writeIntervalGraph(folder / "gap.json"), "--render", "Nobody"})
                .exitCode,
            2);
}

}  // namespace
}  // namespace pileus
