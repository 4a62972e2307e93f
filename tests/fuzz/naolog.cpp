#include "logs/NaoLog.h"

#include <string>

#include "Fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto log = gt::parseNaoLog(std::string{gt::textOf(data, size)}, "fuzz");
  if (!log) return 0;
  gt::Image image;
  for (const gt::NaoImage& picture : log->pictures) (void)!log->decode(picture, image);
  return 0;
}
