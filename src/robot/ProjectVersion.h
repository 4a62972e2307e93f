#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "base/Hash.h"

namespace gt {

/// Returns the files of a folder and of its subfolders, sorted.
Result<std::vector<std::filesystem::path>> filesBelow(const std::string& folder);
/// Adds all files of a folder, with their names, to a fingerprint.
Result<void> addFiles(const std::string& folder, Fingerprint& sum);
/// Formats a fingerprint as 16 hexadecimal digits.
std::string digitsOf(const Fingerprint& sum);

/// The version that each job depends on besides its parameters: COMMIT+FINGERPRINT. This is the
/// commit of the program, and a fingerprint of the root's present files, which may have been edited
/// since.
Result<std::string> projectVersion(const DataRoot& root);

}  // namespace gt
