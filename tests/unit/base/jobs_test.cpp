// What is thrown in a job is its error, not the program's end; a loose job is not waited for.
#include "renderer/base/jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "renderer/base/profile.h"

namespace pileus {
namespace {

TEST(Jobs, WhatIsThrownBecomesAnError) {
  Job<int> full([](JobControl&) -> Result<int> { throw std::bad_alloc(); });
  full.wait();
  ASSERT_TRUE(full.done());
  ASSERT_FALSE(full.result());
  EXPECT_EQ(full.result().error().code, Code::Input);
  EXPECT_NE(full.result().error().message.find("out of memory"), std::string::npos);
  Job<int> broken([](JobControl&) -> Result<int> { throw std::runtime_error("no such thing"); });
  broken.wait();
  ASSERT_FALSE(broken.result());
  EXPECT_EQ(broken.result().error().message, "no such thing");
  Job<int> strange([](JobControl&) -> Result<int> { throw 7; });
  strange.wait();
  ASSERT_FALSE(strange.result());
  EXPECT_EQ(strange.result().error().code, Code::Internal);
}

TEST(Jobs, ALooseJobIsNotWaitedForUntilTheEnd) {
  std::atomic<int> begun{0}, ended{0};
  {
    // Two that notice late that they are cancelled.
    const auto slow = [&](JobControl& control) -> Result<int> {
      ++begun;
      while (!control.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::this_thread::sleep_for(std::chrono::milliseconds(400));
      return ++ended;
    };
    LooseJob<int> one = looseJob<int>(slow), other = looseJob<int>(slow);
    while (begun < 2) std::this_thread::yield();
    const Stopwatch clock;
    one.reset();
    other.reset();
    EXPECT_LT(clock.ms(), 200) << "whoever draws the window does not stand still";
    EXPECT_EQ(ended, 0);
  }
  joinRetiredJobs();
  EXPECT_EQ(ended, 2);
}

}  // namespace
}  // namespace pileus
