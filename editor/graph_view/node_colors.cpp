#include "editor/graph_view/node_colors.h"

#include <charconv>

#include "editor/toolkit/theme.h"

namespace pileus::editor {
namespace {

constexpr NodeColor kColors[] = {
    {"", "Default"},      {"#8c4646", "Red"},  {"#8f5f38", "Orange"}, {"#857433", "Yellow"},
    {"#4d7a45", "Green"}, {"#36766f", "Teal"}, {"#3d6590", "Blue"},   {"#67518f", "Purple"},
    {"#8a4a76", "Pink"},  {"#5b636f", "Grey"},
};

}  // namespace

std::span<const NodeColor> nodeColors() { return kColors; }

ImU32 nodeColor(std::string_view id) {
  if (id.size() != 7 || id[0] != '#') return 0;
  unsigned value = 0;
  const auto [end, error] = std::from_chars(id.data() + 1, id.data() + 7, value, 16);
  if (error != std::errc() || end != id.data() + 7) return 0;
  return headerColor(IM_COL32((value >> 16) & 255, (value >> 8) & 255, value & 255, 255));
}

}  // namespace pileus::editor
