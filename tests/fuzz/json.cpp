#include "streams/Json.h"

#include <nlohmann/json.hpp>

#include "Fuzz.h"
#include "representations/perception/LandmarksPercept.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto json = gt::parseJson(gt::textOf(data, size), "fuzz");
  gt::LandmarksPercept percept;
  if (!json) return 0;
  (void)!gt::fromJson(*json, percept);
  // All of these are recursive.
  const gt::Json copy = *json;
  (void)copy.dump(-1, ' ', false, gt::Json::error_handler_t::replace);
  return 0;
}
