#include "xabsl/formats/text/Formatter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "xabsl/language/Lexer.h"
#include "xabsl/language/Parser.h"

namespace xabsl {

namespace {

/// A token or a comment of the source.
struct Piece {
  std::string_view text;
  bool comment = false;
};

Piece pieceOf(const Token& token) {
  const bool closed = token.kind == TokenKind::string || token.kind == TokenKind::range;
  const std::size_t before = closed || token.kind == TokenKind::parameter ? 1 : 0;
  const std::size_t length = token.text.size() + before + (closed ? 1 : 0);
  return {{token.text.data() - before, length}, false};
}

/// Reports brackets that are nested more deeply than the parser would follow: each level moves all
/// lines in it, so that the text grows with the square of their number.
class NestingLimit {
 public:
  explicit NestingLimit(Reporter& reporter) : reporter_(reporter) {}

  /// Returns false if there are too many open brackets.
  bool add(const Token& token) {
    if (token.is("{") || token.is("(")) ++open_;
    if ((token.is("}") || token.is(")")) && open_ > 0) --open_;
    if (open_ <= most) return true;
    reporter_.error(token.location,
                    "nested too deeply, at most " + std::to_string(most) + " levels");
    return false;
  }

 private:
  /// The parser's, and the brackets of option, state and the like around what it counts.
  static constexpr int most = Parser::maximalNesting + 10;

  Reporter& reporter_;
  int open_ = 0;
};

std::vector<Piece> piecesOf(int file, std::string_view text, Reporter& reporter) {
  std::vector<syntax::Comment> comments;
  std::vector<Piece> pieces;
  Lexer lexer(file, text, reporter, &comments);
  NestingLimit nesting(reporter);
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
    if (!nesting.add(token)) break;
    pieces.push_back(pieceOf(token));
  }
  for (const syntax::Comment& comment : comments) pieces.push_back({comment.text, true});
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return a.text.data() < b.text.data(); });
  return pieces;
}

constexpr std::string_view blanks = " \t";

/// The column, from 0, at which a line's text begins behind leading blanks. Tabs go to the next
/// multiple of 8.
std::size_t widthOf(std::string_view leading, std::size_t width = 0) {
  constexpr std::size_t tab = 8;
  for (const char c : leading) width = c == '\t' ? (width / tab + 1) * tab : width + 1;
  return width;
}

/// The lines of a block comment, moved as far as its first line. `before` is the text before the
/// comment on its line in the source, `out` the text before it now.
std::string moved(std::string_view comment, std::string_view before, std::string_view out) {
  if (comment.find('\n') == comment.npos)
    return std::string(comment.substr(0, comment.find_last_not_of('\r') + 1));
  const std::size_t column = out.size() - (out.rfind('\n') + 1);
  const std::size_t oldColumn = widthOf(before);
  const bool first = before.find_first_not_of(blanks) == std::string_view::npos;
  std::string result;
  while (!comment.empty()) {
    const std::size_t end = std::min(comment.find('\n'), comment.size());
    std::string_view line = comment.substr(0, end);
    comment.remove_prefix(std::min(end + 1, comment.size()));
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (result.empty()) {
      result = line;
      continue;
    }
    const std::string_view leading = line.substr(0, line.find_first_not_of(blanks));
    result += '\n';
    if (leading.size() == line.size()) continue;  // an empty line
    const bool below = first && leading.starts_with(before);
    const std::size_t width =
        below ? oldColumn + widthOf(leading.substr(before.size())) : widthOf(leading);
    result.append(column + width - std::min(column + width, oldColumn), ' ');
    result += line.substr(leading.size());
  }
  return result;
}

/// Whether more lines end with CR LF than with LF alone.
bool endsWithCarriageReturns(std::string_view text) {
  std::ptrdiff_t balance = 0;
  for (std::size_t i = text.find('\n'); i != std::string_view::npos; i = text.find('\n', i + 1))
    balance += i > 0 && text[i - 1] == '\r' ? 1 : -1;
  return balance > 0;
}

/// Writes pieces one after another and tracks which brackets are open.
class PieceWriter {
 public:
  /// `gap` is what stood before the piece in the source, `before` all that stood there on its line.
  /// Without it the lines of comments stay as they are.
  void add(const Piece& piece, std::string_view gap, const std::string_view* before) {
    const auto lines = std::count(gap.begin(), gap.end(), '\n');
    const bool newLine = lines > 0 || gap.find('\r') != std::string_view::npos;
    const bool closes = !piece.comment && (piece.text == "}" || piece.text == ")");
    if (!out_.empty() && newLine) {
      // What follows a parenthesis on a line of its own is indented as a block.
      if (last_ == "(" && !closes) open_.back().inside = open_.back().outside + 2;
      indent_ = indentOf(piece, closes);
      out_.append(lines > 1 ? "\n\n" : "\n");
      lineBegins_ = out_.size();
      out_.append(indent_, ' ');
    } else if (!out_.empty() && !gap.empty()) {
      out_ += ' ';
    }
    if (closes && !open_.empty()) open_.pop_back();
    if (piece.comment && before)
      out_ += moved(piece.text, *before, out_);
    else
      out_ += piece.text;
    if (piece.comment) return;
    if (piece.text == "{") open_.push_back({false, inside() + 2, inside()});
    if (piece.text == "(") open_.push_back({true, out_.size() - lineBegins_, indent_});
    last_ = piece.text;
  }

  std::string take() {
    if (!out_.empty()) out_ += '\n';
    return std::move(out_);
  }

 private:
  /// A bracket that is open: how far lines in it are indented, and its own line. In parentheses
  /// they stand below the first word behind it.
  struct Open {
    bool parenthesis;
    std::size_t inside, outside;
  };

  std::size_t inside() const { return open_.empty() ? 0 : open_.back().inside; }

  std::size_t indentOf(const Piece& piece, bool closes) const {
    if (closes) return open_.empty() ? 0 : open_.back().outside;
    constexpr std::string_view between = "{};,";
    const bool begins = last_.empty() || between.find(last_) != std::string_view::npos ||
                        (!open_.empty() && open_.back().parenthesis);
    return inside() + (begins || piece.text == "{" || piece.comment ? 0 : 2);
  }

  std::string out_;
  std::string_view last_;
  std::vector<Open> open_;
  std::size_t indent_ = 0;      // of the present line
  std::size_t lineBegins_ = 0;  // in the text
};

}  // namespace

std::optional<std::string> format(int file, std::string_view text, Reporter& reporter,
                                  CommentLines commentLines) {
  const std::vector<Piece> pieces = piecesOf(file, text, reporter);
  if (reporter.failed()) return std::nullopt;
  PieceWriter writer;
  const char* end = text.data();
  const char* line = end;  // where the piece's line begins
  const auto lookForLine = [&line](std::string_view passed) {
    const std::size_t last = passed.find_last_of("\r\n");
    if (last != passed.npos) line = passed.data() + last + 1;
  };
  for (const Piece& piece : pieces) {
    const std::string_view gap(end, static_cast<std::size_t>(piece.text.data() - end));
    lookForLine(gap);
    const std::string_view before(line, static_cast<std::size_t>(piece.text.data() - line));
    writer.add(piece, gap, commentLines == CommentLines::move ? &before : nullptr);
    lookForLine(piece.text);
    end = piece.text.data() + piece.text.size();
  }
  const std::string formatted = writer.take();
  if (commentLines == CommentLines::keep || !endsWithCarriageReturns(text)) return formatted;
  std::string result;
  for (const char c : formatted) {
    if (c == '\n') result += '\r';
    result += c;
  }
  return result;
}

}  // namespace xabsl
