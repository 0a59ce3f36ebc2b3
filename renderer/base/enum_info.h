#pragma once
// Names of enum values, declared beside the enum: `constexpr auto enumInfo(Basis*) { return
// std::array{EnumItem<Basis>{...}}; }`.
#include <optional>
#include <string_view>

namespace pileus {

template <class E>
struct EnumItem {
  E value;
  std::string_view id;     ///< in files and on the command line
  std::string_view label;  ///< in the interface
  std::string_view help;
};

template <class E>
concept DescribedEnum = requires {
  enumInfo(static_cast<E*>(nullptr));
};

template <DescribedEnum E>
constexpr std::string_view enumId(E value) {
  for (const auto& item : enumInfo(static_cast<E*>(nullptr)))
    if (item.value == value) return item.id;
  return {};
}

template <DescribedEnum E>
constexpr std::optional<E> enumFromId(std::string_view id) {
  for (const auto& item : enumInfo(static_cast<E*>(nullptr)))
    if (item.id == id) return item.value;
  return std::nullopt;
}

}  // namespace pileus
