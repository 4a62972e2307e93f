#include "xabsl/language/Lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "xabsl/language/Text.h"
#include "xabsl/language/Utf8.h"

namespace xabsl {

namespace {

constexpr std::array<std::string_view, 28> keywords = {
    "true",        "false",    "option", "action",  "initial",  "target",      "state",
    "common",      "decision", "goto",   "if",      "else",     "option_time", "state_time",
    "action_done", "agent",    "enum",   "input",   "function", "output",      "bool",
    "float",       "const",    "stay",   "include", "behavior", "namespace",   "internal"};
constexpr std::array<std::string_view, 3> keywordsSince31 = {"capacity", "conflict",
                                                             "synchronized"};

constexpr std::array<std::string_view, 16> declaringWords = {
    "include", "agent", "namespace", "option", "initial", "target",   "state",  "common",
    "input",   "float", "bool",      "enum",   "const",   "internal", "output", "behavior"};

constexpr std::array<std::string_view, 6> longPunctuation = {"==", "!=", "<=", ">=", "&&", "||"};
constexpr std::string_view shortPunctuation = "{}();,=!-+*/%<>?:";

bool beginsName(char c) {
  return isLetter(c) || c == '_';
}

template <typename Words>
bool contains(const Words& words, std::string_view text) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool isKeyword(std::string_view text, Dialect dialect) {
  return contains(keywords, text) ||
         (dialect != Dialect::xabsl30 && contains(keywordsSince31, text));
}

}  // namespace

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::end:
      return "the end of the file";
    case TokenKind::string:
      return "a string";
    case TokenKind::range:
      return "a range";
    case TokenKind::parameter:
      return "'@" + std::string(token.text) + "'";
    default:
      return inQuotes(token.text);
  }
}

Lexer::Lexer(int file, std::string_view text, Reporter& reporter,
             std::vector<syntax::Comment>* comments, Dialect dialect)
    : text_(withoutByteOrderMark(text)),
      reporter_(reporter),
      comments_(comments),
      dialect_(dialect) {
  location_.file = file;
}

Token Lexer::next() {
  doc_ = {};
  Token token = read();
  token.doc = doc_;
  token.end = location_;
  return token;
}

bool Lexer::isNext(char letter) const {
  std::size_t ahead = 0;
  while (!atEnd(ahead) && isBlank(peek(ahead))) ++ahead;
  return peek(ahead) == letter;
}

Token Lexer::read() {
  for (;;) {
    skipBlanks();
    Token token;
    token.location = location_;
    if (atEnd()) return token;
    const char c = peek();
    if (beginsName(c)) {
      token.text = takeName();
      token.kind = isKeyword(token.text, dialect_) ? TokenKind::keyword : TokenKind::identifier;
      return token;
    }
    if (c == '@' && beginsName(peek(1))) {
      advance();
      token.text = takeName();
      token.kind = TokenKind::parameter;
      return token;
    }
    if (isDigit(c) || (c == '.' && isDigit(peek(1)))) return number(token);
    if (c == '"') return enclosed(token, TokenKind::string, '"', "string");
    if (c == '[') return enclosed(token, TokenKind::range, ']', "range");
    if (punctuation(token)) return token;
    skipUnexpected();
  }
}

void Lexer::advance() {
  if (peek() == '\n') {
    ++location_.line;
    location_.column = 0;
  }
  ++position_;
  // Columns count letters, not bytes.
  if (!continuesLetter(peek())) ++location_.column;
}

void Lexer::skipBlanks() {
  while (!atEnd()) {
    if (isBlank(peek())) {
      advance();
    } else if (peek() == '/' && peek(1) == '/') {
      skipLineComment();
    } else if (peek() == '/' && peek(1) == '*') {
      skipBlockComment();
    } else {
      return;
    }
  }
}

void Lexer::skipLineComment() {
  const std::size_t start = position_;
  const Location begin = location_;
  // A file of old editors may end its lines with a carriage return alone.
  while (!atEnd() && peek() != '\n' && peek() != '\r') advance();
  keep(syntax::Comment::Kind::line, start, begin);
}

void Lexer::skipBlockComment() {
  using Kind = syntax::Comment::Kind;
  const Location start = location_;
  const std::size_t first = position_;
  const std::size_t close = openComment_ ? std::string_view::npos : text_.find("*/", first + 2);
  const bool closed = close != std::string_view::npos;
  const std::size_t end = closed ? close + 2 : endOfOpenComment(first);
  while (position_ < end) advance();
  if (!closed) {
    if (!std::exchange(openComment_, true))
      reporter_.error(start, "comment is not closed, expected '*/'");
    return;
  }
  std::string_view inner = text_.substr(first, position_ - first);
  Kind kind = Kind::block;
  if (inner.size() >= 7 && inner.substr(0, 4) == "/***") {
    kind = Kind::header;
  } else if (inner.size() >= 5 && inner.substr(0, 3) == "/**") {
    kind = Kind::documentation;
    doc_ = trimmed(inner.substr(3, inner.size() - 5));
  }
  keep(kind, first, start);
}

