#pragma once
#include <array>
#include <vector>

#include "base/Enum.h"
#include "labels/BallLabels.h"
#include "measure/Figures.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// The cause of a difference between the two distances of a ball.
enum class Verdict { notCompared, agree, visionIsOff, cameraMatrixIsOff, notKnown };

/// The relative difference of the ball's distance by projection to that by size (0.1: 10 %
/// farther); 0 if one of them is unknown.
double differenceOfDistances(const BallPercept& ball);

/// Compares the two distances of a ball nearer than 1.5 m. If they differ by more than 10 %, a
/// person's label decides: if vision's radius is within 5 % of the label's, the size is correct and
/// the camera matrix is wrong.
Verdict compareDistances(const BallPercept& ball, const BallLabel* label);

/// Compares the ball percepts of a log's images with a person's labels.
class Comparison {
 public:
  /// Adds an image; `label` is null if the image is not labeled.
  void add(const BallPercept& ball, const BallLabel* label);

  /// The number of images in which a person saw the ball in this way, and the number of those in
  /// which vision found it.
  int pictures(BallView view) const { return total_[static_cast<std::size_t>(view)]; }
  int found(BallView view) const { return found_[static_cast<std::size_t>(view)]; }

  /// A summary of a few lines for people.
  std::string text() const;
  /// Figures such as vision.real.ball.whole.found.
  Figures figures() const;

 private:
  std::array<int, enumCount<BallView>> total_{}, found_{};
  std::array<int, enumCount<Verdict>> verdicts_{};
  std::vector<double> centerErrors_, radiusErrors_;  ///< Errors of completely visible balls, in
                                                     ///< pixels.
  std::vector<double> ratios_;  ///< Distance by projection divided by that by size, of all compared
                                ///< balls.
};

}  // namespace gt
