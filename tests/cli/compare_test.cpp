// `pileus compare` on the command line: what it prints and how it exits.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

namespace fs = std::filesystem;

fs::path writePicture(const std::string& name, ivec2 size, float value,
                      image::Compression compression = image::Compression::Zip) {
  image::Image picture;
  picture.size = size;
  image::Layer layer{"", 4, {}};
  for (int i = 0; i < size.x * size.y; ++i)
    layer.pixels.insert(layer.pixels.end(), {value, value, value, 1.0f});
  picture.layers = {layer};
  const fs::path path = test::scratchFolder() / name;
  const auto written = image::writeExr(path, picture, {image::PixelType::Float, compression});
  EXPECT_TRUE(written) << written.error().message;
  return path;
}

TEST(Compare, PrintsEveryMeasure) {
  const fs::path a = writePicture("a.exr", {8, 6}, 0.75f), b = writePicture("b.exr", {8, 6}, 0.5f);
  const auto result = test::pileus({"compare", a.string(), b.string()});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* expected :
       {"RMSE   0.25\n", "relMSE 0.240385\n", "max    0.25\n", "\nR ", "\nG ", "\nB ", "\nA "})
    EXPECT_NE(result.out.find(expected), std::string::npos) << expected << " in\n" << result.out;
}

TEST(Compare, TheBoundDecidesTheExitCode) {
  const fs::path a = writePicture("a.exr", {8, 6}, 0.75f), b = writePicture("b.exr", {8, 6}, 0.5f);
  EXPECT_EQ(test::pileus({"compare", a.string(), b.string(), "--max-relmse", "0.25"}).exitCode, 0);
  const auto exceeded = test::pileus({"compare", a.string(), b.string(), "--max-relmse", "0.24"});
  EXPECT_EQ(exceeded.exitCode, 6);
  EXPECT_NE(exceeded.out.find("relMSE 0.240385"), std::string::npos);
  EXPECT_EQ(exceeded.err, "pileus: relMSE 0.240385 exceeds the bound 0.24\n");
  EXPECT_EQ(test::pileus({"compare", a.string(), a.string(), "--max-relmse", "0"}).exitCode, 0);
}

TEST(Compare, ScaledRelMseStandsOnASecondLineAndHasABoundOfItsOwn) {
  const fs::path a = writePicture("a.exr", {8, 6}, 0.75f), b = writePicture("b.exr", {8, 6}, 0.5f),
                 low = writePicture("low.exr", {8, 6}, 0.375f),
                 high = writePicture("high.exr", {8, 6}, 0.625f);
  // 0.25^2 / (0.5^2 + 0.01 0.5^2)
  const auto alone = test::pileus({"compare", a.string(), b.string()});
  EXPECT_EQ(alone.exitCode, 0) << alone.err;
  EXPECT_NE(alone.out.find("\nscaled relMSE 0.247525 +- "), std::string::npos) << alone.out;
  EXPECT_NE(alone.out.find(" (" + b.string() + " is both halves), ratio of means 1.5, 48 pixels\n"),
            std::string::npos)
      << alone.out;
  // 0.375 0.125 / (the same)
  const auto halves = test::pileus({"compare", a.string(), low.string(), high.string()});
  EXPECT_EQ(halves.exitCode, 0) << halves.err;
  EXPECT_NE(halves.out.find("scaled relMSE 0.185644 +- "), std::string::npos) << halves.out;
  EXPECT_NE(halves.out.find(" (halves " + low.string() + " and " + high.string() + ")"), std::string::npos)
      << halves.out;
  const auto bounded = [&](const std::vector<std::string>& pictures, const char* bound) {
    std::vector<std::string> arguments{"compare"};
    arguments.insert(arguments.end(), pictures.begin(), pictures.end());
    arguments.insert(arguments.end(), {"--max-scaled-relmse", bound});
    return test::pileus(arguments);
  };
  EXPECT_EQ(bounded({a, b}, "0.25").exitCode, 0);
  const auto exceeded = bounded({a, b}, "0.24");
  EXPECT_EQ(exceeded.exitCode, 6);
  EXPECT_EQ(exceeded.err, "pileus: scaled relMSE 0.247525 exceeds the bound 0.24\n");
  EXPECT_EQ(bounded({a, low, high}, "0.186").exitCode, 0);
  EXPECT_EQ(bounded({a, low, high}, "0.185").exitCode, 6);
  EXPECT_EQ(bounded({a, a}, "0").exitCode, 0);
  const fs::path other = writePicture("other.exr", {8, 7}, 0.5f);
  const auto mismatched = bounded({a, b, other}, "1");
  EXPECT_EQ(mismatched.exitCode, 3);
  EXPECT_NE(mismatched.err.find(other.string()), std::string::npos) << mismatched.err;
}

TEST(Compare, ABoundHoldsForNoPictureWithNaNs) {
  // As other programs write them: in a file without compression the last value of the last row is its end.
  const fs::path path = writePicture("nan.exr", {8, 6}, 0.5f, image::Compression::None);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(-4, std::ios::end);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    file.write(reinterpret_cast<const char*>(&nan), sizeof nan);
  }
  const auto read = image::readExr(path);
  ASSERT_TRUE(read) << read.error().message;
  const auto bounded = test::pileus({"compare", path.string(), path.string(), "--max-relmse", "1"});
  EXPECT_EQ(bounded.exitCode, 6) << bounded.out << bounded.err;
  EXPECT_NE(bounded.err.find("1 pixel is not finite"), std::string::npos) << bounded.err;
  const auto unbounded = test::pileus({"compare", path.string(), path.string()});
  EXPECT_EQ(unbounded.exitCode, 0) << unbounded.err;
  EXPECT_NE(unbounded.out.find("1 pixel is not finite"), std::string::npos) << unbounded.out;
}

TEST(Compare, UnreadableOrMismatchedPicturesExitWithThree) {
  const fs::path a = writePicture("a.exr", {8, 6}, 0.5f), other = writePicture("other.exr", {8, 7}, 0.5f);
  const fs::path missing = a.parent_path() / "missing.exr", text = a.parent_path() / "text.exr";
  std::ofstream(text) << "not a picture";
  for (const fs::path& bad : {missing, text, other}) {
    for (const auto& [first, second] : {std::pair(a, bad), std::pair(bad, a)}) {
      const auto result = test::pileus({"compare", first.string(), second.string()});
      EXPECT_EQ(result.exitCode, 3) << bad;
      EXPECT_EQ(result.err.find("pileus: "), 0u) << result.err;
      EXPECT_NE(result.err.find(bad.string()), std::string::npos) << result.err;
      EXPECT_EQ(result.out, "");
    }
  }
}

}  // namespace
}  // namespace pileus
