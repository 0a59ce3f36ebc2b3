// Where files are put when there is no home, and what may stand in their way there.
#include "renderer/base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <thread>
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

TEST(WriteFile, KeepsPermissionsWhateverTheMask) {
  const fs::path target = test::scratchFolder() / "graph.json";
  std::ofstream(target) << "old";
  ASSERT_EQ(::chmod(target.c_str(), 0664), 0);
  const mode_t mask = ::umask(077);
  const auto written = writeFileAtomic(target, "new");
  ::umask(mask);
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_EQ(*readFile(target), "new");
  EXPECT_EQ(modeOf(target) & 0777, 0664u);
}

TEST(WriteFile, AReadOnlyFileIsNotReplaced) {
  const fs::path target = test::scratchFolder() / "published.json";
  std::ofstream(target) << "published";
  ASSERT_EQ(::chmod(target.c_str(), 0444), 0);
  const auto written = writeFileAtomic(target, "new");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("published.json: cannot be written (it is read-only)"),
            std::string::npos)
      << written.error().message;
  EXPECT_EQ(*readFile(target), "published");
}

TEST(WriteFile, ALinkStaysALinkAlsoToWhatIsNotThereYet) {
  const fs::path folder = test::scratchFolder(), link = folder / "latest.json";
  fs::create_directory(folder / "versions");
  fs::create_symlink("versions/next.json", folder / "next");
  fs::create_symlink("next", link);
  for (const char* content : {"first", "second"}) {
    ASSERT_TRUE(writeFileAtomic(link, content));
    EXPECT_TRUE(fs::is_symlink(link) && fs::is_symlink(folder / "next"));
    EXPECT_TRUE(fs::is_regular_file(folder / "versions" / "next.json"));
    EXPECT_EQ(*readFile(link), content);
  }
}

TEST(WriteFile, PipesAndDevicesAreWrittenTo) {
  const fs::path folder = test::scratchFolder(), pipe = folder / "pipe", link = folder / "link";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("pipe", link);
  const std::string content(100000, 'x');  // more than a pipe holds
  for (const fs::path& target : {pipe, link}) {
    std::string read;
    std::thread reader([&] { read = readFile(pipe).value(); });
    const auto written = writeFileAtomic(target, content);
    reader.join();
    ASSERT_TRUE(written) << written.error().message;
    EXPECT_EQ(read, content);
    EXPECT_TRUE(S_ISFIFO(modeOf(pipe)) && fs::is_symlink(link));
  }
  // A terminal stands for devices: nobody can put a file in its place, should this fail.
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(::grantpt(terminal), 0);
  ASSERT_EQ(::unlockpt(terminal), 0);
  const auto written = writeFileAtomic(::ptsname(terminal), "hello");
  EXPECT_TRUE(written) << written.error().message;
  char said[5] = {};
  EXPECT_EQ(::read(terminal, said, sizeof said), 5);
  EXPECT_EQ(std::string_view(said, sizeof said), "hello");
  ::close(terminal);
}

}  // namespace
}  // namespace pileus