/// The probable end of a comment that is not closed: before the next line that begins like a
/// declaration, so that editors still find the declarations there.
std::size_t Lexer::endOfOpenComment(std::size_t start) const {
  std::size_t newline = text_.find('\n', start);
  while (newline != std::string_view::npos) {
    const std::size_t begin = newline + 1;
    newline = text_.find('\n', begin);
    std::string_view word = text_.substr(begin, newline - begin);
    word.remove_prefix(std::min(word.find_first_not_of(" \t\r"), word.size()));
    word =
        word.substr(0, static_cast<std::size_t>(
                           std::find_if_not(word.begin(), word.end(), isNamePart) - word.begin()));
    if (contains(declaringWords, word)) return begin;
  }
  return text_.size();
}

void Lexer::keep(syntax::Comment::Kind kind, std::size_t start, Location begin) {
  if (comments_)
    comments_->push_back({kind, text_.substr(start, position_ - start), {begin, location_}});
}

std::string_view Lexer::takeName() {
  const std::size_t start = position_;
  const Location location = location_;
  while (isNamePart(peek())) advance();
  const std::size_t length = position_ - start;
  if (length > longestName)
    reporter_.error(location, "name is longer than " + std::to_string(longestName) + " characters");
  return text_.substr(start, std::min(length, longestName));
}

Token Lexer::enclosed(Token token, TokenKind kind, char close, const char* name) {
  advance();
  const std::size_t start = position_;
  const std::size_t end = endOfEnclosed(close);
  while (position_ < end) advance();
  token.kind = kind;
  token.text = text_.substr(start, position_ - start);
  if (peek() == close) {
    advance();
  } else {
    reporter_.error(token.location,
                    std::string(name) + " is not closed, expected '" + std::string(1, close) + "'");
  }
  return token;
}

/// The place of `close`, or the end of the line. A string may span lines, but not into the next
/// statement, so that a missing quote affects one line only.
std::size_t Lexer::endOfEnclosed(char close) const {
  constexpr std::size_t farthest = 500;
  const std::size_t line = std::min(text_.find('\n', position_), text_.size());
  const std::string_view ahead = text_.substr(position_, line - position_ + farthest);
  const std::size_t end = ahead.find(close);
  if (end == std::string_view::npos) return line;
  const bool closed =
      position_ + end < line || ahead.substr(0, end).find_first_of(";{}") == std::string_view::npos;
  return closed ? position_ + end : line;
}

Token Lexer::number(Token token) {
  const std::size_t start = position_;
  if (peek() == '.') reporter_.error(location_, "a number begins with a digit, expected '0.'");
  while (isDigit(peek())) advance();
  if (peek() == '.' && !beginsName(peek(1))) {
    advance();
    while (isDigit(peek())) advance();
  }
  const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
  if ((peek() == 'e' || peek() == 'E') && isDigit(peek(1 + sign))) {
    advance();
    if (sign == 1) advance();
    while (isDigit(peek())) advance();
  }
  token.kind = TokenKind::number;
  token.text = text_.substr(start, position_ - start);
  const char* end = token.text.data() + token.text.size();
  if (std::from_chars(token.text.data(), end, token.number).ec != std::errc())
    reporter_.error(token.location, "number " + describe(token) + " is out of range");
  if (isNamePart(peek())) {
    takeName();
    token.text = text_.substr(start, position_ - start);
    reporter_.error(token.location, describe(token) + " is not a number");
  }
  return token;
}

bool Lexer::punctuation(Token& token) {
  const std::string_view pair = text_.substr(position_, 2);
  const bool isLong = contains(longPunctuation, pair);
  if (!isLong && (peek() == '&' || peek() == '|')) {
    // Whoever writes it means the other one.
    const bool both = peek() == '&';
    reporter_.error(location_, std::string("unexpected character '") + peek() +
                                   "'; did you mean '" + (both ? "&&" : "||") + "'?");
    token.kind = TokenKind::punctuation;
    token.text = both ? "&&" : "||";
    advance();
    return true;
  }
  if (!isLong && shortPunctuation.find(peek()) == std::string_view::npos) return false;
  token.kind = TokenKind::punctuation;
  token.text = text_.substr(position_, isLong ? 2 : 1);
  for (std::size_t i = 0; i < token.text.size(); ++i) advance();
  return true;
}

void Lexer::skipUnexpected() {
  if (peek() == '#') {
    reporter_.error(location_, "unexpected character '#'; comments begin with '//'");
    while (!atEnd() && peek() != '\n') advance();
    return;
  }
  const unsigned char c = static_cast<unsigned char>(peek());
  const bool printable = c > ' ' && c < 0x7F;
  reporter_.error(location_, printable ? "unexpected character '" + std::string(1, peek()) + "'"
                                       : "unexpected character with code " + std::to_string(c));
  do advance();
  while (!atEnd() && static_cast<unsigned char>(peek()) >= 0x7F);
}

}  // namespace xabsl
