#pragma once
#include <string_view>

namespace gt {

/// Ends the program with a sentence if it was written wrongly in a way that the compiler cannot
/// see: in every build, at the place where the mistake is made. What comes from outside the program
/// is never checked like this, but makes an Error.
void require(bool condition, std::string_view sentence);
[[noreturn]] void violate(std::string_view sentence);

}  // namespace gt
