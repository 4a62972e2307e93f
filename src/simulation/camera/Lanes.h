#pragma once
#include <cstdint>
#include <cstring>

namespace gt {

/// Four numbers that are computed at once.
constexpr int lanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

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

}  // namespace gt
