#include "Picture.h"

#include <fmt/core.h>

#include <cstdio>

namespace gt {

Result<void> takePicture(const PictureOptions& options) {
  auto match = Match::make(options.match);
  if (!match) return match.error();
  while (static_cast<double>((*match)->time().ms) < options.time * 1000 && !(*match)->finished())
    (*match)->step();
  SceneCamera camera = options.camera;
  camera.from = {options.from[0], options.from[1], options.from[2]};
  camera.at = {options.at[0], options.at[1], options.at[2]};
  Sheet sheet{camera.width, camera.height};
  sheet.paint(scenePicture((*match)->simulation().world(), camera), {0, 0});
  if (const auto done = sheet.write(options.out); !done) return done;
  fmt::print("Image: {}\n", options.out);
  return {};
}

}  // namespace gt
