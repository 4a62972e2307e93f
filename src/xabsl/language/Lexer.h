#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl {

enum class TokenKind {
  identifier,   ///< ball.distance
  parameter,    ///< @speed; the text is without the @
  keyword,      ///< option
  number,       ///< 12.5
  string,       ///< "mm"; the text is without the quotes
  range,        ///< [0..1]; opaque
  punctuation,  ///< == { ;
  end           // of the file
};

/// One word of XABSL text. Its text is a view into the source.
struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;
  Location location;
  Location end;          ///< behind its last character
  std::string_view doc;  ///< text of the documentation comment before it, without the marks
  double number = 0;

  bool is(std::string_view expected) const {
    return (kind == TokenKind::keyword || kind == TokenKind::punctuation) && text == expected;
  }
};

/// The name of a token in messages: 'text', or a description.
std::string describe(const Token& token);

/// Splits XABSL text into tokens, one at a time. Comments are stored separately; invalid characters
/// are reported and skipped.
class Lexer {
 public:
  static constexpr std::size_t longestName = 500;  ///< Number of letters; longer names are errors.

  /// Comments are appended to `comments`, if that is given. In XABSL 3.0 the words of cooperation
  /// are names.
  Lexer(int file, std::string_view text, Reporter& reporter,
        std::vector<syntax::Comment>* comments = nullptr, Dialect dialect = Dialect::xabsl31);

  Token next();

  /// Returns whether `letter` is the first character behind the last token and blanks.
  bool isNext(char letter) const;

 private:
  bool atEnd(std::size_t ahead = 0) const { return position_ + ahead >= text_.size(); }
  char peek(std::size_t ahead = 0) const { return atEnd(ahead) ? '\0' : text_[position_ + ahead]; }
  Token read();
  void advance();
  void skipBlanks();
  void skipLineComment();
  void skipBlockComment();
  std::size_t endOfOpenComment(std::size_t start) const;
  void keep(syntax::Comment::Kind kind, std::size_t start, Location begin);
  std::string_view takeName();
  Token enclosed(Token token, TokenKind kind, char close, const char* name);
  std::size_t endOfEnclosed(char close) const;
  Token number(Token token);
  bool punctuation(Token& token);
  void skipUnexpected();

  std::string_view text_;
  Reporter& reporter_;
  std::vector<syntax::Comment>* comments_;
  Dialect dialect_;
  std::string_view doc_;
  std::size_t position_ = 0;
  bool openComment_ = false;  ///< no comment ends behind this position
  Location location_;
};

}  // namespace xabsl
