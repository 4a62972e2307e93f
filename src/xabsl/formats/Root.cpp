#include "xabsl/formats/Root.h"

#include <algorithm>
#include <filesystem>

#include "xabsl/formats/Sources.h"
#include "xabsl/formats/xml/XmlReader.h"

namespace xabsl {

namespace {

/// Whether a file may be the file with the agents that includes another one.
bool mayBeRootOf(const std::string& candidate, const std::string& text, const std::string& path) {
  const std::filesystem::path extension = std::filesystem::path(candidate).extension();
  return extension == std::filesystem::path(path).extension() &&
         text.find(extension == ".xml" ? "<agent-collection" : "agent") != std::string::npos;
}

}  // namespace

FolderLister diskLister() {
  return [](const std::string& folder) {
    std::vector<std::string> paths;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
      if (entry->path().extension() == ".xabsl" || entry->path().extension() == ".xml")
        paths.push_back(entry->path().lexically_normal().generic_string());
    std::sort(paths.begin(), paths.end());
    return paths;
  };
}

std::string rootOf(const std::string& path, const FolderLister& sources, const FileReader& read,
                   const std::string& last) {
  constexpr int farthest = 6, mostCandidates = 200;
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  int candidates = 0;
  for (int i = 0; i < farthest; ++i, folder = folder.parent_path()) {
    for (const std::string& candidate : sources(folder.generic_string())) {
      std::string text;
      if (++candidates > mostCandidates || read(candidate, text)) continue;
      if (!mayBeRootOf(candidate, text, path)) continue;
      Reporter ignored;
      syntax::Program program;
      readSources(candidate, read, program, ignored);
      const bool includes =
          std::any_of(program.files.begin(), program.files.end(),
                      [&](const syntax::File& file) { return file.path == path; });
      const bool xml = xml::isXml(text);  // which has no agents as long as it is not valid
      if (includes && (xml || !program.agents.empty())) return candidate;
    }
    if (folder.generic_string() == last || folder == folder.parent_path()) break;
  }
  return {};
}

}  // namespace xabsl
