#include "base/File.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace gt {
namespace {

constexpr std::uintmax_t largestFile = 1u << 30;
constexpr std::string_view unfinished = ".part";

Error fileError(const std::string& path, const std::string& what) {
  return {.file = path, .what = what};
}

}  // namespace

Result<std::string> readFile(const std::string& path) {
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) return fileError(path, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) return fileError(path, "is not a file");
  const auto size = std::filesystem::file_size(path, failure);
  if (failure) return fileError(path, failure.message());
  if (size > largestFile) return fileError(path, "is larger than 1 GiB");
  std::ifstream stream{path, std::ios::binary};
  if (!stream) return fileError(path, std::strerror(errno));
  std::string content(static_cast<std::size_t>(size), '\0');
  stream.read(content.data(), static_cast<std::streamsize>(size));
  if (stream.gcount() != static_cast<std::streamsize>(size))
    return fileError(path, "cannot be read to its end");
  return content;
}

std::string unfinishedName(const std::string& path) {
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return path;
  const bool isLink = std::filesystem::is_symlink(path, failure);
  const auto real = isLink ? std::filesystem::weakly_canonical(path, failure).string() : path;
  return real + std::string{unfinished};
}

Result<void> finishFile(const std::string& path, const std::string& written) {
  if (written == path) return {};
  std::error_code failure;
  const std::string real = written.substr(0, written.size() - unfinished.size());
  if (const auto before = std::filesystem::status(real, failure); exists(before))
    std::filesystem::permissions(written, before.permissions(), failure);
  std::filesystem::rename(written, real, failure);
  if (failure) return fileError(path, failure.message());
  return {};
}

Result<OutputFile> OutputFile::open(const std::string& path) {
  OutputFile output{path, unfinishedName(path)};
  output.file_.reset(std::fopen(output.written_.c_str(), "wb"));
  if (!output.file_) return output.error();
  return output;
}

OutputFile::~OutputFile() {
  if (file_ && written_ != path_) std::remove(written_.c_str());
}

bool OutputFile::put(std::string_view text) {
  return std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size();
}

Error OutputFile::error() const {
  return fileError(path_, std::string("cannot be written: ") + std::strerror(errno));
}

Result<void> OutputFile::close() {
  const bool good = std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0;
  if (!good) return error();
  if (std::fclose(file_.release()) != 0) {
    const Error failed = error();
    if (written_ != path_) std::remove(written_.c_str());
    return failed;
  }
  return finishFile(path_, written_);
}

Result<void> writeFile(const std::string& path, std::string_view content) {
  auto file = OutputFile::open(path);
  if (!file) return file.error();
  if (!file->put(content)) return file->error();
  return file->close();
}

}  // namespace gt
