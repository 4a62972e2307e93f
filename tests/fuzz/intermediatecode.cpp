#include "xabsl/formats/intermediate/IntermediateCode.h"

#include <cstdlib>
#include <string>

#include "Fuzz.h"
#include "xabsl/engine/Engine.h"
#include "xabsl/engine/VirtualSymbols.h"

namespace {

/// Whatever was read can be executed.
void runCycles(const xabsl::Behavior& behavior) {
  if (behavior.model().largestActivation > 10'000) return;  // takes long, and shows no more
  const xabsl::VirtualSymbols world(behavior.model());
  xabsl::Engine::Creation creation = xabsl::Engine::create(behavior, world.symbols());
  if (!creation.engine) return;
  xabsl::TraceRecorder recorder(1000);
  for (int i = 0; i < 5; ++i) {
    creation.engine->record(i % 2 == 0 ? &recorder : nullptr);
    creation.engine->execute(100 * i);
    static_cast<void>(toString(creation.engine->activations()));
  }
}

}  // namespace

/// What was read must be the same when it was written and read again.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const xabsl::Compilation read = xabsl::readIntermediateCode("fuzz.dat", gt::textOf(data, size));
  if (!read.behavior) return 0;
  runCycles(*read.behavior);
  const xabsl::Model& model = read.behavior->model();
  const xabsl::IntermediateCode code = xabsl::writeIntermediateCode(model, model.dialect);
  if (!code.text) std::abort();
  const xabsl::Compilation again = xabsl::readIntermediateCode("fuzz.dat", *code.text);
  if (!again.behavior) std::abort();
  const xabsl::IntermediateCode rewritten =
      xabsl::writeIntermediateCode(again.behavior->model(), model.dialect);
  if (!rewritten.text) std::abort();
  // A file that is sound in both dialects is taken for 3.1.
  if (again.behavior->model().dialect == model.dialect && *rewritten.text != *code.text)
    std::abort();
  return 0;
}
