#pragma once
#include <string_view>

namespace gt {

/// Checks for errors of the programmer that the compiler cannot find: if `condition` is false, ends
/// the program with the sentence, in every build. Data from outside the program is never checked
/// like this; if it is wrong, it yields an Error.
void require(bool condition, std::string_view sentence);
[[noreturn]] void violate(std::string_view sentence);

}  // namespace gt
