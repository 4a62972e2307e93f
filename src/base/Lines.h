#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"

/// The grammar of the project's text formats that consist of lines: config files, layouts, lists.
/// A comment begins with `//` or `#`, at the begin of a line or after a blank, outside of quotes,
/// and ends with the line. Words are separated by blanks; a quoted word may hold anything, with the
/// escapes of C++ for quotes, backslashes, line ends and tabs. Booleans are `true` and `false`.
namespace gt {

/// A word of a line.
struct Word {
  std::string text;
  bool quoted = false;

  friend bool operator==(const Word& word, std::string_view other) { return word.text == other; }
};

/// A line that holds more than a comment.
struct Line {
  int number = 0;         ///< From 1.
  std::string_view text;  ///< Without comment and without surrounding blanks.
};

/// Iterates over the lines of a text. Lines end with LF or CRLF; the last one may have no line end.
/// A byte-order mark at the begin of the text is skipped.
class LineReader {
 public:
  explicit LineReader(std::string_view text);

  /// Returns the next line without its line end; empty after the last one.
  std::optional<std::string_view> next();
  /// Number of the line that was returned last, from 1.
  int number() const { return number_; }

 private:
  std::string_view text_;
  int number_ = 0;
};

/// A text without blanks around it.
std::string_view trimmed(std::string_view text);
/// The part of a line before its comment, without blanks around it.
std::string_view withoutComment(std::string_view line);
/// The lines of a text that hold more than a comment.
std::vector<Line> linesOf(std::string_view text);

/// The words of a line without a comment; an error if a closing quote is missing.
Result<std::vector<Word>> wordsOf(std::string_view line);
/// Removes leading blanks and the first word from a line and returns the word, parsed as by
/// `wordsOf`. At the end of the line the word is empty and not quoted.
Result<Word> takeWord(std::string_view& line);

/// Writes a text as one word, quoted if necessary, so that reading it yields the same text.
std::string quotedWord(std::string_view text);

}  // namespace gt
