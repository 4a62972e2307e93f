#include <string>

#include "Fuzz.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "motionnet/Compiler.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto compilation =
      motionnet::compile({{"fuzz.mof", std::string{gt::textOf(data, size)}}}, gt::motionRules());
  if (compilation) (void)!gt::motionNetOf(compilation.net, "fuzz");
  return 0;
}
