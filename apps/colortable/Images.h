#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "colors/LabeledImage.h"

namespace gt {

/// Where images come from: a simulated scene, a log, or files.
struct ImageSource {
  DataRoot root;  ///< Of the simulated robots' walk.
  std::string scene;
  std::uint64_t seed = 1;
  int moments = 400;    ///< Each gives one image a robot.
  double light = 0.15;  ///< By which share there is more or less of it than in the scene.

  std::string log;                 ///< A log (.mcap), or one of the real robot of 2009.
  std::vector<std::string> files;  ///< Images as JPEG.
  std::string labels;              ///< A person's, for the images of a log or of files.

  bool simulated() const { return log.empty() && files.empty(); }
};

/// Calls visit(name, image) for all images of a source until it returns false. Simulated ones
/// come with the class of each pixel, in light that is never the same twice; the others with the
/// regions of the labels, if there is a file of labels. Labels for no image are an error.
using ImageVisitor = std::function<bool(const std::string&, const LabeledImage&)>;
Result<void> forEachImage(const ImageSource& source, const ImageVisitor& visit);

}  // namespace gt
