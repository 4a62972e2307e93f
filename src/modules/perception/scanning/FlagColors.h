#pragma once
#include <array>
#include <optional>

#include "representations/perception/ColorTable64.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// The two colors of a flag; one of them is pink.
struct FlagColors {
  ColorClass upper, lower;

  bool pinkIsAbove() const { return upper == ColorClass::pink; }
  ColorClass other() const { return pinkIsAbove() ? lower : upper; }
  constexpr bool operator==(const FlagColors&) const = default;
};

/// The colors of all flags, in the order of FlagType.
inline constexpr std::array flagColors{FlagColors{ColorClass::pink, ColorClass::yellow},
                                       FlagColors{ColorClass::pink, ColorClass::green},
                                       FlagColors{ColorClass::pink, ColorClass::skyblue},
                                       FlagColors{ColorClass::yellow, ColorClass::pink},
                                       FlagColors{ColorClass::green, ColorClass::pink},
                                       FlagColors{ColorClass::skyblue, ColorClass::pink}};

constexpr FlagColors colorsOf(FlagType type) {
  return flagColors[static_cast<std::size_t>(type)];
}

/// The type of the flag with these colors; nothing if no flag has them.
constexpr std::optional<FlagType> flagOf(FlagColors colors) {
  for (std::size_t i = 0; i < flagColors.size(); ++i)
    if (flagColors[i] == colors) return static_cast<FlagType>(i);
  return std::nullopt;
}
static_assert(flagOf({ColorClass::green, ColorClass::pink}) == FlagType::greenAbovePink);

}  // namespace gt
