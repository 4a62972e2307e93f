#include "robot/FileNames.h"

#include <algorithm>

namespace gt {

Error withFileNames(Error error, const std::filesystem::path& folder,
                    const std::function<std::string(const std::string& path)>& nameOf) {
  const std::string begin = folder.string() + "/";
  const auto rename = [&](std::string& text) {
    for (std::size_t at = 0; (at = text.find(begin, at)) != text.npos;) {
      // In a sentence a path ends before its line, or where the quotes or parentheses around it do.
      const auto end = std::min(text.find_first_of(":)'\"", at), text.size());
      const std::string name = nameOf(text.substr(at, end - at));
      text.replace(at, end - at, name);
      at += name.size();
    }
  };
  if (error.file.starts_with(begin)) error.file = nameOf(error.file);
  rename(error.field);
  rename(error.what);
  return error;
}

}  // namespace gt
