#pragma once
#include <string>

namespace gt {

/// docs/console.md: all commands of the console, from their table (`simgt commands`).
std::string consoleManual();

}  // namespace gt
