#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

#include "xabsl/language/Language.h"

namespace xabsl {

/// A C++ variable that the engine reads without a call.
struct Variable {
  enum class Kind { none, number, single, boolean, byte, integer };

  Kind kind = Kind::none;  ///< none: no variable, or one of another type
  const void* address = nullptr;
};

/// A C++ function as the engine calls it: arguments and result are numbers.
struct Function {
  double (*call)(void* object, const double* arguments) = nullptr;
  std::shared_ptr<void> object;
  Variable variable = {};  ///< read instead of the call, if it is a variable
};

template <typename T>
Variable variableOf(const T* variable) {
  using Kind = Variable::Kind;
  if constexpr (std::is_enum_v<T>)
    return {variableOf(static_cast<const std::underlying_type_t<T>*>(nullptr)).kind, variable};
  else if constexpr (std::is_same_v<T, double>)
    return {Kind::number, variable};
  else if constexpr (std::is_same_v<T, float>)
    return {Kind::single, variable};
  else if constexpr (std::is_same_v<T, bool>)
    return {Kind::boolean, variable};
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return {Kind::byte, variable};
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return {Kind::integer, variable};
  else
    return {};
}

/// The XABSL type of a C++ type. An enumeration is identified by its C++ type, or by its name if
/// values are plain indices.
struct RegisteredType {
  ValueKind kind = ValueKind::number;
  std::type_index type = typeid(double);
  std::string enumeration;
};

template <typename T>
RegisteredType registeredType() {
  using Value = std::remove_cv_t<std::remove_reference_t<T>>;
  static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>,
                "XABSL knows numbers, bool and enumerations");
  if constexpr (std::is_same_v<Value, bool>)
    return {ValueKind::boolean, typeid(bool), {}};
  else if constexpr (std::is_enum_v<Value>)
    return {ValueKind::enumeration, typeid(Value), {}};
  else
    return {ValueKind::number, typeid(double), {}};
}

/// Converts a number of the engine to a C++ value. Integers are limited to their range, so that no
/// number causes undefined behavior.
template <typename T>
T fromNumber(double number) {
  if constexpr (std::is_same_v<T, bool>) {
    return number != 0;
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(fromNumber<std::underlying_type_t<T>>(number));
  } else if constexpr (std::is_integral_v<T>) {
    constexpr double low = static_cast<double>(std::numeric_limits<T>::min());
    constexpr double high = static_cast<double>(std::numeric_limits<T>::max());
    if (std::isnan(number)) return 0;
    if (number <= low) return std::numeric_limits<T>::min();
    if (number >= high) return std::numeric_limits<T>::max();
    return static_cast<T>(number);
  } else {
    return static_cast<T>(number);
  }
}

/// Result and arguments of a callable without overloads.
template <typename Callable>
struct Signature : Signature<decltype(&Callable::operator())> {};

template <typename R, typename... A>
struct Signature<R (*)(A...)> {
  using Result = R;
  using Arguments = std::tuple<std::remove_cv_t<std::remove_reference_t<A>>...>;
};

template <typename R, typename... A>
struct Signature<R (*)(A...) noexcept> : Signature<R (*)(A...)> {};
template <typename C, typename R, typename... A>
struct Signature<R (C::*)(A...)> : Signature<R (*)(A...)> {};
template <typename C, typename R, typename... A>
struct Signature<R (C::*)(A...) const> : Signature<R (*)(A...)> {};
template <typename C, typename R, typename... A>
struct Signature<R (C::*)(A...) noexcept> : Signature<R (*)(A...)> {};
template <typename C, typename R, typename... A>
struct Signature<R (C::*)(A...) const noexcept> : Signature<R (*)(A...)> {};

template <typename Callable>
using ResultOf = typename Signature<Callable>::Result;
template <typename Callable>
using ArgumentsOf = typename Signature<Callable>::Arguments;

/// The types of the arguments, in their order.
template <typename Callable>
std::vector<RegisteredType> argumentTypes() {
  return []<typename... A>(std::type_identity<std::tuple<A...>>) {
    return std::vector<RegisteredType>{registeredType<A>()...};
  }(std::type_identity<ArgumentsOf<Callable>>());
}

/// Wraps a callable: one indirect call, into which the callable itself is inlined.
template <typename Callable>
Function makeFunction(Callable callable) {
  const auto call = [](void* object, const double* arguments) -> double {
    Callable& target = *static_cast<Callable*>(object);
    return [&]<std::size_t... I>(std::index_sequence<I...>)->double {
      (void)arguments;  // unused where there are none
      if constexpr (std::is_void_v<ResultOf<Callable>>) {
        target(fromNumber<std::tuple_element_t<I, ArgumentsOf<Callable>>>(arguments[I])...);
        return 0;
      } else {
        return static_cast<double>(
            target(fromNumber<std::tuple_element_t<I, ArgumentsOf<Callable>>>(arguments[I])...));
      }
    }
    (std::make_index_sequence<std::tuple_size_v<ArgumentsOf<Callable>>>());
  };
  return {call, std::make_shared<Callable>(std::move(callable))};
}

/// A parameter of a basic behavior that is a class: a member with its name in XABSL.
template <typename Class, typename T>
struct MemberParameter {
  const char* name;
  T Class::*member;
};

template <typename Class, typename T>
constexpr MemberParameter<Class, T> parameter(const char* name, T Class::*member) {
  return {name, member};
}

/// A class whose objects are basic behaviors (report H.5): `name` is the name in XABSL,
/// `parameters()` a tuple of results of parameter(), in any order. `execute()` is called in each
/// cycle that executes the basic behavior, with the parameters in the members.
/// `parametersChanged()`, if the class has it, is called before, if a parameter has changed since
/// the last call.
template <typename T>
concept BehaviorClass = requires(T& behavior) {
  {T::name};
  T::parameters();
  behavior.execute();
};

template <BehaviorClass Class>
void takeParameters(Class& behavior, const double* arguments) {
  std::apply(
      [&]<typename... P>(const P&... parameter) {
        ((behavior.*parameter.member =
              fromNumber<std::remove_reference_t<decltype(behavior.*parameter.member)>>(
                  *arguments++)),
         ...);
      },
      Class::parameters());
}

/// A member function of an object as a callable: `member(&ball, &Ball::distance)`. The object must
/// outlive engines.
template <typename Object, typename C, typename R, typename... A>
auto member(Object* object, R (C::*function)(A...)) {
  return [object, function](A... arguments) -> R { return (object->*function)(arguments...); };
}
template <typename Object, typename C, typename R, typename... A>
auto member(const Object* object, R (C::*function)(A...) const) {
  return [object, function](A... arguments) -> R { return (object->*function)(arguments...); };
}

}  // namespace xabsl
