#pragma once
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace gt {

/// Parses the whole text as a number. Empty if the text is not a number, or if the number is too
/// large for the type. The base is used for whole numbers only.
template <typename N>
std::optional<N> numberFrom(std::string_view text, int base = 10) {
  N number{};
  const char* const end = text.data() + text.size();
  std::from_chars_result result;
  if constexpr (std::is_integral_v<N>)
    result = std::from_chars(text.data(), end, number, base);
  else
    result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc{} && result.ptr == end ? std::optional{number} : std::nullopt;
}

/// The shortest text that is parsed as the same number.
template <typename N>
std::string numberText(N number) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

}  // namespace gt
