// Lists of files: kinds, filter, sequences, order, and completion of typed paths.
#include "editor/toolkit/file_listing.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/support.h"

namespace pileus::editor {
namespace {

namespace fs = std::filesystem;

FileEntry file(const std::string& name, std::uintmax_t bytes = 1, std::int64_t time = 0) {
  FileEntry e;
  e.name = name, e.bytes = bytes, e.time = time;
  return e;
}
FileEntry folder(const std::string& name) {
  FileEntry e;
  e.name = name, e.folder = true;
  return e;
}

std::vector<std::string> labels(const std::vector<FileEntry>& entries) {
  std::vector<std::string> out;
  for (const FileEntry& e : entries) out.push_back(entryLabel(e));
  return out;
}
using Names = std::vector<std::string>;

TEST(FileListing, NumberedFilesAreOneRow) {
  std::vector<FileEntry> list = foldSequences({file("smoke.0001.vdb", 10, 5), file("smoke.0003.vdb", 20, 9),
                                               file("smoke.0002.vdb", 30, 7), file("single.0001.vdb"),
                                               file("notes.txt"), folder("take1"), folder("take2")});
  sortEntries(list, FileOrder::Name, false);
  EXPECT_EQ(labels(list), (Names{"take1", "take2", "notes.txt", "single.0001.vdb", "smoke.####.vdb  [1-3]"}));
  EXPECT_EQ(list.back().bytes, 60u);
  EXPECT_EQ(list.back().time, 9);
  EXPECT_EQ(list.back().firstName, "smoke.0001.vdb");
}

TEST(FileListing, SequencesSayTheirGapsAndKeepTheirPadding) {
  EXPECT_EQ(labels(foldSequences({file("a_8.exr"), file("a_9.exr"), file("a_10.exr"), file("a_12.exr")})),
            (Names{"a_#.exr  [8-12, 4 files]"}));
  EXPECT_EQ(foldSequences({file("b1.exr"), file("b01.exr")}).size(), 2u) << "different padding, two files";
  EXPECT_EQ(foldSequences({file("a.1.vdb"), file("b.1.vdb")}).size(), 2u);
  EXPECT_EQ(foldSequences({file("x12345678901.vdb"), file("x12345678902.vdb")}).size(), 2u)
      << "that is no frame number";
}

TEST(FileListing, DocumentsNeverFold) {
  const std::vector<FileEntry> versions = {file("shot_v001.json"), file("shot_v002.json"),
                                           file("shot_v003.JSON")};
  EXPECT_EQ(labels(foldSequences(versions)), (Names{"shot_v001.json", "shot_v002.json", "shot_v003.JSON"}));
}

TEST(FileListing, TheNextVersionIsTheNextFreeNumber) {
  const fs::path at = test::scratchFolder();
  EXPECT_EQ(nextVersion(at / "shot_v001.json"), at / "shot_v002.json");
  std::ofstream(at / "shot_v002.json") << "x";
  EXPECT_EQ(nextVersion(at / "shot_v001.json"), at / "shot_v003.json");
  EXPECT_EQ(nextVersion(at / "b9.json"), at / "b10.json");
  EXPECT_EQ(nextVersion(at / "harbour.json"), at / "harbour_v002.json");
  EXPECT_EQ(nextVersion(at / "2026.json"), at / "2027.json");
}

TEST(FileListing, PatternsNameTheirFiles) {
  EXPECT_TRUE(matchesPattern("smoke.####.vdb", "smoke.0042.vdb"));
  EXPECT_TRUE(matchesPattern("smoke.%04d.vdb", "smoke.0042.vdb"));
  EXPECT_TRUE(matchesPattern("a_#.exr", "a_12.exr"));
  EXPECT_FALSE(matchesPattern("smoke.####.vdb", "smoke.42.vdb"));
  EXPECT_FALSE(matchesPattern("smoke.####.vdb", "smoke.vdb"));
  EXPECT_FALSE(matchesPattern("smoke.####.vdb", "smoke.00x2.vdb"));
  EXPECT_TRUE(isPattern("a.####.vdb"));
  EXPECT_FALSE(isPattern("100%.vdb"));
}

TEST(FileListing, KindsAndWordsChoose) {
  const std::vector<FileEntry> all = {file("Smoke A.VDB"), file("smoke b.vdb"), file("smoke.exr"),
                                      folder("smoke"), folder("other")};
  EXPECT_EQ(labels(filtered(all, {"vdb"}, "")), (Names{"Smoke A.VDB", "smoke b.vdb", "smoke", "other"}));
  EXPECT_EQ(labels(filtered(all, {"vdb"}, "SMO b.")), (Names{"smoke b.vdb"}));
  EXPECT_EQ(filtered(all, {}, "").size(), all.size());
}

TEST(FileListing, OrderByNameDateAndSize) {
  std::vector<FileEntry> list = {file("a10", 1, 3), file("a2", 3, 1), file("B1", 2, 2), folder("z")};
  sortEntries(list, FileOrder::Name, false);
  EXPECT_EQ(labels(list), (Names{"z", "a2", "a10", "B1"}));
  sortEntries(list, FileOrder::Name, true);
  EXPECT_EQ(labels(list), (Names{"z", "B1", "a10", "a2"}));
  sortEntries(list, FileOrder::Date, true);
  EXPECT_EQ(labels(list), (Names{"z", "a10", "B1", "a2"}));
  sortEntries(list, FileOrder::Size, false);
  EXPECT_EQ(labels(list), (Names{"z", "a10", "B1", "a2"}));
}

TEST(FileListing, CompletionAddsWhatIsCommon) {
  const fs::path root = test::scratchFolder() / "completion";
  fs::create_directories(root / "clouds" / "deep");
  for (const char* name : {"smoke_a.vdb", "smoke_b.vdb", "smoke.txt", "clouds/cumulus.vdb", ".hidden.vdb"})
    std::ofstream(root / name) << "x";
  const Names vdb = {"vdb"};
  EXPECT_EQ(completedPath("s", root, vdb), "smoke_");
  EXPECT_EQ(completedPath("s", root, {}), "smoke");
  EXPECT_EQ(completedPath("smoke_b", root, vdb), "smoke_b.vdb");
  EXPECT_EQ(completedPath("cl", root, vdb), "clouds/");
  EXPECT_EQ(completedPath("clouds/c", root, vdb), "clouds/cumulus.vdb");
  EXPECT_EQ(completedPath((root / "clouds" / "c").string(), "/", vdb),
            (root / "clouds" / "cumulus.vdb").string());
  EXPECT_EQ(completedPath("nothing", root, vdb), "nothing");
  EXPECT_EQ(completedPath("no/such/folder/x", root, vdb), "no/such/folder/x");
  EXPECT_EQ(completedPath("", root / "clouds", vdb), "");
}

TEST(FileListing, AFolderThatIsNotThereIsAnError) {
  EXPECT_FALSE(listFolder(test::scratchFolder() / "nowhere"));
}

TEST(FileListing, Sizes) {
  EXPECT_EQ(sizeText(12), "12 B");
  EXPECT_EQ(sizeText(2048), "2 KiB");
  EXPECT_EQ(sizeText(5u << 20), "5.0 MiB");
}

}  // namespace
}  // namespace pileus::editor
