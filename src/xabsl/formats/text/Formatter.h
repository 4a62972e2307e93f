#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "xabsl/language/Reporter.h"

namespace xabsl {

/// Treatment of the continuation lines of block comments: moved with the first line, or left
/// unchanged.
enum class CommentLines { move, keep };

/// Formats XABSL 3.1 text: lines are indented by their nesting, words are separated by single
/// blanks, and at most one empty line is kept in a row. Tokens, comments and line breaks are kept.
/// All lines end like most lines of the text, with LF or CR LF. Returns nothing if the text
/// contains invalid tokens; the reporter then has the errors.
std::optional<std::string> format(int file, std::string_view text, Reporter& reporter,
                                  CommentLines commentLines = CommentLines::move);

}  // namespace xabsl
