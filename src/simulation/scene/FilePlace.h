#pragma once
#include <string>

#include "base/Result.h"

namespace gt {

/// A place in a file, from 1; column 0 if only the line is known.
struct FilePlace {
  int line = 0;
  int column = 0;
};

/// An error at a place in a file.
inline Error errorAt(const std::string& file, const FilePlace& place, const std::string& field,
                     const std::string& what) {
  return {.file = file, .line = place.line, .column = place.column, .field = field, .what = what};
}

}  // namespace gt
