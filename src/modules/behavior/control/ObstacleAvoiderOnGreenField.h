#pragma once
#include "debug/Debug.h"
#include "modules/behavior/Tasks.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *ObstacleAvoiderOnGreenField* of SensorBehaviorControl: a demonstration, in which the
/// robot walks about and avoids everything that is not green (report 3, table of solutions). No
/// percepts, no models: how high green reaches in the columns of the image decides how fast the
/// robot walks and to which side it turns.
class ObstacleAvoiderOnGreenField {
 public:
  struct Parameters {
    double forward = 180;
    double turn = 80;
    double steer = 1.5;
    double blocked = 0.25;
    double free = 0.6;
    double headTilt = -25;
    int gap = 4;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::forward>(Unit::mmPerS, "where all is green", {0, 400}),
          field<&P::turn>(Unit::degPerS, "where nothing ahead is", {0, 200}),
          field<&P::steer>("how strongly it turns to the greener side", {0, 10}),
          field<&P::blocked>(
              "the way is blocked if green ahead reaches less far up, as a share of the image",
              {0, 1}),
          field<&P::free>("the way is free if it reaches farther", {0, 1}),
          field<&P::headTilt>(Unit::deg, "at which the robot looks at the ground", {-88, 43}),
          field<&P::gap>(Unit::pixel, "so much that is not green ends the green", {1, 100})};
    }
  };
  Parameters parameters;

  /// Provides a walk ahead or a turn, and that the robot looks at the ground before it; to stand
  /// without an image.
  void update(const Image& image, const ColorTable64& colors, const FrameInfo& frame,
              MotionRequest& motion, HeadMotionRequest& head, LedRequest& leds, SoundRequest& sound,
              Debug& debug);

 private:
  /// How high green reaches from the bottom of a column, as a share of the image.
  double greenIn(const Image& image, const ColorTable64& colors, int x) const;

  bool turnsLeft_ = true;  ///< Kept as long as the way is blocked.
  bool blocked_ = false;
};
static_assert(complete<ObstacleAvoiderOnGreenField::Parameters>);

}  // namespace gt
