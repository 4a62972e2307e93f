#pragma once

#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

/// Warns about valid, but probably unintended code: states that are never entered or can only
/// follow one another, options and basic behaviors called twice in a cycle, parameters that are not
/// set, and unused declarations.
void warnAbout(const Model& model, Reporter& reporter);

/// For each state of an option, in their order, whether it can be entered.
std::vector<bool> enteredStates(const Model& model, const Option& option);

/// A warning for each unused declaration; warnAbout() groups and shortens them.
std::vector<Diagnostic> everythingUnused(const Model& model);

}  // namespace xabsl
