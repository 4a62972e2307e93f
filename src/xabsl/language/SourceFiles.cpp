#include "xabsl/language/SourceFiles.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace xabsl {

std::optional<std::string> readFile(const std::string& path, std::string& text,
                                    std::size_t largest) {
  std::error_code error;
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(path, error)) return "cannot open the file";
  if (std::filesystem::file_size(path, error) > largest || error)
    return "the file is larger than " + std::to_string(largest >> 20) + " MiB";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return "cannot open the file";
  text.assign(std::istreambuf_iterator<char>(stream), {});
  return std::nullopt;
}

FileReader diskReader() {
  return [](const std::string& path, std::string& text) { return readFile(path, text); };
}

FileReader readerOf(const VirtualFiles& files) {
  return [&files](const std::string& path, std::string& text) -> std::optional<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return "there is no such file";
    if (found->second.size() > largestFile) return "the file is larger than 2 MiB";
    text = found->second;
    return std::nullopt;
  };
}

std::optional<std::string> SourceFiles::read(const std::string& path, std::string& text) {
  const std::optional<std::string> problem = read_(path, text);
  sum_ += text.size();
  if (problem || sum_ <= largestSum) return problem;
  return "the files are larger than 8 MiB together";
}

void SourceFiles::refuse(const syntax::Include& include, const std::string& why) {
  reporter_.error(include.location, "cannot include '" + std::string(include.path) + "': " + why);
}

int SourceFiles::open(const std::string& path, ToSource toSource, const syntax::Include* include) {
  const bool full = indices_.size() >= mostFiles;
  const auto [index, added] = indices_.emplace(path, -1);
  if (!added) return index->second;
  std::string text;
  std::optional<std::string> problem = full ? "more than 10000 files" : read(path, text);
  if (!problem) problem = toSource(text);
  if (!problem) {
    const std::string_view kept = program_.keep(std::move(text));
    index->second = reporter_.addFile(path, kept);
    program_.files.push_back({path, kept, {}, {}});
  } else if (include) {
    refuse(*include, *problem);
  } else {
    reporter_.fileError(path, *problem);
  }
  return index->second;
}

}  // namespace xabsl
