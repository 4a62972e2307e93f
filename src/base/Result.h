#pragma once
#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace gt {

/// Severity of a report: an error keeps data from being used or work from being done, a warning
/// does not.
enum class Severity { note, warning, error };

/// Describes an error in data from outside and its place. Only the known members are set:
/// `Error{.file = path, .line = 3, .field = "gain", .what = "expected a number"}`.
struct Error {
  std::string
      file{};      ///< Path as the user gave it, or a name of the source ("console", "network").
  int line = 0;    ///< From 1; 0 where there are no lines.
  int column = 0;  ///< From 1; 0 if unknown.
  std::string field{};  ///< The field, element or name concerned; may be empty.
  std::string what{};   ///< What is wrong, and what was expected.
  Severity severity = Severity::error;

  /// One line: `file:line:column: field: what`, in the format of compilers, with `warning: ` before
  /// the field of a warning.
  std::string text() const;
};

/// Either a value, or the error that prevented it.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_{std::in_place_index<0>, std::move(value)} {}
  Result(Error error) : state_{std::in_place_index<1>, std::move(error)} {}

  explicit operator bool() const { return state_.index() == 0; }
  T& operator*() & { return std::get<0>(state_); }
  const T& operator*() const& { return std::get<0>(state_); }
  T&& operator*() && { return std::get<0>(std::move(state_)); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Either success, or the error that prevented it.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_{std::move(error)} {}

  explicit operator bool() const { return !error_; }
  const Error& error() const {
    assert(error_);
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace gt
