#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// Learns in play by how much images are older than their time stamps: by as much as the angles of
/// flags are off by what the camera turns in that time. Flags stand still, so what their angles
/// change by from one image to the next, beyond what the robot turned, is proportional to how much
/// faster the camera turns. How high a flag is seen follows from its distance: it is off by what
/// the camera nods in that time. The pose of the robot on the field need not be known.
class ImageDelay {
 public:
  /// Learns from what was found in an image, with the camera matrix for which that was taken off
  /// which is known so far. `memory` is the time after which an image counts a third (ms).
  void learn(const LandmarksPercept& landmarks, const CameraMatrix& matrix, const Pose2D& odometry,
             const FieldDimensions& field, double memory);

  double milliseconds() const { return 1000 * seconds_; }

 private:
  /// A flag in an image.
  struct Sighting {
    Time time = never();
    double angle = 0;  ///< As the image's time stamp has it.
    double distance = 0, turning = 0;
    Pose2D odometry;
  };
  void learn(const Sighting& before, const Sighting& now);
  void learnFromHeight(const FlagPercept& flag, const CameraMatrix& matrix,
                       const FieldDimensions& field);

  EnumArray<FlagType, Sighting> last_;
  Time lastImage_ = never();
  double seconds_ = 0;
  double products_ = 0, squares_ = 0;  ///< Of changes of angle and turning, the older the less.
};

}  // namespace gt
