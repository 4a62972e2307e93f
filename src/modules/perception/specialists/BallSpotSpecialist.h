#pragma once
#include <optional>

#include "modules/perception/scanning/CameraImage.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// Finds a black and white ball that hardly has edges because of its distance, noise and light.
/// Searches for a spot of the size of a ball on the ground that is black and white relative to the
/// brightest pixel around it, with no black beside it and green in front of it.
class BallSpotSpecialist {
 public:
  /// Fills in the percept except `time`. `ballRadius` in mm.
  void find(const CameraImage& picture, double ballRadius, BallPercept& percept) const;

 private:
  struct Spot {
    Vector2d center;
    double radius = 0;  ///< pixels
    double score = 0;   ///< Quality of the fit; greater than 0 if it is a ball.
  };

  /// The spot with the highest score in the image; score 0 if there is none. `growth` is the
  /// increase of a ball's radius (pixels) for each pixel that it lies below the horizon.
  static Spot best(const CameraImage& picture, double growth);
  /// The spot moved to the neighboring position and radius with the highest score.
  static Spot fitted(const CameraImage& picture, Spot spot);
  static std::optional<Spot> spotAt(const CameraImage& picture, const Vector2d& center,
                                    double radius);
};

}  // namespace gt
