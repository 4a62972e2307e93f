#include "base/Lines.h"

#include <algorithm>

namespace gt {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view escaped{"\"\\\n\t\r\0", 6};
constexpr std::string_view escapes{"\"\\ntr0", 6};

bool isBlank(char c) {
  return blanks.find(c) != blanks.npos;
}

}  // namespace

LineReader::LineReader(std::string_view text) : text_{text} {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(byteOrderMark)) text_.remove_prefix(byteOrderMark.size());
}

std::optional<std::string_view> LineReader::next() {
  if (text_.empty()) return std::nullopt;
  const auto end = std::min(text_.find('\n'), text_.size());
  std::string_view line = text_.substr(0, end);
  text_.remove_prefix(std::min(end + 1, text_.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++number_;
  return line;
}

std::string_view trimmed(std::string_view s) {
  const auto begin = s.find_first_not_of(blanks);
  if (begin == s.npos) return {};
  return s.substr(begin, s.find_last_not_of(blanks) - begin + 1);
}

std::string_view withoutComment(std::string_view line) {
  bool isQuoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool begins = i == 0 || isBlank(line[i - 1]);
    if (isQuoted && line[i] == '\\')
      ++i;
    else if (line[i] == '"')
      isQuoted = !isQuoted;
    else if (!isQuoted && begins && (line[i] == '#' || line.substr(i, 2) == "//"))
      return trimmed(line.substr(0, i));
  }
  return trimmed(line);
}

std::vector<Line> linesOf(std::string_view text) {
  std::vector<Line> lines;
  LineReader reader{text};
  while (const auto whole = reader.next())
    if (const auto line = withoutComment(*whole); !line.empty())
      lines.push_back({reader.number(), line});
  return lines;
}

Result<Word> takeWord(std::string_view& line) {
  Word word;
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  if (!line.starts_with('"')) {
    const auto end = std::min(line.find_first_of(blanks), line.size());
    word.text = line.substr(0, end);
    line.remove_prefix(end);
    return word;
  }
  word.quoted = true;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '"') {
      line.remove_prefix(i + 1);
      return word;
    }
    const bool escapes_ = line[i] == '\\' && i + 1 < line.size();
    const char c = escapes_ ? line[++i] : line[i];
    const auto known = escapes_ ? escapes.find(c) : escapes.npos;
    word.text += known == escapes.npos ? c : escaped[known];
  }
  return Error{.what = "the closing quote is missing"};
}

Result<std::vector<Word>> wordsOf(std::string_view line) {
  std::vector<Word> words;
  for (;;) {
    auto word = takeWord(line);
    if (!word) return word.error();
    if (word->text.empty() && !word->quoted) return words;
    words.push_back(std::move(*word));
  }
}

std::string quotedWord(std::string_view text) {
  const bool plain = !text.empty() && text.find_first_of(" \t\r\n\"\\#/=[") == text.npos &&
                     text.find('\0') == text.npos;
  if (plain) return std::string{text};
  std::string s = "\"";
  for (const char c : text) {
    const auto i = escaped.find(c);
    if (i != escaped.npos) s += '\\';
    s += i == escaped.npos ? c : escapes[i];
  }
  return s + '"';
}

}  // namespace gt
