#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "colors/LabelledPicture.h"

namespace gt {

/// Where pictures come from: a simulated scene, a log, or files.
struct PictureSource {
  std::string scene;
  std::uint64_t seed = 1;
  int moments = 400;    ///< Each gives one picture a robot.
  double light = 0.15;  ///< By which share there is more or less of it than in the scene.

  std::string log;                 ///< A log (.mcap), or one of the real robot of 2009.
  std::vector<std::string> files;  ///< Pictures as JPEG.
  std::string labels;              ///< A person's, for the pictures of a log or of files.

  bool simulated() const { return log.empty() && files.empty(); }
};

/// Calls visit(name, picture) for all pictures of a source until it returns false. Simulated ones
/// come with the class of each pixel, in light that is never the same twice; the others with the
/// regions of the labels, if there is a file of labels. Labels for no picture are an error.
using PictureVisitor = std::function<bool(const std::string&, const LabelledPicture&)>;
Result<void> forEachPicture(const PictureSource& source, const PictureVisitor& visit);

}  // namespace gt
