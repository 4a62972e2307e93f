#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// Learns in play by how much images are older than their time stamps (the delay). The delay shifts
/// the angle of a flag by the angle that the camera turns in that time. Flags stand still, so the
/// change of their angles from one image to the next, minus the rotation of the robot, is
/// proportional to the change of the camera's rotational speed. The elevation of a flag follows
/// from its distance; the delay shifts it by the angle that the camera tilts in that time. The pose
/// of the robot on the field need not be known.
class ImageDelay {
 public:
  /// Learns from the flags found in an image, with its camera matrix, which was computed with the
  /// delay known so far. `memory` is the time constant of forgetting (ms). Does nothing if the
  /// matrix is invalid or belongs to another image.
  void learn(const LandmarksPercept& landmarks, const CameraMatrix& matrix, const Pose2D& odometry,
             const FieldDimensions& field, double memory);

  /// The delay (ms).
  double milliseconds() const { return 1000 * seconds_; }

 private:
  /// A flag in an image.
  struct Sighting {
    Time time = never();
    double angle = 0;                  ///< rad, relative to the robot at the image's time stamp.
    double distance = 0, turning = 0;  ///< mm, from the robot; rad/s, of the camera.
    Pose2D odometry;
  };
  void learn(const Sighting& before, const Sighting& now);
  void learnFromHeight(const FlagPercept& flag, const CameraMatrix& matrix,
                       const FieldDimensions& field);

  EnumArray<FlagType, Sighting> last_;
  Time lastImage_ = never();
  double seconds_ = 0;
  /// Of the changes of angle and of rotational speed; older ones have less weight.
  double products_ = 0, squares_ = 0;
};

}  // namespace gt
