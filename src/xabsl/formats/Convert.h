#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// The forms in which a behavior may be written.
enum class Form { xml21, xml31, text31 };

/// What converting yields: the files, named relative to that with the agents, or what is wrong.
struct Conversion {
  std::optional<VirtualFiles> files;
  std::vector<Diagnostic> diagnostics;
};

/// Writes a behavior anew, in another form or the same, without changing what it means. Comments,
/// titles, units and ranges are kept, with a file for each option and each group of symbols; what
/// the other form cannot say is an error at its place. `root` names the new file with the agents.
Conversion convert(const std::string& path, Form form, const std::string& root);

/// The same from files in memory.
Conversion convert(const std::string& path, const VirtualFiles& files, Form form,
                   const std::string& root);

}  // namespace xabsl
