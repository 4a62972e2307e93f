#pragma once
#include <filesystem>

#include "base/Result.h"

namespace gt {

/// Makes a folder with links to the files of another one, or adds them to it; a link replaces what
/// has its name. Folders within are real: paths such as ../config lead from one to another. `from`
/// must be absolute.
Result<void> linkFiles(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace gt
