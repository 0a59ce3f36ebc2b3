// `pileus info`: several files, and JSON that every reader takes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/support.h"

namespace pileus {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(Info, ListsEveryFile) {
  PILEUS_NEEDS_DATA();
  const fs::path folder = *test::dataFolder() / "vdb";
  const std::string a = folder / "smoke1.vdb", b = folder / "tinyvdbio_sphere-div1.vdb";
  const auto one = test::pileus({"info", a}), two = test::pileus({"info", b}),
             both = test::pileus({"info", a, b});
  ASSERT_EQ(both.exitCode, 0) << both.err;
  EXPECT_EQ(both.out, one.out + "\n" + two.out);
  const auto json = test::pileus({"info", "--json", a, b});
  ASSERT_EQ(json.exitCode, 0) << json.err;
  const Json list = Json::parse(json.out, nullptr, false);
  ASSERT_TRUE(list.is_array() && list.size() == 2) << json.out;
  EXPECT_EQ(list[1]["file"], b);
  const auto single = test::pileus({"info", "--json", a});
  EXPECT_EQ(Json::parse(single.out, nullptr, false), list[0]) << "one file is an object";
  // What cannot be read keeps no other from being listed.
  const auto missing = test::pileus({"info", folder / "none.vdb", a});
  EXPECT_EQ(missing.exitCode, 3);
  EXPECT_NE(missing.out.find(one.out), std::string::npos) << missing.out;
  EXPECT_NE(missing.err.find("none.vdb"), std::string::npos);
}

TEST(Info, JsonIsUtf8WhateverAFileIsCalled) {
  PILEUS_NEEDS_DATA();
  const fs::path file = test::scratchFolder() / "n\xe9.vdb";  // Latin-1
  fs::copy_file(*test::dataFolder() / "vdb" / "tinyvdbio_sphere-div1.vdb", file);
  const auto r = test::pileus({"info", "--json", file});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const Json json = Json::parse(r.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << r.out;
  EXPECT_TRUE(json["file"].get<std::string>().ends_with("n\xef\xbf\xbd.vdb")) << json["file"];
}

}  // namespace
}  // namespace pileus
