#pragma once
#include <optional>
#include <span>
#include <vector>

#include "modules/perception/scanning/IndicationScanner.h"
#include "representations/perception/PlayersPercept.h"

namespace gt {

/// Finds other robots from what the scan lines saw of their tricots (report 3.2.6).
class PlayerSpecialist {
 public:
  /// Fills in the percept's players; the indications must be in the order of their scan lines.
  void find(const CameraImage& picture, std::span<const PlayerIndication> indications,
            PlayersPercept& percept);

  /// The foot points of the last image, for drawings.
  const std::vector<Vector2d>& feet() const { return feet_; }

 private:
  /// Whether the first or the last foot on a line is wanted.
  enum class Which { first, last };

  void endCluster(const CameraImage& picture, std::vector<Vector2d>& players);
  void lookForFeet(const CameraImage& picture);
  void follow(const CameraImage& picture, double u, double v, double end, Which which);

  std::vector<PlayerIndication> cluster_;
  std::vector<Vector2d> feet_;
  double foot_ = 0;    ///< mm, to the nearest foot of the cluster.
  double border_ = 0;  ///< mm, to where the nearest leg leaves the image.
};

}  // namespace gt
