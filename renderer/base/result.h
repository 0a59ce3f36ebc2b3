#pragma once
// Errors are values at every boundary: what happened, where, and what to do next. The code decides the exit
// status.
#include <fmt/core.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace pileus {

/// Why something failed; the values are the exit codes of the command line.
enum class Code {
  Internal = 1,   ///< a defect of ours
  Arguments = 2,  ///< a bad option or parameter value
  Input = 3,      ///< an input that cannot be read, or an output that cannot be written
  Gpu = 4,        ///< no usable GPU, or out of GPU memory
  Cancelled = 5,
  Bound = 6,  ///< a given error bound was exceeded
};

struct Error {
  Code code = Code::Internal;
  std::string message;
  bool passing = false;  ///< of the moment, not of the input: the same may go well later
};

template <class... Args>
Error fail(Code code, fmt::format_string<Args...> format, Args&&... args) {
  return Error{code, fmt::format(format, std::forward<Args>(args)...)};
}

/// A value or an Error. `if (!r) return r.error();` or PILEUS_TRY.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit by design
  Result(Error error) : state_(std::move(error)) {}  // NOLINT
  explicit operator bool() const { return state_.index() == 0; }
  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT
  explicit operator bool() const { return !error_; }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace pileus

/// PILEUS_TRY(auto x, expression): declares x from a Result or returns its error.
#define PILEUS_TRY(declaration, expression) PILEUS_TRY_(declaration, expression, __LINE__)
#define PILEUS_TRY_(declaration, expression, line) PILEUS_TRY__(declaration, expression, line)
#define PILEUS_TRY__(declaration, expression, line)     \
  auto pileusTry##line = (expression);                  \
  if (!pileusTry##line) return pileusTry##line.error(); \
  declaration = std::move(pileusTry##line).value()
/// For Result<void>.
#define PILEUS_CHECK(expression)                                       \
  do {                                                                 \
    if (auto checked = (expression); !checked) return checked.error(); \
  } while (false)
