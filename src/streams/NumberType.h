#pragma once
#include <type_traits>

#include "streams/Type.h"

namespace gt {

/// Calls visit with the C++ type of a number, as a std::type_identity.
template <typename Visit>
decltype(auto) withType(Number number, Visit&& visit) {
  switch (number) {
    case Number::int8:
      return visit(std::type_identity<std::int8_t>{});
    case Number::uint8:
      return visit(std::type_identity<std::uint8_t>{});
    case Number::int16:
      return visit(std::type_identity<std::int16_t>{});
    case Number::uint16:
      return visit(std::type_identity<std::uint16_t>{});
    case Number::int32:
      return visit(std::type_identity<std::int32_t>{});
    case Number::uint32:
      return visit(std::type_identity<std::uint32_t>{});
    case Number::int64:
      return visit(std::type_identity<std::int64_t>{});
    case Number::uint64:
      return visit(std::type_identity<std::uint64_t>{});
    case Number::float32:
      return visit(std::type_identity<float>{});
    case Number::float64:
      break;
  }
  return visit(std::type_identity<double>{});
}

}  // namespace gt
