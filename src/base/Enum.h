#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace gt {
namespace detail {

/// The name of an enumerator as the compiler spells it; empty for a value that has none.
template <auto value>
constexpr std::string_view enumeratorName() {
  std::string_view s = __PRETTY_FUNCTION__;
  const auto begin = s.find("value = ") + 8;
  s = s.substr(begin, s.find_first_of(";]", begin) - begin);
  if (s.empty() || s.front() == '(' || s.front() == '-' || (s.front() >= '0' && s.front() <= '9'))
    return {};
  const auto colon = s.rfind("::");
  return colon == s.npos ? s : s.substr(colon + 2);
}

template <typename E, std::size_t n = 0>
constexpr std::size_t enumeratorCount() {
  if constexpr (n >= 128 || enumeratorName<static_cast<E>(n)>().empty())
    return n;
  else
    return enumeratorCount<E, n + 1>();
}

template <typename E, std::size_t... i>
constexpr auto enumeratorNames(std::index_sequence<i...>) {
  return std::array<std::string_view, sizeof...(i)>{enumeratorName<static_cast<E>(i)>()...};
}

}  // namespace detail

/// How many enumerators an enumeration has that counts from 0 without gaps.
template <typename E>
constexpr std::size_t enumCount = detail::enumeratorCount<E>();

/// The names of an enumeration's values, in order; the enumeration counts from 0 without gaps.
template <typename E>
constexpr auto enumNames = detail::enumeratorNames<E>(std::make_index_sequence<enumCount<E>>{});

/// The name of a value; "?" for a number that no enumerator has.
template <typename E>
requires std::is_enum_v<E>
constexpr std::string_view enumName(E value) {
  const auto i = static_cast<std::size_t>(value);
  return i < enumCount<E> ? enumNames<E>[i] : "?";
}

/// The value with a name, if there is one. Words may also be written as in the report:
/// search-for-ball is searchForBall.
template <typename E>
std::optional<E> enumValue(std::string_view name) {
  std::string camel;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] == '-' && i + 1 < name.size() && name[i + 1] >= 'a' && name[i + 1] <= 'z')
      camel += static_cast<char>(name[++i] - 'a' + 'A');
    else
      camel += name[i];
  for (std::size_t i = 0; i < enumCount<E>; ++i)
    if (enumNames<E>[i] == camel) return static_cast<E>(i);
  return std::nullopt;
}

/// An array with one entry for each value of an enumeration.
template <typename E, typename T>
struct EnumArray {
  std::array<T, enumCount<E>> values{};

  constexpr T& operator[](E e) { return values[static_cast<std::size_t>(e)]; }
  constexpr const T& operator[](E e) const { return values[static_cast<std::size_t>(e)]; }
  constexpr auto begin() { return values.begin(); }
  constexpr auto begin() const { return values.begin(); }
  constexpr auto end() { return values.end(); }
  constexpr auto end() const { return values.end(); }
  static constexpr std::size_t size() { return enumCount<E>; }
};

}  // namespace gt
