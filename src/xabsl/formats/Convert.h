#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// The forms in which a behavior may be written.
enum class Form { xml21, xml31, text31 };

/// The result of converting: the files, named relative to the file with the agents, or errors.
struct Conversion {
  std::optional<VirtualFiles> files;
  std::vector<Diagnostic> diagnostics;
};

/// Writes a behavior in another form or in the same one, without changing its meaning. Comments,
/// titles, units and ranges are kept. Each option and each group of symbols gets a file. Constructs
/// that the other form cannot express are reported as errors. `root` names the new file with the
/// agents.
Conversion convert(const std::string& path, Form form, const std::string& root);

/// Converts files in memory.
Conversion convert(const std::string& path, const VirtualFiles& files, Form form,
                   const std::string& root);

}  // namespace xabsl
