#pragma once

#include <optional>
#include <string>

#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

// Far beyond any behavior; they bound memory and time whatever is in the files.
constexpr std::size_t largestFile = 2u << 20;
constexpr std::size_t largestSum = 8u << 20;
constexpr std::size_t mostFiles = 10'000;

/// Reads a regular file from disk, or returns the reason why it cannot. At most `largest` bytes.
std::optional<std::string> readFile(const std::string& path, std::string& text,
                                    std::size_t largest = largestFile);

/// Reads a behavior, as text or XML, from a file and all files that it includes, each once. The
/// program holds the texts and sets the version of text. Errors go to the reporter.
void readSources(const std::string& path, const FileReader& read, syntax::Program& program,
                 Reporter& reporter);

}  // namespace xabsl
