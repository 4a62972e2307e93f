#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "xabsl/language/Model.h"

namespace xabsl {

/// How a generated header fits into the program that includes it.
struct SymbolsHeaderSettings {
  std::string space = "behavior";  ///< the C++ namespace, as in `robot::behavior`
  std::map<std::string, std::string>
      enumerations;                   ///< C++ types that exist already, by XABSL names
  std::set<std::string> registered;   ///< those of them whose elements the program registers itself
  std::vector<std::string> includes;  ///< where those are declared
};

/// Writes a C++ header with all that a behavior shares with its surroundings: a type for each
/// enumeration, the classes `Inputs` and `Outputs` with a pure virtual function for each input and
/// output symbol, a class for each basic behavior with its parameters as members, and
/// `registerSymbols`, which registers objects of classes derived from them. So what is missing or
/// has another type does not compile.
///
/// `ball.seen.x` becomes `ballSeenX()`, the output `head_mode` becomes `setHeadMode()`, the element
/// `search_ball` of the enumeration `head_mode` becomes `HeadMode::searchBall`, the basic behavior
/// `go_to_ball` the class `GoToBall`.
std::string writeSymbolsHeader(const Model& model, const SymbolsHeaderSettings& settings = {});

}  // namespace xabsl
