#pragma once
// The two looks of the interface. Their colours: palette.inc.
#include <array>

#include "renderer/base/enum_info.h"

namespace pileus::editor {

enum class Appearance { Dark, Light };
constexpr auto enumInfo(Appearance*) {
  return std::array{EnumItem<Appearance>{Appearance::Dark, "dark", "Dark", ""},
                    EnumItem<Appearance>{Appearance::Light, "light", "Light", ""}};
}

}  // namespace pileus::editor
