// Where files are put when there is no home, and what may stand in their way there.
#include "renderer/base/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <vector>

#include "tests/support/support.h"

namespace fs = std::filesystem;

namespace pileus {
namespace {

/// An environment without a home; put back at the end.
class Homeless {
 public:
  explicit Homeless(const fs::path& temporary) {
    for (const char* name : {"HOME", "XDG_CACHE_HOME", "TMPDIR"}) {
      const char* value = std::getenv(name);
      old_.emplace_back(name, value ? std::optional<std::string>(value) : std::nullopt);
      ::unsetenv(name);
    }
    ::setenv("TMPDIR", temporary.c_str(), 1);
  }
  ~Homeless() {
    for (const auto& [name, value] : old_) value ? ::setenv(name, value->c_str(), 1) : ::unsetenv(name);
  }

 private:
  std::vector<std::pair<const char*, std::optional<std::string>>> old_;
};

mode_t modeOf(const fs::path& path) {
  struct stat st {};
  EXPECT_EQ(::lstat(path.c_str(), &st), 0) << path;
  return st.st_mode;
}

TEST(Folders, TheFallbackBelongsToTheUserAlone) {
  const fs::path temporary = test::scratchFolder();
  const Homeless homeless(temporary);
  const fs::path folder = cacheFolder();
  EXPECT_EQ(folder.parent_path(), temporary);
  EXPECT_EQ(modeOf(folder) & 07777, 0700u);
  EXPECT_EQ(cacheFolder(), folder) << "found again";
  // Others could read it, but not write: closed, and used.
  ::chmod(folder.c_str(), 0755);
  EXPECT_EQ(cacheFolder(), folder);
  EXPECT_EQ(modeOf(folder) & 07777, 0700u);
}

TEST(Folders, AFallbackThatOthersHadAHandInIsNotUsed) {
  const fs::path temporary = test::scratchFolder();
  const Homeless homeless(temporary);
  const fs::path usual = cacheFolder();
  ::chmod(usual.c_str(), 0777);
  const fs::path other = cacheFolder();
  EXPECT_NE(other, usual);
  EXPECT_EQ(modeOf(other) & 07777, 0700u);
  // A link somewhere else.
  fs::remove(usual);
  fs::create_directory(temporary / "elsewhere");
  fs::create_directory_symlink(temporary / "elsewhere", usual);
  EXPECT_EQ(cacheFolder(), other);
}

TEST(WriteFile, ATemporaryThatIsThereAlreadyIsNotFollowed) {
  const fs::path folder = test::scratchFolder(), target = folder / "graph.json", victim = folder / "victim";
  std::ofstream(victim) << "untouched";
  // Every name that could be guessed.
  fs::create_symlink(victim, target.string() + fmt::format(".tmp{}", ::getpid()));
  for (int i = 0; i < 100; ++i)
    fs::create_symlink(victim, target.string() + fmt::format(".tmp{}-{}", ::getpid(), i));
  ASSERT_TRUE(writeFileAtomic(target, "content"));
  EXPECT_EQ(*readFile(target), "content");
  EXPECT_FALSE(fs::is_symlink(target));
  EXPECT_EQ(*readFile(victim), "untouched");
}

}  // namespace
}  // namespace pileus
