// Files that other programs wrote, and files made to break readers ($PILEUS_TEST_DATA/exr, env, exr_damaged).
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus::image {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesIn(const fs::path& folder, const std::string& extension = "") {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (extension.empty() || entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ExrFiles, ConformancePicturesRead) {
  PILEUS_NEEDS_DATA();
  for (const char* folder : {"exr", "env"}) {
    const auto files = filesIn(*test::dataFolder() / folder, ".exr");
    ASSERT_FALSE(files.empty()) << folder;
    for (const fs::path& path : files) {
      const auto read = readExr(path);
      ASSERT_TRUE(read) << read.error().message;
      ASSERT_FALSE(read->layers.empty());
      for (const Layer& layer : read->layers)
        EXPECT_EQ(layer.pixels.size(), static_cast<std::size_t>(read->size.x) *
                                           static_cast<std::size_t>(read->size.y) *
                                           static_cast<std::size_t>(layer.channels))
            << path;
    }
  }
}

TEST(ExrFiles, DataWindowsAreHonoured) {
  PILEUS_NEEDS_DATA();
  const auto inside = readExr(*test::dataFolder() / "exr" / "t04.exr");
  ASSERT_TRUE(inside) << inside.error().message;
  EXPECT_EQ(inside->size, ivec2(400, 300));
  EXPECT_NE(inside->displaySize, inside->size);
  const auto shifted = readExr(*test::dataFolder() / "exr" / "t08.exr");
  ASSERT_TRUE(shifted) << shifted.error().message;
  EXPECT_EQ(shifted->size, ivec2(400, 300));
  EXPECT_EQ(shifted->dataOrigin, ivec2(30, 40));
  EXPECT_EQ(shifted->displaySize, ivec2(501, 401));
}

TEST(ExrFiles, AllHalfValuesSurvive) {
  PILEUS_NEEDS_DATA();
  const auto read = readExr(*test::dataFolder() / "exr" / "AllHalfValues.exr");
  ASSERT_TRUE(read) << read.error().message;
  std::vector<float> values = read->layers[0].pixels;
  EXPECT_TRUE(std::any_of(values.begin(), values.end(), [](float v) { return std::isnan(v); }));
  EXPECT_TRUE(std::any_of(values.begin(), values.end(), [](float v) { return std::isinf(v); }));
  std::erase_if(values, [](float v) { return !std::isfinite(v); });
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  EXPECT_EQ(values.front(), -65504.0f);
  EXPECT_EQ(values.back(), 65504.0f);
  EXPECT_EQ(values.size(), 2u * 0x7c00u - 1u);  // every finite half once, the two zeros being equal
  // What was read with NaNs in it must not be writable as it is.
  EXPECT_FALSE(writeExr(test::scratchFolder() / "again.exr", *read));
}

TEST(ExrFiles, RoundTripOfARealPicture) {
  PILEUS_NEEDS_DATA();
  const auto read = readExr(*test::dataFolder() / "exr" / "t08.exr");
  ASSERT_TRUE(read) << read.error().message;
  const fs::path path = test::scratchFolder() / "again.exr";
  ASSERT_TRUE(writeExr(path, *read, {PixelType::Half, Compression::Piz}));
  const auto again = readExr(path);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->dataOrigin, read->dataOrigin);
  EXPECT_EQ(again->displaySize, read->displaySize);
  ASSERT_EQ(again->layers.size(), read->layers.size());
  for (std::size_t i = 0; i < read->layers.size(); ++i)
    EXPECT_EQ(again->layers[i].pixels, read->layers[i].pixels);
}

/// Each file in a process of its own, so that a crash or a hang is reported by the file's name.
TEST(ExrFiles, DamagedFilesEndInAnErrorOrAPicture) {
  PILEUS_NEEDS_DATA();
  const auto files = filesIn(*test::dataFolder() / "exr_damaged");
  ASSERT_GE(files.size(), 100u);
  int refused = 0;
  for (const fs::path& path : files) {
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    if (child == 0) {
      ::alarm(10);
      const auto read = readExr(path);
      const bool clear =
          read || (read.error().code == Code::Input && read.error().message.find(path.string()) == 0 &&
                   read.error().message.size() <= path.string().size() + 1200);
      ::_exit(!clear ? 1 : read ? 0 : 3);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_TRUE(WIFEXITED(status)) << path << " ended with signal " << WTERMSIG(status);
    EXPECT_NE(WEXITSTATUS(status), 1) << path << ": the message does not begin with the path, or is too long";
    EXPECT_LT(seconds, 2.0) << path;
    refused += WEXITSTATUS(status) == 3;
  }
  EXPECT_GE(refused, static_cast<int>(files.size()) - 5);
}

}  // namespace
}  // namespace pileus::image
