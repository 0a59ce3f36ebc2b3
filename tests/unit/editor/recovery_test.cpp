#include "editor/document/recovery.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus::editor {
namespace {

namespace fs = std::filesystem;

nodes::Graph graphWith(double radius) {
  nodes::Graph graph = *nodes::addNode({}, "volume.sphere", {0, 0}, "Ball");
  return *nodes::setParam(graph, "Ball", "radius", radius);
}

/// Calls watch() until `written` files are there.
void until(Recovery& recovery, int written, const nodes::Graph& graph, std::uint64_t revision,
           const fs::path& path) {
  for (int i = 0; i < 400 && recovery.written() < written; ++i) {
    recovery.watch(graph, revision, path, true, true);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_EQ(recovery.written(), written) << recovery.takeError();
}

std::size_t recoveryFiles(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".json" && entry.path().filename() != "about.json") ++count;
  return count;
}

/// Another process works and is killed: what an editor leaves behind.
void killedEditor(const fs::path& folder, const fs::path& original, double radius) {
  const pid_t child = ::fork();
  if (child == 0) {
    Recovery recovery(folder, 0);
    (void)recovery.saveNow(graphWith(radius), original);
    ::_exit(0);  // no destructors, as after SIGKILL
  }
  int status = 0;
  ::waitpid(child, &status, 0);
}

TEST(Recovery, WritesAfterARestAndOnlyThen) {
  const fs::path folder = test::scratchFolder() / "recovery";
  Recovery recovery(folder, 0.15);
  recovery.watch(graphWith(1), 2, {}, true, true);
  EXPECT_GT(recovery.dueSeconds(), 0.05);
  EXPECT_FALSE(fs::exists(folder)) << "nothing is written while it changes";
  for (int i = 0; i < 20; ++i) {  // a long drag: never resting
    recovery.watch(graphWith(1 + i), std::uint64_t(3 + i), {}, true, false);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(recovery.written(), 0);
  until(recovery, 1, graphWith(20), 22, {});
  EXPECT_LT(recovery.dueSeconds(), 0) << "saved once, not again and again";
  EXPECT_EQ(recoveryFiles(folder), 1u);
}

TEST(Recovery, KeepsTenReadOnlyFiles) {
  const fs::path folder = test::scratchFolder() / "recovery";
  Recovery recovery(folder, 0);
  for (int i = 1; i <= 13; ++i) until(recovery, i, graphWith(i), std::uint64_t(i + 1), {});
  EXPECT_EQ(recoveryFiles(folder), 10u);
  fs::path newest;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json" || entry.path().filename() == "about.json") continue;
    struct stat st {};
    ::stat(entry.path().c_str(), &st);
    EXPECT_EQ(st.st_mode & 0777, 0444u) << entry.path();
    newest = std::max(newest, entry.path());
  }
  EXPECT_TRUE(nodes::loadGraph(newest)->graph == graphWith(13));
}

TEST(Recovery, SavingOrClosingRemovesTheSet) {
  const fs::path folder = test::scratchFolder() / "recovery";
  Recovery recovery(folder, 0);
  until(recovery, 1, graphWith(1), 2, {});
  recovery.watch(graphWith(1), 3, {}, false, true);  // not dirty any more
  EXPECT_EQ(recoveryFiles(folder), 0u);
  until(recovery, 2, graphWith(2), 4, {});
  recovery.discard();
  EXPECT_EQ(recoveryFiles(folder), 0u);
  EXPECT_TRUE(findLost(folder).empty());
}

TEST(Recovery, LiveWorkOfAnotherEditorIsNotOffered) {
  const fs::path folder = test::scratchFolder() / "recovery";
  Recovery alive(folder, 0);
  until(alive, 1, graphWith(1), 2, {});
  EXPECT_TRUE(findLost(folder).empty()) << "its lock is held";
  EXPECT_EQ(recoveryFiles(folder), 1u) << "and it is left alone";
  killedEditor(folder, {}, 7);
  const std::vector<Lost> lost = findLost(folder);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_TRUE(lost[0].original.empty());
  EXPECT_TRUE(nodes::loadGraph(lost[0].file)->graph == graphWith(7));
  removeLost(lost[0]);
  EXPECT_TRUE(findLost(folder).empty());
  EXPECT_EQ(recoveryFiles(folder), 1u) << "the living one's";
}

TEST(Recovery, OfferedOnlyIfNewerAndDifferent) {
  const fs::path scratch = test::scratchFolder(), folder = scratch / "recovery", file = scratch / "a.json";
  ASSERT_TRUE(nodes::saveGraph(file, graphWith(1)));
  killedEditor(folder, file, 1);
  EXPECT_TRUE(findLost(folder).empty()) << "equal to the file";
  EXPECT_EQ(recoveryFiles(folder), 0u) << "and removed";

  killedEditor(folder, file, 2);
  std::vector<Lost> lost = findLost(folder);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].original, file);
  EXPECT_TRUE(nodes::loadGraph(file)->graph == graphWith(1)) << "the user's file is untouched";

  // The file was saved later, from somewhere else.
  fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(10));
  EXPECT_TRUE(findLost(folder).empty());

  killedEditor(folder, scratch / "gone.json", 3);
  EXPECT_EQ(findLost(folder).size(), 1u) << "its document is missing: all the more";
}

