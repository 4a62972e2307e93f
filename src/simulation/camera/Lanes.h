#pragma once
#include <cstdint>
#include <cstring>

namespace gt {

/// Four numbers that are computed at once.
constexpr int lanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));
using Shorts = std::uint16_t __attribute__((vector_size(16)));
using Bytes = std::uint8_t __attribute__((vector_size(16)));

inline Floats all(float value) {
  return Floats{value, value, value, value};
}
template <typename V, typename T>
V load(const T* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <typename V, typename T>
void store(T* to, V v) {
  std::memcpy(to, &v, sizeof v);
}

/// As std::min and std::max, in each lane.
inline Floats least(Floats a, Floats b) {
  return b < a ? b : a;
}
inline Floats most(Floats a, Floats b) {
  return a < b ? b : a;
}

/// The first halves of both in turns: a[0], b[0], a[1], ...
inline Bytes firstPairs(Bytes a, Bytes b) {
  return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}
inline Shorts firstPairs(Shorts a, Shorts b) {
  return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
}
/// The last halves of both in turns.
inline Bytes lastPairs(Bytes a, Bytes b) {
  return __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15,
                                 31);
}
inline Shorts lastPairs(Shorts a, Shorts b) {
  return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
}

}  // namespace gt
