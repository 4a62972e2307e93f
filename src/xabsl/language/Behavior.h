#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// A compiled behavior. It is cheap to copy and immutable; any number of engines, in any threads,
/// may share one.
class Behavior {
 public:
  explicit Behavior(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

  const Model& model() const { return *model_; }
  std::shared_ptr<const Model> shared() const { return model_; }

 private:
  std::shared_ptr<const Model> model_;
};

/// The result of compiling: a behavior if there are no errors, and all messages.
struct Compilation {
  std::optional<Behavior> behavior;
  std::vector<Diagnostic> diagnostics;
};

}  // namespace xabsl
