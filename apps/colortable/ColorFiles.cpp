#include "colortable/ColorFiles.h"

#include <filesystem>

#include "base/File.h"

namespace gt {
namespace {

std::string extensionOf(const std::string& file) {
  return std::filesystem::path{file}.extension().string();
}

Error unknownForm(const std::string& file) {
  return {.file = file, .what = "expected a name that ends with .c64, .hsi or .tsl"};
}

}  // namespace

Result<ColorTable64> readColors(const std::string& file, ColorClassOrder order) {
  const std::string extension = extensionOf(file);
  if (extension == ".c64") return readColorTable(file, order);
  if (extension == ".hsi") {
    const auto colors = readHsiColors(file);
    if (!colors) return colors.error();
    return colors->table();
  }
  if (extension == ".tsl") {
    const auto colors = readTslColors(file);
    if (!colors) return colors.error();
    return colors->table();
  }
  return unknownForm(file);
}

Result<void> writeColors(const std::string& file, const ColorTable64& table) {
  if (extensionOf(file) != ".c64")
    return Error{.file = file, .what = "a table is written to a file whose name ends with .c64"};
  return writeFile(file, colorTableBytes(table));
}

Result<ColorTable64> writeLearnt(const std::string& file, const ColorStatistics& statistics,
                                 const Learning& learning) {
  const auto written = [&](const ColorTable64& table,
                           const std::string& content) -> Result<ColorTable64> {
    if (auto done = writeFile(file, content); !done) return done.error();
    return table;
  };
  const std::string extension = extensionOf(file);
  if (extension == ".c64") {
    const ColorTable64 table = statistics.table(learning.growth);
    return written(table, colorTableBytes(table));
  }
  if (extension == ".hsi") {
    const HsiColors colors = statistics.hsi(learning.share);
    return written(colors.table(), hsiText(colors));
  }
  if (extension == ".tsl") {
    const TslColors colors = statistics.tsl(learning.share);
    return written(colors.table(), tslText(colors));
  }
  return unknownForm(file);
}

}  // namespace gt
