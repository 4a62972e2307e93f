#pragma once
#include <optional>
#include <span>
#include <vector>

#include "modules/perception/scanning/IndicationScanner.h"
#include "representations/perception/PlayersPercept.h"

namespace gt {

/// Finds other robots from the sections of their tricots on scan lines (report 3.2.6).
class PlayerSpecialist {
 public:
  /// Fills in the percept's players; the indications must be in the order of their scan lines.
  void find(const CameraImage& picture, std::span<const PlayerIndication> indications,
            PlayersPercept& percept);

  /// The foot points in the last image (pixels), for drawings.
  const std::vector<Vector2d>& feet() const { return feet_; }

 private:
  /// Selects the first or the last foot on a line.
  enum class Which { first, last };

  void endCluster(const CameraImage& picture, std::vector<Vector2d>& players);
  void lookForFeet(const CameraImage& picture);
  double nearestFoot();
  /// Distance computed from the tricot's lower end (mm); `farthestOnGround` if that is not seen.
  double distanceOfLowerEnd(const CameraImage& picture) const;
  /// The tangent of the elevation of the tricot's upper end; nothing if it is not seen.
  std::optional<double> slopeOfUpperEnd(const CameraImage& picture) const;
  /// Distances from the camera to the middle of the robot (mm): if a foot is seen, and if none is
  /// seen.
  double distanceByFoot(const CameraImage& picture);
  double distanceByTricot(const CameraImage& picture, double bySize) const;
  void follow(const CameraImage& picture, double u, double v, double end, Which which);

  std::vector<PlayerIndication> cluster_;
  std::vector<Vector2d> feet_;
  std::vector<double> distances_;  ///< Distances of all feet of the cluster, mm.
  double foot_ = 0;                ///< Distance of the nearest foot of the cluster, mm.
  /// Distance of the point where the nearest leg leaves the image, mm.
  double border_ = 0;
};

}  // namespace gt
