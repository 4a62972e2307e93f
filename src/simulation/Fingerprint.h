#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>

namespace gt {

/// A hash of the bits of numbers, in the order in which they are added (FNV-1a).
class Fingerprint {
 public:
  void add(double number) {
    auto bits = std::bit_cast<std::uint64_t>(number);
    for (int i = 0; i < 8; ++i, bits >>= 8) sum_ = (sum_ ^ (bits & 0xff)) * 0x100000001b3;
  }
  void add(const double* numbers, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(numbers[i]);
  }
  std::uint64_t value() const { return sum_; }
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325;
};

}  // namespace gt
