#include "streams/File.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace gt {
namespace {

constexpr std::uintmax_t largestFile = 1u << 30;

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

Result<void> writeFile(const std::string& path, std::string_view content) {
  const std::string unfinished = path + ".part";
  std::ofstream stream{unfinished, std::ios::binary};
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  std::error_code failure;
  if (!stream) {
    const Error error = fileError(path, std::string("cannot be written: ") + std::strerror(errno));
    std::filesystem::remove(unfinished, failure);
    return error;
  }
  std::filesystem::rename(unfinished, path, failure);
  if (failure) return fileError(path, failure.message());
  return {};
}

}  // namespace gt
