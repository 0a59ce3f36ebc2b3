#pragma once
// What every test may use: the data folder, scratch folders, running the pileus binary.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pileus::test {

/// $PILEUS_TEST_DATA, or nothing. Tests that need it call PILEUS_NEEDS_DATA() first.
std::optional<std::filesystem::path> dataFolder();

/// A fresh folder of this test, removed at the end of the process.
std::filesystem::path scratchFolder();

struct RunResult {
  int exitCode = -1;  ///< 128 + signal if killed by one
  std::string out, err;
};
/// Runs a program with a time limit (killed after it); environment entries "NAME=value" are added.
RunResult run(const std::vector<std::string>& arguments, double timeoutSeconds = 120,
              const std::vector<std::string>& environment = {});
/// The same with the built pileus binary as program. One that succeeds with a warning or an error on its
/// standard error fails the test, unless an ExpectLogged lives.
RunResult pileus(std::vector<std::string> arguments, double timeoutSeconds = 120,
                 const std::vector<std::string>& environment = {});

/// While one lives, warnings and errors in the log are expected; otherwise each one fails the test it appears
/// in.
struct ExpectLogged {
  ExpectLogged();
  ~ExpectLogged();
  static bool lives();
};

/// Fails the test for each line of a log that is a warning or an error and has none of `expected` in it.
void checkLog(const std::string& log, const std::vector<std::string>& expected = {});

}  // namespace pileus::test

#define PILEUS_NEEDS_DATA() \
  if (!pileus::test::dataFolder()) GTEST_SKIP() << "PILEUS_TEST_DATA is not set"
