#include "xabsl/formats/Formatter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "xabsl/language/Lexer.h"

namespace xabsl {

namespace {

/// A token or a comment, as it stands in the source.
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

std::vector<Piece> piecesOf(int file, std::string_view text, Reporter& reporter) {
  std::vector<syntax::Comment> comments;
  std::vector<Piece> pieces;
  Lexer lexer(file, text, reporter, &comments);
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next())
    pieces.push_back(pieceOf(token));
  for (const syntax::Comment& comment : comments) pieces.push_back({comment.text, true});
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return a.text.data() < b.text.data(); });
  return pieces;
}

/// Writes pieces one after another and knows what is open where.
class Writer {
 public:
  void add(const Piece& piece, std::string_view gap) {
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
  std::size_t indent_ = 0;      ///< Of the present line.
  std::size_t lineBegins_ = 0;  ///< In the text.
};

}  // namespace

std::optional<std::string> format(int file, std::string_view text, Reporter& reporter) {
  const std::vector<Piece> pieces = piecesOf(file, text, reporter);
  if (reporter.failed()) return std::nullopt;
  Writer writer;
  const char* end = text.data();
  for (const Piece& piece : pieces) {
    writer.add(piece, {end, static_cast<std::size_t>(piece.text.data() - end)});
    end = piece.text.data() + piece.text.size();
  }
  return writer.take();
}

}  // namespace xabsl
