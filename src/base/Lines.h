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
  std::string_view text;  ///< Without comment, and without blanks around it.
};

/// Takes the lines of a text one after another, as any machine writes them: they end with LF or
/// CRLF, the last one also with nothing, and a byte-order mark may precede the first one.
class LineReader {
 public:
  explicit LineReader(std::string_view text);

  /// The next line without its end; nothing behind the last one.
  std::optional<std::string_view> next();
  /// Of the line that was taken last, from 1.
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
/// Takes the blanks and the first word from the begin of a line, as `wordsOf` does; the word is
/// empty and not quoted at the end.
Result<Word> takeWord(std::string_view& line);

/// A text as one word, quoted if need be: reading it gives the same text.
std::string quotedWord(std::string_view text);

}  // namespace gt
