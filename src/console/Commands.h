#pragma once
#include "console/Console.h"

namespace gt {

/// Commands that change the whole simulation (report I.5.2).
std::vector<Command> globalCommands();
/// Commands for the selected robots (report I.5.3).
std::vector<Command> robotCommands();

/// A number; an error that names the word if it is none.
Result<double> numberOf(const std::string& word);
/// The error of a command whose arguments are wrong: tells how they should be.
Error wrongArguments(const Words& words);

}  // namespace gt
