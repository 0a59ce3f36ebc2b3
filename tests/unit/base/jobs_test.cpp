// What is thrown in a job is its error, not the program's end.
#include "renderer/base/jobs.h"

#include <gtest/gtest.h>

#include <stdexcept>

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

}  // namespace
}  // namespace pileus
