#pragma once
#include <string_view>

/// The style sheet and the script of the pages, embedded when the program is built.
namespace xabsl::documentation {

std::string_view style();
std::string_view script();

}  // namespace xabsl::documentation
