#pragma once
// Variations of the document as rows of the parameter panel: taken, put back, blended by a slider.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "nodes/file/variations.h"

namespace pileus::editor {

struct ParameterRoom;

struct VariationRows {
  std::vector<nodes::Variation> all;                           ///< of the document as it is
  std::string error;                                           ///< why they cannot be read; "" = they can
  std::uint64_t generation = 0, revision = ~std::uint64_t(0);  ///< it was then
  std::string text;                                            ///< they were read from
  std::vector<std::filesystem::path> pictures;                 ///< where their pictures are kept
  double at = 0;                                               ///< the slider, 0 .. count - 1
  std::size_t naming = ~std::size_t(0);
  std::string name;  ///< typed for that one
};

void drawVariationRows(const ParameterRoom& room);
/// Edit > Take Variation: the values of all parameters, with what the viewport shows.
void takeVariation(const ParameterRoom& room);

}  // namespace pileus::editor
