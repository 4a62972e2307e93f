#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gt {

/// FNV-1a with 64 bits, over any bytes.
class Fingerprint {
 public:
  constexpr void add(std::string_view text) {
    for (const char c : text) add(static_cast<unsigned char>(c));
  }
  void add(double number) { addBytes(&number, sizeof number); }
  void add(const double* numbers, std::size_t count) { addBytes(numbers, count * sizeof *numbers); }
  void addBytes(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) add(bytes[i]);
  }
  constexpr std::uint64_t value() const { return sum_; }

 private:
  constexpr void add(unsigned char byte) { sum_ = (sum_ ^ byte) * 0x100000001b3; }

  std::uint64_t sum_ = 0xcbf29ce484222325;
};

/// FNV-1a with 32 bits, for the ids of types and the versions of schemas.
constexpr std::uint32_t hashOf(std::string_view text, std::uint32_t hash = 0x811c9dc5) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
  return hash;
}

}  // namespace gt
