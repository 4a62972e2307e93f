#pragma once
#include <exception>
#include <string>
#include <utility>

#include "base/Result.h"

namespace gt::python {

/// What Python sees as gt2003.Error.
class Failure : public std::exception {
 public:
  explicit Failure(Error error) : error{std::move(error)}, text_{this->error.text()} {}

  const char* what() const noexcept override { return text_.c_str(); }

  const Error error;

 private:
  std::string text_;
};

/// Throws a Failure about what was given.
[[noreturn]] inline void refuse(const std::string& field, std::string what) {
  throw Failure{Error{.field = field, .what = std::move(what)}};
}

/// The value of a result; throws its error.
template <typename T>
T orThrow(Result<T> result) {
  if (!result) throw Failure{result.error()};
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

}  // namespace gt::python
