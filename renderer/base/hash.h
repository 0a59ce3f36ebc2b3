#pragma once
// Content keys: 128-bit XXH3 over values, strings and other keys.
#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace pileus {

struct Key {
  std::uint64_t lo = 0, hi = 0;
  auto operator<=>(const Key&) const = default;
  explicit operator bool() const { return lo != 0 || hi != 0; }
  std::string hex() const;  ///< 32 lowercase digits
};

class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  Hasher& bytes(const void* data, std::size_t size);
  /// Length first, so that ("ab","c") and ("a","bc") differ.
  Hasher& add(std::string_view text);
  Hasher& add(const char* text) { return add(std::string_view(text)); }
  Hasher& add(const Key& key) { return bytes(&key, sizeof key); }
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) Hasher& add(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      if (value == T(0)) value = T(0);  // -0 and +0 are one value
    }
    return bytes(&value, sizeof value);
  }
  Key key() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

Key hashBytes(std::span<const std::byte> data);

}  // namespace pileus

template <>
struct std::hash<pileus::Key> {
  std::size_t operator()(const pileus::Key& k) const noexcept {
    return static_cast<std::size_t>(k.lo ^ (k.hi * 0x9E3779B97F4A7C15ull));
  }
};
