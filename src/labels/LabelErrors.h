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

/// All labels of one log's images, by image number.
struct ImageLabels {
  std::map<int, BallLabel> balls;
  std::map<int, FieldLabel> fields;

  bool empty() const { return balls.empty() && fields.empty(); }
  bool operator==(const ImageLabels&) const = default;
};

/// Reads or writes a pair of label files, as in tests/real: BASE-labels.csv contains the balls,
/// BASE-field.csv all other labels. One of them may be missing when they are read. Only one file is
/// written if there are no balls, or only balls.
Result<ImageLabels> readImageLabels(const std::string& base);
Result<void> writeImageLabels(const std::string& base, const ImageLabels& labels);

/// The percepts of one image.
struct SeenInImage {
  Time time;
  BallPercept ball;
  LandmarksPercept landmarks;
  LinesPercept lines;
  PlayersPercept players;
  CameraMatrix matrix;
};

/// The deviation of a percept from its label.
struct LabelError {
  int picture = 0;
  Time time;
  std::string what;      ///< ball, lines, post, or name of a box.
  bool labeled = false;  ///< If false, something was found where nothing is.
  bool found = false;
  double degrees = 0;   ///< Angle between label and percept, as seen from the camera, if both
                        ///< exist.
  double distance = 0;  ///< Distance (mm) of the labeled object, computed from the label; 0:
                        ///< unknown.
};

/// Compares the percepts of an image with its labels; labels with another time are skipped. The
/// distance of the ball is computed from the label's radius and the ball's radius (mm), all other
/// distances from the objects' positions on the ground.
std::vector<LabelError> errorsIn(const ImageLabels& labels, int picture, const SeenInImage& seen,
                                 double ballRadius);

}  // namespace gt
