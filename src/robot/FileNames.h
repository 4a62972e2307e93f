#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "base/Result.h"

namespace gt {

/// Replaces each path below a folder in an error, also in its texts, by the result of `nameOf`.
/// Used for temporary folders, whose files stand for others and will be deleted.
Error withFileNames(Error error, const std::filesystem::path& folder,
                    const std::function<std::string(const std::string& path)>& nameOf);

}  // namespace gt
