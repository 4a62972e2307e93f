#pragma once
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "base/Result.h"

namespace gt {

/// The whole content of a regular file of at most 1 GiB.
Result<std::string> readFile(const std::string& path);

/// The temporary name under which a file is written until it is complete: PATH.part. For a symbolic
/// link, the name is based on the link's target. A device or a pipe is written under its own name.
std::string unfinishedName(const std::string& path);
/// Renames a file that was written under its temporary name to its final path.
Result<void> finishFile(const std::string& path, const std::string& written);

/// Writes a file completely or not at all: the data goes to a temporary file until close(). Without
/// close(), the temporary file is removed, and a previous file of that name is kept. Errors are
/// kept until close().
class OutputFile {
 public:
  static Result<OutputFile> open(const std::string& path);
  OutputFile(OutputFile&& other) noexcept = default;
  ~OutputFile();

  std::FILE* file() const { return file_.get(); }
  /// Returns whether the text was written.
  bool put(std::string_view text);
  Error error() const;  ///< Why the last write failed.
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

/// Writes a file completely or not at all.
Result<void> writeFile(const std::string& path, std::string_view content);

}  // namespace gt
