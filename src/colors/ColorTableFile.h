#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "base/Result.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// Which class each class number of a file means.
using ColorClassOrder = std::span<const ColorClass>;

/// The order of the report's files (report B.4.2).
inline constexpr std::array gt2003ColorOrder{
    ColorClass::noColor, ColorClass::orange, ColorClass::yellow, ColorClass::skyblue,
    ColorClass::pink,    ColorClass::red,    ColorClass::blue,   ColorClass::green,
    ColorClass::gray,    ColorClass::white,  ColorClass::black};

/// The order of the real robot's files of 2009 (facts, 3).
inline constexpr std::array nao2009ColorOrder{
    ColorClass::noColor, ColorClass::orange, ColorClass::yellow,
    ColorClass::skyblue, ColorClass::white,  ColorClass::green,
    ColorClass::black,   ColorClass::red,    ColorClass::blue};

/// The color table in the bytes of a `.c64` file (report B.4.2): runs of a little endian length
/// and a class, ended by the length 0. Errors name the offset of the run concerned.
Result<ColorTable64> parseColorTable(std::string_view bytes, const std::string& file,
                                     ColorClassOrder order = gt2003ColorOrder);

/// Reads a `.c64` file (report B.4.2).
Result<ColorTable64> readColorTable(const std::string& file,
                                    ColorClassOrder order = gt2003ColorOrder);

/// The bytes of a `.c64` file in the report's order (report B.4.2).
std::string colorTableBytes(const ColorTable64& table);

}  // namespace gt
