#include <algorithm>
#include <filesystem>

#include "console/Commands.h"
#include "console/Usage.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Placeholders for files. Files of `folder` may be named without the folder and the extension.
struct FileKind {
  std::string_view placeholder, folder, extension;
  bool data = false;  ///< Whether the folder is one of the data root.
};
constexpr FileKind fileKinds[] = {{"FILE", "", ""},
                                  {"LAYOUT", "layouts", ".layout", true},
                                  {"LOG", "out/logs", ".mcap"},
                                  {"SCENE", "scenes", ".scene", true},
                                  {"SCRIPT", "scenes", ".con", true},
                                  {"STATE", "out/states", ".state"},
                                  {"TABLE", "out", ".csv"},
                                  {"TEST", "out/tests", ".con"}};

constexpr std::size_t mostFiles = 500;

/// The files and folders that complete a word.
void addFiles(std::vector<std::string>& found, const std::string& word, const FileKind& kind,
              const DataRoot& root) {
  const fs::path begun{word};
  std::error_code failed;
  const auto look = [&](const fs::path& folder, const auto& take) {
    for (fs::directory_iterator entry{folder.empty() ? "." : folder, failed}, end;
         !failed && entry != end && found.size() < mostFiles; entry.increment(failed))
      if (entry->path().filename().string().starts_with(begun.filename().string())) take(*entry);
  };
  // The files of the usual folder are named without it; only if there are none, others are offered.
  const bool usual = !kind.folder.empty() && !begun.has_parent_path();
  const std::size_t before = found.size();
  if (usual)
    look(kind.data ? root.path(std::string{kind.folder}) : std::string{kind.folder},
         [&](const fs::directory_entry& entry) {
           if (entry.path().extension() == kind.extension)
             found.push_back(entry.path().stem().string());
         });
  if (found.size() > before) return;
  look(begun.parent_path(), [&](const fs::directory_entry& entry) {
    std::error_code ignored;
    const bool folder = entry.is_directory(ignored);
    if (!folder && !kind.folder.empty() && entry.path().extension() != kind.extension) return;
    found.push_back((begun.parent_path() / entry.path().filename()).string() + (folder ? "/" : ""));
  });
}

/// The words of a line behind its first ones, as they were typed.
std::string_view behind(std::string_view line, std::size_t words) {
  constexpr std::string_view blanks = " \t";
  for (std::size_t at = std::min(line.find_first_not_of(blanks), line.size()); words > 0; --words) {
    line.remove_prefix(std::min(line.find_first_of(blanks, at), line.size()));
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    at = 0;
  }
  return line;
}

}  // namespace

std::vector<std::string> Console::completions(std::string_view line) {
  auto words = splitWords(line);
  if (!words) return {};
  if (words->empty() || line.back() == ' ' || line.back() == '\t') words->emplace_back();
  const std::string word = words->back();
  words->pop_back();
  std::vector<std::string> choices;
  if (words->empty()) {
    for (const Command& command : commands()) choices.emplace_back(command.name);
  } else if (const Command* command = find(words->front())) {
    const Usage::Next next = Usage{command->arguments}.next(std::span{*words}.subspan(1));
    if (next.command) return completions(behind(line, 1 + *next.command));
    choices = next.words;
    bool others = false;
    for (const std::string& placeholder : next.placeholders) {
      const auto* kind = std::ranges::find(fileKinds, placeholder, &FileKind::placeholder);
      if (kind != std::end(fileKinds))
        addFiles(choices, word, *kind, session_.options().root);
      else
        others = true;
    }
    if (others && command->choices)
      for (std::string& choice : command->choices(*this, *words))
        choices.push_back(std::move(choice));
  }
  std::erase_if(choices, [&](const std::string& choice) { return !choice.starts_with(word); });
  std::sort(choices.begin(), choices.end());
  choices.erase(std::unique(choices.begin(), choices.end()), choices.end());
  return choices;
}

}  // namespace gt
