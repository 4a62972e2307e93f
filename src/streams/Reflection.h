#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/Hash.h"
#include "streams/Unit.h"

namespace gt {

/// The range of a field's values, both limits included; low == high means unlimited.
struct Range {
  double low = 0, high = 0;

  constexpr bool bounds() const { return low < high; }
};

/// The description of a field. It must be understandable by itself, because tools show it without
/// the other fields. A sentence that is empty, or that begins by referring to another field, does
/// not compile.
struct Sentence {
  // NOLINTNEXTLINE(google-explicit-constructor): a text is meant to become a sentence.
  consteval Sentence(const char* words) : text{words, __builtin_strlen(words)} {
    if (text.empty() || text.front() == ' ' || text.back() == ' ') throw "a sentence without words";
    for (const std::string_view leaning : {"likewise", "the same", "ditto", "as above", "as before",
                                           "if it does", "of its ", "of it ", "its "})
      if (text.front() == leaning.front() && text.starts_with(leaning))
        throw "a sentence that leans on another field's";
  }

  std::string_view text;
};

/// One field of a struct: its member, name, unit, description and range.
template <typename Class, typename Type>
struct Field {
  std::string_view name;
  Type Class::*member;
  std::string_view unit;
  std::string_view doc;
  Range range;

  /// The same field under another name than the member's.
  constexpr Field named(std::string_view other) const { return {other, member, unit, doc, range}; }
};

/// The name of the member that a pointer refers to, without the underscore of a private one.
template <auto member>
constexpr auto memberName() {
  // The compiler's text ends with the name and a bracket. Optimized for compile time, as there are
  // more than a thousand fields.
  constexpr std::string_view s{__PRETTY_FUNCTION__, sizeof __PRETTY_FUNCTION__ - 1};
  const std::size_t end = s.size() - 1;
  std::size_t begin = end;
  while (s[begin - 1] != ':') --begin;
  return s.substr(begin, end - begin - (s[end - 1] == '_' ? 1 : 0));
}

namespace detail {
template <typename Member>
struct FieldOfMember;
template <typename Class, typename T>
struct FieldOfMember<T Class::*> {
  using Type = Field<Class, T>;
};
}  // namespace detail
template <auto member>
using FieldOf = typename detail::FieldOfMember<decltype(member)>::Type;

/// Declares a field in a struct's `fields()`. All streams, schemas, JSON and live parameters are
/// derived from that list.
template <auto member>
constexpr FieldOf<member> field(Unit unit, Sentence doc, Range range = {}) {
  return {memberName<member>(), member, unitText(unit), doc.text, range};
}
template <auto member>
constexpr FieldOf<member> field(Sentence doc, Range range = {}) {
  return {memberName<member>(), member, "", doc.text, range};
}
/// For a field whose name is sufficient as a description.
template <auto member>
constexpr FieldOf<member> field(Unit unit, Range range = {}) {
  return {memberName<member>(), member, unitText(unit), "", range};
}
template <auto member>
constexpr FieldOf<member> field(Range range = {}) {
  return {memberName<member>(), member, "", "", range};
}

namespace detail {

template <std::size_t i, typename F>
struct FieldSlot {
  F value;
};
template <std::size_t i, typename F>
constexpr const F& fieldAt(const FieldSlot<i, F>& slot) {
  return slot.value;
}

template <typename Indices, typename... F>
struct FieldSlots;
template <std::size_t... i, typename... F>
struct FieldSlots<std::index_sequence<i...>, F...> : FieldSlot<i, F>... {
  constexpr FieldSlots(F... fields) : FieldSlot<i, F>{fields}... {}

  template <typename Visit>
  constexpr void forEach(Visit&& visit) const {
    (visit(fieldAt<i>(*this)), ...);
  }
};

}  // namespace detail

/// The result of `fields()`: the fields of a struct, in the order of declaration. Replaces
/// std::tuple, which takes half of the compile time of files with many representations.
template <typename... F>
struct Fields : detail::FieldSlots<std::index_sequence_for<F...>, F...> {
  static constexpr std::size_t count = sizeof...(F);

  constexpr Fields(F... fields)
      : detail::FieldSlots<std::index_sequence_for<F...>, F...>(fields...) {}

