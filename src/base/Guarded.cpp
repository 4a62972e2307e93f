#include "base/Guarded.h"

#include <filesystem>
#include <new>

namespace gt {

Error errorOf(const std::exception& exception) {
  if (dynamic_cast<const std::bad_alloc*>(&exception)) return {.what = "not enough memory"};
  const auto* ofFile = dynamic_cast<const std::filesystem::filesystem_error*>(&exception);
  if (ofFile && !ofFile->path1().empty())
    return {.file = ofFile->path1().string(), .what = ofFile->code().message()};
  return {.field = "exception", .what = exception.what()};
}

}  // namespace gt
