#pragma once

#include <string>

namespace xabsl::server {

/// The path of a file's URI, without its escapes; what is none stays, but for its dots and slashes:
/// the same for all spellings of a place.
std::string pathOf(const std::string& uri);

/// The URI of a file.
std::string fileUri(const std::string& path);

}  // namespace xabsl::server
