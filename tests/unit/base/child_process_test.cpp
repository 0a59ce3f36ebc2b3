// Programs that are started and go on by themselves.
#include "renderer/base/child_process.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

template <class Condition>
bool soon(Condition condition) {
  for (int i = 0; i < 500; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(20)))
    if (condition()) return true;
  return false;
}

TEST(ChildProcess, WhatGoesOnByItselfHasNoSignalBlockedAndIsReaped) {
  sigset_t ends, before;
  sigemptyset(&ends);
  for (const int s : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&ends, s);
  ASSERT_EQ(::pthread_sigmask(SIG_BLOCK, &ends, &before), 0);
  const auto file = test::scratchFolder() / "status";
  const auto started =
      startDetached("sh", {"-c", "grep SigBlk /proc/self/status > '" + file.string() + ".part' && mv '" +
                                     file.string() + ".part' '" + file.string() + "'"});
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ASSERT_TRUE(started) << started.error().message;
  ASSERT_TRUE(soon([&] { return std::filesystem::exists(file); }));
  EXPECT_EQ(readFile(file).value(), "SigBlk:\t0000000000000000\n");
  // No process is left for us to wait for, not even a dead one.
  EXPECT_TRUE(soon([] {
    siginfo_t info{};
    return ::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) < 0 && errno == ECHILD;
  }));
}

TEST(ChildProcess, AProgramThatIsNotThereIsNamed) {
  const auto started = startDetached("no-such-program-of-ours", {});
  ASSERT_FALSE(started);
  EXPECT_TRUE(started.error().message.starts_with("no-such-program-of-ours: cannot be run"))
      << started.error().message;
}

}  // namespace
}  // namespace pileus
