#include "colors/ColorTableFile.h"

#include <cstdint>

#include "base/File.h"

namespace gt {
namespace {

std::int32_t lengthAt(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[offset + i])) << (8 * i);
  return static_cast<std::int32_t>(value);
}

void appendLength(std::string& bytes, std::size_t length) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<char>(length >> shift & 0xff));
}

}  // namespace

Result<ColorTable64> parseColorTable(std::string_view bytes, const std::string& file,
                                     ColorClassOrder order) {
  ColorTable64 table;
  std::size_t filled = 0;
  std::size_t offset = 0;
  const auto wrong = [&](std::string what) {
    return Error{.file = file, .field = "byte " + std::to_string(offset), .what = std::move(what)};
  };
  for (;;) {
    if (bytes.size() - offset < 4) return wrong("the file ends within the length of a run");
    const std::int32_t length = lengthAt(bytes, offset);
    if (length == 0) break;
    if (bytes.size() - offset < 5) return wrong("the file ends before the class of a run");
    const std::size_t left = table.classes.size() - filled;
    if (length < 0 || static_cast<std::size_t>(length) > left)
      return wrong("a run of " + std::to_string(length) + " colors where " + std::to_string(left) +
                   " are left");
    const auto number = static_cast<unsigned char>(bytes[offset + 4]);
    if (number >= order.size())
      return wrong("unknown color class " + std::to_string(number) + ", the last one is " +
                   std::to_string(order.size() - 1));
    std::fill_n(table.classes.begin() + static_cast<std::ptrdiff_t>(filled), length, order[number]);
    filled += static_cast<std::size_t>(length);
    offset += 5;
  }
  if (filled != table.classes.size())
    return wrong("the table ends after " + std::to_string(filled) + " colors of " +
                 std::to_string(table.classes.size()));
  offset += 4;
  if (offset != bytes.size()) return wrong("something follows the end of the table");
  return table;
}

Result<ColorTable64> readColorTable(const std::string& file, ColorClassOrder order) {
  const auto bytes = readFile(file);
  return bytes ? parseColorTable(*bytes, file, order) : bytes.error();
}

std::string colorTableBytes(const ColorTable64& table) {
  std::string bytes;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= table.classes.size(); ++i) {
    if (i < table.classes.size() && table.classes[i] == table.classes[begin]) continue;
    appendLength(bytes, i - begin);
    bytes.push_back(static_cast<char>(table.classes[begin]));
    begin = i;
  }
  appendLength(bytes, 0);
  return bytes;
}

}  // namespace gt
