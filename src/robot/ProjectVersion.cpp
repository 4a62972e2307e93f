#include "robot/ProjectVersion.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "base/File.h"
#include "robot/SetupFiles.h"

namespace gt {

namespace fs = std::filesystem;

Result<std::vector<fs::path>> filesBelow(const std::string& folder) {
  std::error_code failed;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at{folder, failed}, end; !failed && at != end;
       at.increment(failed))
    if (at->is_regular_file()) files.push_back(at->path());
  if (failed) return Error{.file = folder, .what = failed.message()};
  std::ranges::sort(files);
  return files;
}

Result<void> addFiles(const std::string& folder, Fingerprint& sum) {
  const auto files = filesBelow(folder);
  if (!files) return files.error();
  for (const fs::path& file : *files) {
    const auto text = readFile(file.string());
    if (!text) return text.error();
    sum.add(file.lexically_relative(folder).generic_string());
    sum.add(" " + std::to_string(text->size()) + " ");
    sum.add(*text);
  }
  return {};
}

std::string digitsOf(const Fingerprint& sum) {
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(16) << sum.value();
  return text.str();
}

Result<std::string> projectVersion(const DataRoot& root) {
  Fingerprint sum;
  for (const char* folder : {"behavior", "config", "layouts", "models", "motions", "scenes"}) {
    sum.add(folder);
    if (auto done = addFiles(root.path(folder), sum); !done) return done.error();
  }
  return commit() + '+' + digitsOf(sum);
}

}  // namespace gt
