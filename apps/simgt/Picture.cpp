#include "Picture.h"

#include <fmt/core.h>

#include <cstdio>

namespace gt {
namespace {

int fail(const Error& error) {
  fmt::print(stderr, "simgt: {}\n", error.text());
  return 2;
}

}  // namespace

int takePicture(const PictureOptions& options) {
  auto match = Match::make(options.match);
  if (!match) return fail(match.error());
  while (static_cast<double>((*match)->time().ms) < options.time * 1000 && !(*match)->finished())
    (*match)->step();
  SceneCamera camera = options.camera;
  camera.from = {options.from[0], options.from[1], options.from[2]};
  camera.at = {options.at[0], options.at[1], options.at[2]};
  Sheet sheet{camera.width, camera.height};
  sheet.paint(scenePicture((*match)->simulation().world(), camera), {0, 0});
  if (const auto done = sheet.write(options.out); !done) return fail(done.error());
  fmt::print("Image: {}\n", options.out);
  return 0;
}

}  // namespace gt
