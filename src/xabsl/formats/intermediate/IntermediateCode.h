#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"

namespace xabsl {

class Symbols;

/// The result of writing intermediate code: the text, or messages about constructs that the dialect
/// cannot express.
struct IntermediateCode {
  std::optional<std::string> text;
  std::vector<Diagnostic> diagnostics;
};

/// Writes a behavior as intermediate code of XABSL 3.1 or 3.0, token for token and line for line as
/// the compiler of XABSL 3.1 does: names sorted without regard to case, common actions and common
/// decision trees copied into each state, lines that end with CR LF.
IntermediateCode writeIntermediateCode(const Model& model, Dialect dialect = Dialect::xabsl31);

/// Writes the names of all entities that debugging tools can request: enumerations, input and
/// output symbols, options and basic behaviors with their parameters.
std::string writeDebugSymbols(const Model& model);

/// Reads intermediate code of XABSL 3.1 or 3.0, which it detects from the code. Intermediate code
/// lacks the parameters and elements that are never used. Registered symbols complete them, so an
/// engine's symbols should be given.
Compilation readIntermediateCode(const std::string& name, std::string_view text,
                                 const Symbols* registered = nullptr);

/// Reads intermediate code from a file.
Compilation loadIntermediateCode(const std::string& path, const Symbols* registered = nullptr);

}  // namespace xabsl
