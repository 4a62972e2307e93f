#pragma once
#include <string_view>

/// The files of the report page, embedded when the program is built.
namespace gt::page {

std::string_view html();
std::string_view style();
std::string_view script();
std::string_view playScript();
std::string_view fieldScript();
std::string_view chartScript();
std::string_view chartLibrary();  ///< Chart.js (MIT), from Debian's libjs-chart.js.

}  // namespace gt::page
