#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace gt {
namespace detail {

/// Some values of an enumeration as the compiler spells them: enumerators by name, others as casts.
template <typename E, E... values>
constexpr std::string_view spelledValues() {
  return __PRETTY_FUNCTION__;
}

/// Position at which the value ends that begins at `at` in such a list.
constexpr std::size_t spelledEnd(std::string_view list, std::size_t at) {
  for (int depth = 0; at < list.size(); ++at) {
    const char c = list[at];
    if (depth == 0 && (c == ',' || c == '}' || c == '>')) return at;
    depth += c == '<' || c == '(' ? 1 : c == '>' || c == ')' ? -1 : 0;
  }
  return at;
}

/// The enumerators among the values 0 to 256, and -1, of an enumeration.
struct Enumerators {
  std::size_t count = 0;
  bool countable = true;  ///< Whether the values are 0, 1, 2, ... without gaps.
};

template <std::size_t most>
constexpr Enumerators findEnumerators(std::string_view list) {
  constexpr std::string_view begin = "values = ";
  Enumerators found;
  std::size_t at = list.find(begin) + begin.size() + 1;
  const auto isNamed = [&] { return list[at] != '(' || list.substr(at, 4) == "(ano"; };
  std::size_t cast = 0;
  for (std::size_t i = 0; i <= most; ++i) {
    const std::size_t digits = i < 10 ? 1 : i < 100 ? 2 : 3;
    if (isNamed()) {
      if (found.count++ != i) found.countable = false;
      at = spelledEnd(list, at) + 2;
    } else {
      // All casts are of one length but for their digits, so most of the list is skipped.
      if (cast == 0) cast = spelledEnd(list, at) - at - digits;
      at += cast + digits + 2;
    }
  }
  if (isNamed() || found.count > 256) found.countable = false;
  return found;
}

template <typename E>
struct EnumFacts {
  static constexpr std::size_t most = std::min<std::size_t>(
      256, static_cast<std::size_t>(std::numeric_limits<std::underlying_type_t<E>>::max()));
  static constexpr auto make = []<std::size_t... i>(std::index_sequence<i...>) {
    return findEnumerators<most>(
        spelledValues<E, static_cast<E>(i)...,
                      static_cast<E>(std::is_signed_v<std::underlying_type_t<E>> ? -1 : most)>());
  };
  static constexpr Enumerators all = make(std::make_index_sequence<most + 1>{});
  static_assert(all.countable,
                "the enumerators of a streamed enumeration count from 0 without gaps, and are not "
                "more than 256");
};

template <auto value>
constexpr std::string_view enumeratorName() {
  constexpr std::string_view begin = "value = ";
  std::string_view s = __PRETTY_FUNCTION__;
  s.remove_prefix(s.find(begin) + begin.size());
  s = s.substr(0, s.find_first_of(";]"));
  return s.substr(s.rfind(':') + 1);
}

template <typename E, std::size_t... i>
constexpr auto enumeratorNames(std::index_sequence<i...>) {
  return std::array<std::string_view, sizeof...(i)>{enumeratorName<static_cast<E>(i)>()...};
}

}  // namespace detail

/// Number of enumerators of an enumeration. Their values must count from 0 without gaps; otherwise
/// it does not compile.
template <typename E>
constexpr std::size_t enumCount = detail::EnumFacts<E>::all.count;

/// The names of an enumeration's values, in order.
template <typename E>
constexpr auto enumNames = detail::enumeratorNames<E>(std::make_index_sequence<enumCount<E>>{});

/// The name of a value; "?" for a number that no enumerator has.
template <typename E>
requires std::is_enum_v<E>
constexpr std::string_view enumName(E value) {
  const auto i = static_cast<std::size_t>(value);
  return i < enumCount<E> ? enumNames<E>[i] : "?";
}

/// Returns the value with this name; empty if there is none. Names may also be written as in the
/// report: search-for-ball is searchForBall.
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
