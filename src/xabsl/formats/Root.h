#pragma once

#include <functional>
#include <string>
#include <vector>

#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// Lists the sources in a folder, .xabsl and .xml.
using FolderLister = std::function<std::vector<std::string>(const std::string& folder)>;

/// Lists the sources in a folder on disk, in the order of their names.
FolderLister diskLister();

/// Returns the file with the agents that includes a file: beside it or in a folder above, up to the
/// folder `last`. Empty if no file with agents includes it.
std::string rootOf(const std::string& path, const FolderLister& sources, const FileReader& read,
                   const std::string& last = {});

}  // namespace xabsl
