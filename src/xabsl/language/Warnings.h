#pragma once

#include "xabsl/language/Model.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

/// Warns of what is sound, but hardly meant: states that are never entered or can only follow one
/// another, parameters that are not set, what is declared and never used.
void warnAbout(const Model& model, Reporter& reporter);

}  // namespace xabsl
