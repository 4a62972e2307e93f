#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace xabsl {

/// Files held in memory: text by path. Includes are looked up relative to the including file, as on
/// disk.
using VirtualFiles = std::map<std::string, std::string>;

/// Stores the text of a file in its last argument. Returns the reason if it fails.
using FileReader =
    std::function<std::optional<std::string>(const std::string& path, std::string& text)>;

/// Reads from files in memory, which must outlive the reader.
FileReader readerOf(const VirtualFiles& files);

/// Reads from disk.
FileReader diskReader();

}  // namespace xabsl
