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

/// Compares the points on lines, the goals and the camera matrices of a log's images with what a
/// person saw in them.
class FieldComparison {
 public:
  /// One more image; a label for another time is passed over.
  void add(const LinesPercept& lines, const LandmarksPercept& landmarks, const CameraMatrix& matrix,
           const FieldLabel& label);

  /// What the labels of one more image say of its camera matrix; empty if not enough.
  void add(const std::optional<MatrixCorrection>& correction);

  /// The summary, for people: a few lines.
  std::string text() const;
  /// Adds vision.real.lines.found and the like.
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
  std::vector<double> tilts_, rolls_;                 ///< Of the corrections, degrees.
};

}  // namespace gt
