#pragma once
#include <array>
#include <vector>

#include "base/Enum.h"
#include "labels/BallLabels.h"
#include "measure/Figures.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// Who is to blame where the two distances of a ball differ.
enum class Verdict { notCompared, agree, visionIsOff, cameraMatrixIsOff, notKnown };

/// How much further away the projection puts the ball than its size does; 0 if one is not known.
double differenceOfDistances(const BallPercept& ball);

/// Compares the two distances of a ball nearer than 1.5 m. Where they differ by more than 10 %, a
/// person's circle decides: if vision's radius is within 5 % of it, the size is right and the
/// camera matrix is off.
Verdict compareDistances(const BallPercept& ball, const BallLabel* label);

/// Compares what vision found in a log's images with what a person saw in them.
class Comparison {
 public:
  /// One more image; `label` is null where nobody looked.
  void add(const BallPercept& ball, const BallLabel* label);

  /// The numbers of images in which a person saw the ball that way, and of those in which vision
  /// found it.
  int pictures(BallView view) const { return total_[static_cast<std::size_t>(view)]; }
  int found(BallView view) const { return found_[static_cast<std::size_t>(view)]; }

  /// The summary, for people: a few lines.
  std::string text() const;
  /// vision.real.ball.whole.found and the like.
  Figures figures() const;

 private:
  std::array<int, enumCount<BallView>> total_{}, found_{};
  std::array<int, enumCount<Verdict>> verdicts_{};
  std::vector<double> centerErrors_, radiusErrors_;  ///< Of whole balls, pixels.
  std::vector<double> ratios_;  ///< Projection over size, of the distances compared.
};

}  // namespace gt
