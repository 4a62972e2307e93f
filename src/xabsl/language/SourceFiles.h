#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

// Limits far beyond any behavior, which bound memory and time for any content of files.
constexpr std::size_t largestFile = 2u << 20;
constexpr std::size_t largestSum = 8u << 20;
constexpr std::size_t mostFiles = 10'000;

/// Reads a regular file of at most `largest` bytes from disk. Returns the reason if it fails.
std::optional<std::string> readFile(const std::string& path, std::string& text,
                                    std::size_t largest = largestFile);

/// Reads the files of a behavior into its program, each once.
class SourceFiles {
 public:
  SourceFiles(const FileReader& read, syntax::Program& program, Reporter& reporter)
      : read_(read), program_(program), reporter_(reporter) {}

  /// Converts the text of a file to a source in UTF-8. Returns the reason if it fails.
  using ToSource = std::optional<std::string> (*)(std::string& text);

  /// The index of a file in the program, after reading it if it is new; -1 if it cannot be read.
  /// The error is reported at its inclusion, or for the file as a whole.
  int open(const std::string& path, ToSource toSource, const syntax::Include* include);

  /// Reads a text that is no source. Returns the reason if it fails.
  std::optional<std::string> read(const std::string& path, std::string& text);

  /// Reports that a file cannot be included.
  void refuse(const syntax::Include& include, const std::string& why);

 private:
  const FileReader& read_;
  syntax::Program& program_;
  Reporter& reporter_;
  std::map<std::string, int> indices_;  ///< -1: cannot be read
  std::size_t sum_ = 0;
};

}  // namespace xabsl
