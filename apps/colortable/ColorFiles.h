#pragma once
#include <string>

#include "colors/ColorStatistics.h"
#include "colors/ColorTableFile.h"

namespace gt {

/// The table of a file by its extension: `.c64` as it is, `.hsi` and `.tsl` converted.
Result<ColorTable64> readColors(const std::string& file, ColorClassOrder order);

/// Writes a table to a `.c64` file.
Result<void> writeColors(const std::string& file, const ColorTable64& table);

/// How colors are learnt.
struct Learning {
  int growth = 4;        ///< Steps into colors never seen, of tables.
  double share = 0.995;  ///< Of a class's pixels that shall lie in each range, of HSI and TSL.
};

/// Writes what was learnt in the form given by the file's extension, and returns it as a table.
Result<ColorTable64> writeLearnt(const std::string& file, const ColorStatistics& statistics,
                                 const Learning& learning);

}  // namespace gt
