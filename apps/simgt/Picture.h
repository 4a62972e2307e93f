#pragma once
#include <array>
#include <string>

#include "match/Match.h"
#include "views/ScenePicture.h"

namespace gt {

/// What `simgt picture` was asked for.
struct PictureOptions {
  MatchOptions match;
  double time = 60;                            ///< Seconds after the match's begin.
  std::array<double, 3> from{0, -3600, 2300};  ///< Where the camera is, mm on the field.
  std::array<double, 3> at{0, -150, 0};        ///< Where it looks.
  SceneCamera camera;
  std::string out = "out/picture.png";
};

/// Plays a match up to a time and takes an image of it from beside the field. Returns an
/// error if a file is wrong.
Result<void> takePicture(const PictureOptions& options);

}  // namespace gt
