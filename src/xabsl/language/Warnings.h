#pragma once

#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

/// Warns about what is valid, but hardly intended: states that are never entered or can only follow
/// one another, what is called twice in a cycle, parameters that are not set, and what is declared
/// and never used.
void warnAbout(const Model& model, Reporter& reporter);

/// Whether each state of an option can be entered, counted from its first state.
std::vector<bool> enteredStates(const Model& model, const Option& option);

/// A warning for each single declaration that is never used; warnAbout() groups and shortens them.
std::vector<Diagnostic> everythingUnused(const Model& model);

}  // namespace xabsl
