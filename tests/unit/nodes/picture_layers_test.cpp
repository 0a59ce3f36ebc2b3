// What light layers are called in files.
#include "nodes/evaluate/picture_layers.h"

#include <gtest/gtest.h>

#include <cctype>

namespace pileus::nodes {
namespace {

TEST(PictureLayers, NamesAreSafeForOtherPrograms) {
  EXPECT_EQ(layerName("Sun"), "Sun");
  EXPECT_EQ(layerName("Sky/Soft Sun"), "Sky_Soft_Sun");
  EXPECT_EQ(layerName("key.light (left)"), "key_light_left");
  EXPECT_EQ(layerName("S\xc3\xbc"
                      "den"),
            "S_den");
  EXPECT_EQ(layerName("2nd"), "light_2nd");
  EXPECT_EQ(layerName("\xe5\xa4\xaa\xe9\x99\xbd"), "light");
  // What means something in other programs, or among our own layers.
  for (const char* taken : {"depth", "Emission", "rgba", "R", "a", "mask"})
    EXPECT_EQ(layerName(taken), std::string(taken) + "_light");
  for (int c = 1; c < 256; ++c) {
    const std::string name = layerName(std::string("L") + static_cast<char>(c) + "x");
    for (const char plain : name)
      EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(plain)) || plain == '_') << c;
  }
}

}  // namespace
}  // namespace pileus::nodes
