#pragma once
#include <string>
#include <string_view>

#include "base/Result.h"

namespace gt {

/// The whole content of a regular file of at most 1 GiB.
Result<std::string> readFile(const std::string& path);

/// Writes a file, whole or not at all: under another name first, then renamed.
Result<void> writeFile(const std::string& path, std::string_view content);

}  // namespace gt
