// Environments through the import child: what arrives is what the file holds, and no file harms the parent.
#include "renderer/image/environment_import.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "tests/support/support.h"

namespace pileus::image {
namespace {

namespace fs = std::filesystem;

fs::path written(ivec2 size) {
  Image image;
  image.size = size;
  image.layers = {{"", 3, std::vector<float>(std::size_t(size.x * size.y * 3), 0.5f)}};
  image.layers[0].pixels[4] = -1;
  const fs::path path = test::scratchFolder() / "map.exr";
  EXPECT_TRUE(writeExr(path, image, {PixelType::Float, Compression::Zip}));
  return path;
}

TEST(EnvironmentImport, GivesWhatTheFileHolds) {
  JobControl control;
  for (const ivec2 size : {ivec2(1, 2), ivec2(64, 64), ivec2(1024, 512)}) {
    const fs::path path = written(size);
    const auto here = decodeEnvironment(path), there = importEnvironment(path, control);
    ASSERT_TRUE(here && there) << there.error().message;
    EXPECT_EQ(there->map, here->map);
    EXPECT_EQ(there->warnings, here->warnings);
    ASSERT_TRUE(there->primaries);
    EXPECT_EQ(there->primaries->red, here->primaries->red);
    EXPECT_EQ(there->primaries->white, here->primaries->white);
  }
}

TEST(EnvironmentImport, ErrorsNameTheFileOnce) {
  JobControl control;
  const fs::path path = test::scratchFolder() / "none.hdr";
  const auto read = importEnvironment(path, control);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, Code::Input);
  EXPECT_EQ(read.error().message, path.string() + ": there is no such file");
}

TEST(EnvironmentImport, EndsAtItsLimitsAndWhenCancelled) {
  JobControl control;
  const fs::path path = written({4000, 2000});
  ImportLimits limits;
#if !defined(__SANITIZE_ADDRESS__)
  limits.memoryBytes = std::uint64_t(96) << 20;
  const auto small = importEnvironment(path, control, limits);
  ASSERT_FALSE(small);
  EXPECT_EQ(small.error().code, Code::Input);
#endif
  limits = {};
  limits.wallSeconds = 0;
  const auto slow = importEnvironment(path, control, limits);
  ASSERT_FALSE(slow);
  EXPECT_NE(slow.error().message.find("took longer"), std::string::npos) << slow.error().message;
  control.cancel();
  const auto cancelled = importEnvironment(path, control);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().code, Code::Cancelled);
}

TEST(EnvironmentImport, DamagedFilesEndInAnErrorOrAMap) {
  PILEUS_NEEDS_DATA();
  JobControl control;
  int files = 0, refused = 0;
  for (const char* folder : {"exr_damaged", "exr"})
    for (const auto& entry : fs::directory_iterator(*test::dataFolder() / folder)) {
      SCOPED_TRACE(entry.path());
      const auto start = std::chrono::steady_clock::now();
      const auto read = importEnvironment(entry.path(), control);
      EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 3.0);
      ++files;
      if (read) {
        for (const vec3& texel : read->map.radiance)
          for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(texel[c]));
      } else {
        ++refused;
        EXPECT_EQ(read.error().code, Code::Input) << read.error().message;
        EXPECT_EQ(read.error().message.find(entry.path().string() + ": "), 0u) << read.error().message;
      }
    }
  EXPECT_GE(files, 100);
  EXPECT_GE(refused, 90);
}

}  // namespace
}  // namespace pileus::image
