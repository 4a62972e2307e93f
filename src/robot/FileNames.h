#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "base/Result.h"

namespace gt {

/// Replaces each path below a folder that an error holds, in its texts, too, by what `nameOf`
/// returns for it: files of a temporary folder stand for others, and soon are gone.
Error withFileNames(Error error, const std::filesystem::path& folder,
                    const std::function<std::string(const std::string& path)>& nameOf);

}  // namespace gt
