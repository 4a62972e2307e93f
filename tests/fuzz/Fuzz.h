#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

/// What each fuzz target defines: reads bytes from outside as the programs would. It must neither
/// crash nor hang, whatever they are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace gt {

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace gt
