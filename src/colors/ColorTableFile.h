#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "base/Result.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// The class of each class number in a file.
using ColorClassOrder = std::span<const ColorClass>;

/// The order of the report's files (report B.4.2).
inline constexpr std::array gt2003ColorOrder{
    ColorClass::noColor, ColorClass::orange, ColorClass::yellow, ColorClass::skyblue,
    ColorClass::pink,    ColorClass::red,    ColorClass::blue,   ColorClass::green,
    ColorClass::gray,    ColorClass::white,  ColorClass::black};

/// The order of a real robot's files of 2009 (facts, 3).
inline constexpr std::array nao2009ColorOrder{
    ColorClass::noColor, ColorClass::orange, ColorClass::yellow,
    ColorClass::skyblue, ColorClass::white,  ColorClass::green,
    ColorClass::black,   ColorClass::red,    ColorClass::blue};

/// Decodes a color table from the bytes of a `.c64` file (report B.4.2): runs of a little endian
/// length and a class, terminated by the length 0. Errors state the offset of the run.
Result<ColorTable64> parseColorTable(std::string_view bytes, const std::string& file,
                                     ColorClassOrder order = gt2003ColorOrder);

/// Reads a `.c64` file (report B.4.2).
Result<ColorTable64> readColorTable(const std::string& file,
                                    ColorClassOrder order = gt2003ColorOrder);

/// Encodes a color table as a `.c64` file in the report's order (report B.4.2).
std::string colorTableBytes(const ColorTable64& table);

}  // namespace gt
