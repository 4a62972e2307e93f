#pragma once
#include <string>

namespace gt {

/// What is wrong, with the column of its place: an Error has a line only, so the column is said
/// with what is wrong. `Error::text()` prints it where places have it: `file:line:column: `.
std::string withColumn(const std::string& what, int column);

}  // namespace gt
