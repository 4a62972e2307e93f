#pragma once
#include <string>

#include "base/DataRoot.h"

namespace gt::python {

/// The data root: `root` if it is given, or the variable GT2003_ROOT, the package's own data, the
/// sources that it was built from. Throws Failure if a root that is named is none.
DataRoot findRoot(const std::string& root);

}  // namespace gt::python
