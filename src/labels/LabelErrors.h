#pragma once
#include <map>
#include <string>
#include <vector>

#include "base/Time.h"
#include "labels/BallLabels.h"
#include "labels/FieldLabels.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LinesPercept.h"
#include "representations/perception/PlayersPercept.h"

namespace gt {

/// What a person saw in the images of one log, by the images' numbers.
struct ImageLabels {
  std::map<int, BallLabel> balls;
  std::map<int, FieldLabel> fields;

  bool empty() const { return balls.empty() && fields.empty(); }
  bool operator==(const ImageLabels&) const = default;
};

/// The files of labels beside each other, as in tests/real: BASE-labels.csv has the balls,
/// BASE-field.csv everything else. One of them may be missing when they are read; a set without
/// balls, or without anything else, has only the other file.
Result<ImageLabels> readImageLabels(const std::string& base);
Result<void> writeImageLabels(const std::string& base, const ImageLabels& labels);

/// What vision found in one image.
struct SeenInImage {
  Time time;
  BallPercept ball;
  LandmarksPercept landmarks;
  LinesPercept lines;
  PlayersPercept players;
  CameraMatrix matrix;
};

/// How far from a label something was found.
struct LabelError {
  int picture = 0;
  Time time;
  std::string what;      ///< ball, lines, post, or a box's name.
  bool labeled = false;  ///< Otherwise it was found where nothing is.
  bool found = false;
  double degrees = 0;   ///< Between label and percept, as seen from the camera, if both are there.
  double distance = 0;  ///< mm to what is labeled, by the label; 0: not known.
};

/// Compares what was found in an image with its labels; those of another time are passed over. The
/// ball's distance follows from the label's radius and the ball's (mm), all others from where they
/// stand on the ground.
std::vector<LabelError> errorsIn(const ImageLabels& labels, int picture, const SeenInImage& seen,
                                 double ballRadius);

}  // namespace gt
