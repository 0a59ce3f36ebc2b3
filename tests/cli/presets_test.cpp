// Every preset loads without faults, has a picture in the gallery and renders to something finite.
#include <cmath>

#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/image/exr.h"
#include "renderer/image/png.h"
#include "tests/support/support.h"

namespace pileus::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> presets() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(fs::path(PILEUS_SOURCE_DIR) / "presets"))
    if (entry.path().extension() == ".json") out.push_back(entry.path());
  return out;
}

TEST(Presets, LoadWithoutFaultsAndHaveAThumbnail) {
  ASSERT_GE(presets().size(), 11u);
  for (const fs::path& path : presets()) {
    const auto loaded = nodes::loadGraph(path);
    ASSERT_TRUE(loaded) << loaded.error().message;
    for (const nodes::Fault& fault : loaded->faults) ADD_FAILURE() << path << ": " << nodes::faultText(fault);
    const fs::path thumbnail = path.parent_path() / "thumbnails" / (path.stem().string() + ".png");
    const auto bytes = readFile(thumbnail);
    ASSERT_TRUE(bytes) << bytes.error().message;
    const auto bitmap = image::decodePng(*bytes);
    ASSERT_TRUE(bitmap) << thumbnail;
    EXPECT_EQ(bitmap->size, ivec2(640, 360)) << thumbnail;
  }
}

TEST(Presets, RenderSomethingFinite) {
  for (const fs::path& path : presets()) {
    const auto loaded = nodes::loadGraph(path);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const std::vector<std::string> outputs = nodes::outputNodes(loaded->graph);
    ASSERT_FALSE(outputs.empty()) << path;
    const fs::path out = scratchFolder() / "preset.exr";
    const RunResult r = pileus({"render", path.string(), "-o", out.string(), "--size", "96x54", "--output",
                                outputs.front(), "--overwrite"},
                               240);
    ASSERT_EQ(r.exitCode, 0) << path << ": " << r.err;
    const auto picture = image::readExr(out);
    ASSERT_TRUE(picture) << picture.error().message;
    double sum = 0;
    for (const float v : picture->layers.front().pixels) {
      ASSERT_TRUE(std::isfinite(v)) << path;
      sum += static_cast<double>(v);
    }
    EXPECT_GT(sum / static_cast<double>(picture->layers.front().pixels.size()), 0.01) << path << " is black";
  }
}

}  // namespace
}  // namespace pileus::test
