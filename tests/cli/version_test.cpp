// The version and the changelog are one.
#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

TEST(Version, IsTheNewestEntryOfTheChangelog) {
  const Result<std::string> log = readFile(PILEUS_SOURCE_DIR "/docs/changelog.md");
  ASSERT_TRUE(log);
  const std::size_t heading = log->find("\n## ");
  ASSERT_NE(heading, std::string::npos);
  const std::string newest = log->substr(heading + 4, log->find('\n', heading + 4) - heading - 4);
  EXPECT_EQ(test::pileus({"--version"}).out, "pileus " + newest + "\n");
}

}  // namespace
}  // namespace pileus
