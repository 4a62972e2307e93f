#include "xabsl/formats/text/SourceWriter.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

#include "xabsl/language/Text.h"

namespace xabsl {

using namespace syntax;

namespace {

bool isBefore(Location a, Location b) {
  return std::tie(a.line, a.column) < std::tie(b.line, b.column);
}

std::string_view withoutMarks(const Comment& comment) {
  std::string_view text = comment.text;
  if (comment.kind == Comment::Kind::line) return text.substr(2);
  text = text.substr(2, text.size() - 4);
  while (!text.empty() && text.front() == '*') text.remove_prefix(1);
  while (!text.empty() && text.back() == '*') text.remove_suffix(1);
  return text;
}

}  // namespace

LooseComments::LooseComments(const Program& program) : taken_(program.files.size(), 0) {
  for (const File& file : program.files) {
    files_.emplace_back();
    for (const Comment& comment : file.comments)
      if (comment.kind != Comment::Kind::header && !comment.documents)
        files_.back().push_back(&comment);
  }
}

std::vector<std::string> LooseComments::before(Location place) {
  const std::size_t file = static_cast<std::size_t>(place.file);
  std::vector<std::string> texts;
  std::size_t& next = taken_[file];
  for (; next < files_[file].size() && isBefore(files_[file][next]->extent.begin, place); ++next)
    texts.emplace_back(trimmed(withoutMarks(*files_[file][next])));
  return texts;
}

std::vector<std::string> LooseComments::rest() {
  std::vector<std::string> texts;
  for (std::size_t file = 0; file < files_.size(); ++file)
    for (; taken_[file] < files_[file].size(); ++taken_[file])
      texts.emplace_back(trimmed(withoutMarks(*files_[file][taken_[file]])));
  return texts;
}

std::string folderOf(const Program& program, Location location) {
  const std::filesystem::path root =
      std::filesystem::path(program.files.front().path).parent_path();
  const std::filesystem::path folder =
      std::filesystem::path(program.files[at(location.file)].path).parent_path();
  const std::filesystem::path inside =
      folder.lexically_relative(root.empty() ? std::filesystem::path(".") : root);
  if (inside.empty() || inside == "." || *inside.begin() == "..") return {};
  return inside.generic_string() + "/";
}

const Declaration& declarationOf(const Collection::Member& member) {
  return std::visit([](const auto* one) -> const Declaration& { return *one; }, member);
}

std::vector<Collection> collectionsOf(const Program& program) {
  std::vector<Collection> collections;
  std::map<std::pair<std::string_view, bool>, std::size_t> known;
  const auto add = [&](const auto& member, bool behaviors) {
    const Namespace& space = program.namespaces[at(member.space)];
    const auto [found, added] =
        known.emplace(std::pair(space.name.text, behaviors), collections.size());
    if (added) collections.push_back({&space, behaviors, {}});
    collections[found->second].members.push_back(&member);
  };
  for (const Enumeration& enumeration : program.enumerations) add(enumeration, false);
  for (const Symbol& symbol : program.symbols) add(symbol, false);
  for (const Constant& constant : program.constants) add(constant, false);
  for (const Behavior& behavior : program.behaviors) add(behavior, true);
  // In the order of the sources; an enumeration that a symbol brings along stands before it.
  const auto order = [](const Collection::Member& a, const Collection::Member& b) {
    const Location &first = declarationOf(a).extent.begin, &second = declarationOf(b).extent.begin;
    return std::tie(first.file, first.line, first.column) <
           std::tie(second.file, second.line, second.column);
  };
  for (Collection& collection : collections)
    std::stable_sort(collection.members.begin(), collection.members.end(), order);
  std::stable_sort(collections.begin(), collections.end(),
                   [](const Collection& a, const Collection& b) { return a.space < b.space; });
  return collections;
}

}  // namespace xabsl
