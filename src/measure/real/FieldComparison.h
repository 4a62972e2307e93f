#pragma once
#include <optional>
#include <vector>

#include "labels/FieldLabels.h"
#include "measure/Figures.h"
#include "measure/real/MatrixFit.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LinesPercept.h"

namespace gt {

/// Compares the points on lines, the goals and the camera matrices of a log's images with a
/// person's labels.
class FieldComparison {
 public:
  /// Adds an image; a label with another time is ignored.
  void add(const LinesPercept& lines, const LandmarksPercept& landmarks, const CameraMatrix& matrix,
           const FieldLabel& label);

  /// Adds the correction of the camera matrix computed from an image's labels; empty if these are
  /// insufficient.
  void add(const std::optional<MatrixCorrection>& correction);

  /// A summary of a few lines for people.
  std::string text() const;
  /// Adds figures such as vision.real.lines.found.
  void addTo(Figures& figures) const;

 private:
  void addLines(const LinesPercept& lines, const CameraMatrix& matrix, const FieldLabel& label);
  void addGoal(const LandmarksPercept& landmarks, const CameraMatrix& matrix,
               const FieldLabel& label);

  int pictures_ = 0;
  std::vector<double> labelsFound_, pointsOnLabels_;  ///< 100 or 0 each.
  std::vector<double> lineErrors_;                    ///< Pixels.
  std::vector<double> goalsFound_, goalsFalse_;       ///< 100 or 0 each image.
  std::vector<double> postErrors_;                    ///< Degrees.
  std::vector<double> matrixKnown_;                   ///< 100 or 0 each image.
  std::vector<double> tilts_, rolls_;                 ///< Corrections, in degrees.
};

}  // namespace gt
