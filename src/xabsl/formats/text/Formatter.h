#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "xabsl/language/Reporter.h"

namespace xabsl {

/// The continuation lines of block comments: moved with the first line, or left as they are.
enum class CommentLines { move, keep };

/// Formats XABSL 3.1 text: lines are indented by their nesting, words are separated by single
/// blanks, and at most one empty line is kept in a row. Tokens, comments and line breaks stay. All
/// lines end as most lines of the text do, with LF or CR LF. Empty if the text contains anything
/// that is not a token; the reporter then has the errors.
std::optional<std::string> format(int file, std::string_view text, Reporter& reporter,
                                  CommentLines commentLines = CommentLines::move);

}  // namespace xabsl
