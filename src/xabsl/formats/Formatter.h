#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "xabsl/language/Reporter.h"

namespace xabsl {

/// XABSL 3.1 text with its lines indented by what they stand in, single blanks between words and at
/// most one empty line in a row. Tokens, comments and line breaks stay as they are. Nothing, if the
/// text holds what is no token; the reporter then says what.
std::optional<std::string> format(int file, std::string_view text, Reporter& reporter);

}  // namespace xabsl