TEST(Recovery, AFolderThatCannotBeMadeIsReportedOnce) {
  const fs::path scratch = test::scratchFolder();
  std::ofstream(scratch / "file") << "x";
  Recovery recovery(scratch / "file" / "recovery", 0);
  std::string error;
  for (int i = 0; i < 200 && error.empty(); ++i) {
    recovery.watch(graphWith(1), 2, {}, true, true);
    error = recovery.takeError();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_NE(error.find("cannot be made"), std::string::npos) << error;
  EXPECT_TRUE(recovery.takeError().empty());
}

TEST(Files, AFailedWriteKeepsTheOldContent) {
  const fs::path folder = test::scratchFolder(), file = folder / "a.json";
  ASSERT_TRUE(writeFileAtomic(file, "old"));
  ::chmod(file.c_str(), 0600);
  ASSERT_TRUE(writeFileAtomic(file, "older"));
  struct stat st {};
  ::stat(file.c_str(), &st);
  EXPECT_EQ(st.st_mode & 0777, 0600u) << "permissions are kept";
  fs::create_symlink("a.json", folder / "link.json");
  ASSERT_TRUE(writeFileAtomic(folder / "link.json", "through the link"));
  EXPECT_TRUE(fs::is_symlink(fs::symlink_status(folder / "link.json")));
  EXPECT_EQ(*readFile(file), "through the link");

  // A disk that is full: the limit of file sizes behaves alike.
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const Result<void> written = writeFileAtomic(file, std::string(100000, 'x'));
    ::_exit(!written && written.error().message.find("cannot be written") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(*readFile(file), "through the link");
  EXPECT_FALSE(writeFileAtomic(folder / "missing" / "a.json", "x"));
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) ++files;
  EXPECT_EQ(files, 2u) << "no temporary file is left";
}

/// What files.cpp does with work that was left behind, while another document is open.
TEST(Recovery, OpenedWorkIsKeptUntilItIsSaved) {
  const fs::path folder = test::scratchFolder() / "recovery", original = test::scratchFolder() / "work.json";
  ASSERT_TRUE(nodes::saveGraph(original, graphWith(1), {}));
  killedEditor(folder, original, 2);
  const std::vector<Lost> lost = findLost(folder);
  ASSERT_EQ(lost.size(), 1u);
  {
    Recovery recovery(folder, 1000);
    recovery.watch(graphWith(5), 1, test::scratchFolder() / "other.json", false, true);
    ASSERT_TRUE(recovery.saveNow(graphWith(2), original));
    removeLost(lost.front());
    recovery.watch(graphWith(2), 2, original, true, true);
    EXPECT_EQ(recoveryFiles(folder), 1u) << "the only copy of the work is gone";
  }
  // That editor is killed as well: the work is still offered.
  const std::vector<Lost> again = findLost(folder);
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again.front().original, original);
  EXPECT_EQ(nodes::loadGraph(again.front().file)->graph, graphWith(2));
}

}  // namespace
}  // namespace pileus::editor
