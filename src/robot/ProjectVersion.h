#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "base/Hash.h"

namespace gt {

/// The files of a folder and of the folders in it, in order.
Result<std::vector<std::filesystem::path>> filesBelow(const std::string& folder);
/// Adds all files of a folder to a fingerprint, with their names in it.
Result<void> addFiles(const std::string& folder, Fingerprint& sum);
/// As 16 hexadecimal digits.
std::string digitsOf(const Fingerprint& sum);

/// What each job depends on but its parameters: the commit of the program, and a fingerprint of the
/// root's files as they are now, which may have been edited since; COMMIT+FINGERPRINT.
Result<std::string> projectVersion(const DataRoot& root);

}  // namespace gt
