#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// A compiled behavior. Cheap to copy, never changes; any number of engines, in any threads, may
/// share one.
class Behavior {
 public:
  explicit Behavior(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

  const Model& model() const { return *model_; }
  std::shared_ptr<const Model> shared() const { return model_; }

 private:
  std::shared_ptr<const Model> model_;
};

/// What compiling yields: a behavior if there is no error, and what there is to say.
struct Compilation {
  std::optional<Behavior> behavior;
  std::vector<Diagnostic> diagnostics;
};

/// Compiles XABSL as text, or 2.1 or 3.1 in XML, from the file with the agents and all that it
/// includes. Text is 3.1, or 3.0, which knows no cooperation of robots; XML says what it is.
Compilation compile(const std::string& path, Dialect text = Dialect::xabsl31);

/// The same from files in memory.
Compilation compile(const std::string& path, const VirtualFiles& files,
                    Dialect text = Dialect::xabsl31);

}  // namespace xabsl
