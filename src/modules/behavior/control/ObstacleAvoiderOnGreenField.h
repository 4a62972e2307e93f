#pragma once
#include "debug/Debug.h"
#include "modules/behavior/Tasks.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *ObstacleAvoiderOnGreenField* of SensorBehaviorControl: a demonstration, in which the
/// robot walks about and avoids everything that is not green (report 3, table of solutions). It
/// uses no percepts and no models: the height of the green in the columns of the image determines
/// the walking speed and the side to which the robot turns.
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
          field<&P::forward>(Unit::mmPerS, "walking speed if everything ahead is green", {0, 400}),
          field<&P::turn>(Unit::degPerS, "turning speed if the path is blocked", {0, 200}),
          field<&P::steer>("gain of the turn to the greener side", {0, 10}),
          field<&P::blocked>(
              "height of the green ahead below which the path is blocked, as a share of the image",
              {0, 1}),
          field<&P::free>(
              "height of the green ahead above which the path is free, as a share of the image",
              {0, 1}),
          field<&P::headTilt>(Unit::deg, "tilt of the head to look at the ground", {-88, 43}),
          field<&P::gap>(Unit::pixel, "length of a gap that ends the green in a column", {1, 100})};
    }
  };
  Parameters parameters;

  /// Provides a walk ahead or a turn, and a head request to look at the ground ahead. Without an
  /// image the robot stands.
  void update(const Image& image, const ColorTable64& colors, const FrameInfo& frame,
              MotionRequest& motion, HeadMotionRequest& head, LedRequest& leds, SoundRequest& sound,
              Debug& debug);

 private:
  /// The height of the green from the bottom of a column, as a share of the image.
  double greenIn(const Image& image, const ColorTable64& colors, int x) const;

  bool turnsLeft_ = true;  ///< Kept as long as the path is blocked.
  bool blocked_ = false;
};
static_assert(complete<ObstacleAvoiderOnGreenField::Parameters>);

}  // namespace gt
