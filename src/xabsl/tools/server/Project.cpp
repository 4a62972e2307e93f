#include "xabsl/tools/server/Project.h"

#include <algorithm>

#include "xabsl/formats/Sources.h"
#include "xabsl/language/Analyzer.h"
#include "xabsl/language/Utf8.h"
#include "xabsl/language/Warnings.h"

namespace xabsl::server {

namespace {

/// The number of UTF-16 units of the character that begins with a byte.
int unitsOf(char c) {
  return static_cast<unsigned char>(c) >= 0xF0u ? 2 : 1;
}

constexpr std::size_t bytesOfACount = 256;

}  // namespace

void Lines::Count::add(char c) {
  if (continuesLetter(c)) return;
  ++letters;
  units += unitsOf(c);
}

Lines::Lines(std::string_view text) : text_(text), begins_{0} {
  Count count;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i % bytesOfACount == 0) counts_.push_back(count);
    if (text[i] == '\n') begins_.push_back(i + 1);
    count.add(text[i]);
  }
  counts_.push_back(count);
}

Lines::Count Lines::countBefore(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const std::size_t block = std::min(offset / bytesOfACount, counts_.size() - 1);
  Count count = counts_[block];
  for (const char c : text_.substr(0, offset).substr(block * bytesOfACount)) count.add(c);
  return count;
}

/// The byte at which a character begins, counted from 0 over the whole text.
std::size_t Lines::offsetOfLetter(int letter) const {
  const auto next = std::ranges::upper_bound(counts_, letter, {}, &Count::letters);
  const auto block = static_cast<std::size_t>(next - counts_.begin()) - 1;
  std::size_t offset = std::min(block * bytesOfACount, text_.size());
  int letters = counts_[block].letters;
  for (; offset < text_.size(); ++offset)
    if (!continuesLetter(text_[offset]) && letters++ == letter) break;
  return offset;
}

std::string_view Lines::line(int line) const {
  if (line < 0 || static_cast<std::size_t>(line) >= begins_.size()) return {};
  const std::string_view rest = text_.substr(begins_[xabsl::at(line)]);
  return rest.substr(0, rest.find('\n'));
}

Position Lines::position(Location location) const {
  const int line = std::max(location.line - 1, 0);
  if (static_cast<std::size_t>(line) >= begins_.size()) return {line, 0};
  const std::size_t begin = begins_[xabsl::at(line)], end = begin + this->line(line).size();
  const int letter = countBefore(begin).letters + std::max(location.column - 1, 0);
  return position(std::min(offsetOfLetter(letter), end));
}

Position Lines::position(std::size_t offset) const {
  const auto next = std::upper_bound(begins_.begin(), begins_.end(), offset);
  return {static_cast<int>(next - begins_.begin()) - 1,
          countBefore(offset).units - countBefore(*(next - 1)).units};
}

Location Lines::location(Position position, int file) const {
  Location location{file, std::max(position.line, 0) + 1, 1};
  int units = 0;
  for (const char c : line(position.line)) {
    if (continuesLetter(c)) continue;
    if (units >= position.character) break;
    units += unitsOf(c);
    ++location.column;
  }
  return location;
}

std::size_t Lines::offset(Position position) const {
  if (position.line < 0) return 0;
  if (static_cast<std::size_t>(position.line) >= begins_.size()) return text_.size();
  std::size_t offset = begins_[xabsl::at(position.line)];
  int units = 0;
  for (const char c : line(position.line)) {
    if (!continuesLetter(c)) {
      if (units >= position.character) break;
      units += unitsOf(c);
    }
    ++offset;
  }
  return offset;
}

Position Lines::end() const {
  const int last = static_cast<int>(begins_.size()) - 1;
  return position({0, last + 1, static_cast<int>(line(last).size()) + 1});
}

Project::Project(const std::string& root, const FileReader& read) : root_(root) {
  Reporter reporter;
  readSources(root, read, program_, reporter);
  failed_ = reporter.failed();
  // After an error of syntax what is sound is still of use, but errors that follow from it are not;
  // neither is it an error that a file alone has no agent.
  Reporter quiet;
  for (const syntax::File& file : program_.files) quiet.addFile(file.path, file.text);
  const bool whole = !failed_ && !program_.agents.empty();
  if (!program_.files.empty()) {
    Reporter& used = whole ? reporter : quiet;
    model_ = Analyzer(program_, used, &references_).analyze();
    failed_ = failed_ || used.failed();
    if (whole && !failed_) warnAbout(model_, reporter);
  }
  diagnostics_ = reporter.take();
  for (const syntax::File& file : program_.files) lines_.emplace_back(file.text);
}

int Project::file(const std::string& path) const {
  for (std::size_t i = 0; i < program_.files.size(); ++i)
    if (program_.files[i].path == path) return static_cast<int>(i);
  return -1;
}

const Reference* Project::at(Location location) const {
  for (const Reference& reference : references()) {
    const int column = location.column - reference.location.column;
    if (reference.location.file != location.file || reference.location.line != location.line)
      continue;
    if (column >= 0 && column <= static_cast<int>(reference.text.size())) return &reference;
    if (column == -1 && isMarked(reference)) return &reference;
  }
  return nullptr;
}

bool Project::isMarked(const Reference& reference) const {
  if (reference.entity.kind != Entity::Kind::optionParameter) return false;
  const Lines& lines = this->lines(reference.location.file);
  const std::size_t offset = lines.offset(lines.position(reference.location));
  return offset > 0 && program_.files[xabsl::at(reference.location.file)].text[offset - 1] == '@';
}

const Reference* Project::declaration(const Entity& entity) const {
  for (const Reference& reference : references())
    if (reference.declares && reference.entity == entity) return &reference;
  return nullptr;
}

}  // namespace xabsl::server
