#include "nodes/declare/value_traits.h"

namespace pileus::nodes {

void join(SocketValue& to, const SocketValue& more) {
  std::visit(
      [&to](const auto& value) {
        using T = std::decay_t<decltype(value)>;
        if constexpr (!std::is_same_v<T, std::monostate>)
          if (T* there = std::get_if<T>(&to)) return ValueTraits<T>::join(*there, value);
        to = value;
      },
      more);
}

}  // namespace pileus::nodes
