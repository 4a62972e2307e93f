#pragma once
#include <filesystem>

#include "base/Result.h"

namespace gt {

/// Fills a folder with symbolic links to the files of another one. The folder is created if it does
/// not exist; a link replaces a file of the same name. Subfolders are created as real folders, so
/// that paths such as ../config work. `from` must be absolute.
Result<void> linkFiles(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace gt
