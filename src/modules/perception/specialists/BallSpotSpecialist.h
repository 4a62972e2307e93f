#pragma once
#include <optional>

#include "modules/perception/scanning/CameraImage.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// Finds a black and white ball of which distance, noise and light leave hardly an edge: a spot as
/// large as a ball on the ground is there, black and white compared with the brightest pixel
/// around, with nothing black beside it and green before it.
class BallSpotSpecialist {
 public:
  /// Fills in the percept, all but `time`.
  void find(const CameraImage& picture, double ballRadius, BallPercept& percept) const;

 private:
  struct Spot {
    Vector2d center;
    double radius = 0;  ///< Pixels.
    double score = 0;   ///< How well it fits, above 0.
  };

  /// The best one in the image, of score 0 if there is none. `growth` is how much larger (pixels) a
  /// ball is with each pixel that it lies below the horizon.
  static Spot best(const CameraImage& picture, double growth);
  /// Moved to where its neighbors in place and radius fit best.
  static Spot fitted(const CameraImage& picture, Spot spot);
  static std::optional<Spot> spotAt(const CameraImage& picture, const Vector2d& center,
                                    double radius);
};

}  // namespace gt
