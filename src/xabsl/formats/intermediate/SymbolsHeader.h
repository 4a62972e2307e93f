#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "xabsl/language/Model.h"

namespace xabsl {

/// Settings of a generated header for the program that includes it.
struct SymbolsHeaderSettings {
  std::string space = "behavior";  ///< the C++ namespace, as in `robot::behavior`
  std::map<std::string, std::string>
      enumerations;  ///< C++ types that exist already, by XABSL names
  /// the ones of `enumerations` whose elements the program registers itself
  std::set<std::string> registered;
  std::vector<std::string> includes;  ///< headers that declare the types of `enumerations`
};

/// Writes a C++ header with the interface between a behavior and the C++ program: a type for each
/// enumeration, the classes `Inputs` and `Outputs` with a pure virtual function for each input and
/// output symbol, a class for each basic behavior with its parameters as members, and
/// `registerSymbols`, which registers objects of classes derived from them. Missing symbols and
/// wrong types therefore cause compile errors.
///
/// `ball.seen.x` becomes `ballSeenX()`, the output `head_mode` becomes `setHeadMode()`, the element
/// `search_ball` of the enumeration `head_mode` becomes `HeadMode::searchBall`, the basic behavior
/// `go_to_ball` the class `GoToBall`.
std::string writeSymbolsHeader(const Model& model, const SymbolsHeaderSettings& settings = {});

}  // namespace xabsl
