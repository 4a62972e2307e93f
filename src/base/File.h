#pragma once
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "base/Result.h"

namespace gt {

/// The whole content of a regular file of at most 1 GiB.
Result<std::string> readFile(const std::string& path);

/// The name under which a file is written before it is whole: PATH.part, of a link that of the file
/// it leads to. A device or a pipe is written under its own.
std::string unfinishedName(const std::string& path);
/// Gives a file that was written under that name its own one.
Result<void> finishFile(const std::string& path, const std::string& written);

/// Writes a file, whole or not at all: under another name until it is closed. If it is not, it is
/// removed, and a file that was there before stays. Errors are kept until close().
class OutputFile {
 public:
  static Result<OutputFile> open(const std::string& path);
  OutputFile(OutputFile&& other) noexcept = default;
  ~OutputFile();

  std::FILE* file() const { return file_.get(); }
  /// Returns whether it was written.
  bool put(std::string_view text);
  Error error() const;  ///< Why the last thing was not written.
  Result<void> close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  OutputFile(std::string path, std::string written)
      : path_{std::move(path)}, written_{std::move(written)} {}

  std::string path_, written_;
  std::unique_ptr<std::FILE, Closer> file_;
};

/// Writes a file, whole or not at all.
Result<void> writeFile(const std::string& path, std::string_view content);

}  // namespace gt
