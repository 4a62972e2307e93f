#pragma once
#include <string_view>

/// The files beside the pages, embedded when the program is built.
namespace xabsl::documentation {

std::string_view style();
std::string_view script();

}  // namespace xabsl::documentation
