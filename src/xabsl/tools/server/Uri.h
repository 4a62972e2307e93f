#pragma once

#include <string>

namespace xabsl::server {

/// The path of a file's URI, without escapes and normalized, so that all spellings of a place are
/// equal. A text that is no URI is only normalized.
std::string pathOf(const std::string& uri);

/// The URI of a file.
std::string fileUri(const std::string& path);

}  // namespace xabsl::server
