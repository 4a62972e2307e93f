#include "xabsl/Behavior.h"

#include <string>

#include "Fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  xabsl::compile("fuzz.xabsl", {{"fuzz.xabsl", std::string{gt::textOf(data, size)}}});
  return 0;
}