  template <std::size_t i>
  constexpr const auto& at() const {
    return detail::fieldAt<i>(*this);
  }
};

/// Appends the fields of a derived struct to those of its base.
template <typename... A, typename... B>
constexpr Fields<A..., B...> operator+(const Fields<A...>& base, const Fields<B...>& own) {
  return [&]<std::size_t... i, std::size_t... j>(std::index_sequence<i...>,
                                                 std::index_sequence<j...>) {
    return Fields<A..., B...>{base.template at<i>()..., own.template at<j>()...};
  }
  (std::index_sequence_for<A...>{}, std::index_sequence_for<B...>{});
}

/// A struct that declares its fields.
template <typename T>
concept Reflected = requires {
  T::fields();
};

namespace detail {

struct AnyValue {
  template <typename T>
  operator T() const;
};
/// Whether a T can be initialized by braces around this number of values.
template <typename T, std::size_t... i>
constexpr bool takes(std::index_sequence<i...>) {
  return requires {
    T{(static_cast<void>(i), AnyValue{})...};
  };
}
/// Whether an aggregate has at least this number of members. Checked for two numbers only, as the
/// compiler searches a conversion to each member.
template <typename T, std::size_t count>
constexpr bool hasMembers = takes<T>(std::make_index_sequence<count>{});

template <typename T>
constexpr bool namesAreDistinct() {
  std::array<std::string_view, decltype(T::fields())::count + 1> names;
  std::size_t count = 0;
  T::fields().forEach([&](const auto& field) { names[count++] = field.name; });
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (names[i] == names[j]) return false;
  return true;
}

template <typename T>
constexpr bool membersAreDistinct() {
  std::size_t same = 0;
  T::fields().forEach([&](const auto& a) {
    T::fields().forEach([&](const auto& b) {
      if constexpr (std::is_same_v<decltype(a), decltype(b)>) same += a.member == b.member;
    });
  });
  return same == decltype(T::fields())::count;
}

/// Does not compile for a struct whose `fields()` differ from its members; the compiler's next
/// lines name the struct.
template <typename T>
struct CheckedFields {
  static constexpr std::size_t count = decltype(T::fields())::count;
  // The members of a class with private ones cannot be counted.
  static_assert(!std::is_aggregate_v<T> || !hasMembers<T, count + 1>,
                "fields() of a struct leaves out one of its members");
  static_assert(!std::is_aggregate_v<T> || hasMembers<T, count>,
                "fields() of a struct has more entries than the struct has members");
  static_assert(namesAreDistinct<T>(), "fields() of a struct gives two of them the same name");
  static_assert(membersAreDistinct<T>(), "fields() of a struct lists a member twice");
  static constexpr bool value = true;
};

}  // namespace detail

/// Whether `fields()` names every member of an aggregate exactly once. Checked automatically for
/// everything that is streamed: a forgotten field does not compile. Of classes with private members
/// or constructors only that no name and no member comes twice.
template <typename T>
constexpr bool complete = detail::hasMembers<T, decltype(T::fields())::count> &&
                          !detail::hasMembers<T, decltype(T::fields())::count + 1> &&
                          detail::namesAreDistinct<T>() && detail::membersAreDistinct<T>();

/// Calls visit(field, member) for each field, in the order of declaration.
template <typename T, typename Visit>
requires Reflected<std::remove_const_t<T>>
constexpr void forEachField(T& object, Visit&& visit) {
  std::remove_const_t<T>::fields().forEach(
      [&](const auto& field) { visit(field, object.*field.member); });
}

/// A type's name as the compiler spells it, with its namespaces.
template <typename T>
constexpr std::string_view qualifiedName() {
  std::string_view s = __PRETTY_FUNCTION__;
  const auto begin = s.find("T = ") + 4;
  return s.substr(begin, s.find_first_of(";]", begin) - begin);
}

/// A type's name without its namespaces, as it stands in logs, layouts and messages.
template <typename T>
constexpr std::string_view typeName() {
  constexpr std::string_view s = qualifiedName<T>();
  const auto colon = s.rfind("::", s.find('<'));
  return colon == s.npos ? s : s.substr(colon + 2);
}

}  // namespace gt
