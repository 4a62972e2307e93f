#include "streams/Json.h"

#include "Fuzz.h"
#include "representations/perception/LandmarksPercept.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto json = gt::parseJson(gt::textOf(data, size), "fuzz");
  gt::LandmarksPercept percept;
  if (json) (void)!gt::fromJson(*json, percept);
  return 0;
}
