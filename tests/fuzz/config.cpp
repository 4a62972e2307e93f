#include "streams/Config.h"

#include "Fuzz.h"
#include "representations/infrastructure/CameraSettings.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/LandmarksPercept.h"
#include "robot/ConfigFolder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = gt::textOf(data, size);
  gt::FieldDimensions field;
  (void)!gt::parseConfig(text, "fuzz", field);
  gt::LandmarksPercept percept;
  (void)!gt::parseConfig(text, "fuzz", percept);
  gt::PerRobot<gt::CameraSettings> cameras;
  (void)gt::collectPerRobot(text, "fuzz", cameras);
  gt::NetworkSettings network;
  (void)!gt::parseConfig(text, "fuzz", network);
  (void)!gt::parseLocation(text, "fuzz");
  const auto space = text.find(' ');
  if (space != text.npos)
    (void)!gt::setByPath(percept, text.substr(0, space), text.substr(space + 1));
  return 0;
}
