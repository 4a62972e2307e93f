#pragma once
#include <span>
#include <vector>

#include "modules/perception/LineScanner.h"
#include "representations/perception/PlayersPercept.h"

namespace gt {

/// Finds other robots from what the scan lines saw of their tricots (report 3.2.6).
class PlayerSpecialist {
 public:
  /// Fills in the percept's players; the indications must be in the order of their scan lines.
  void find(const Picture& picture, std::span<const PlayerIndication> indications,
            PlayersPercept& percept);

 private:
  /// What one scan line tells of a robot: from the camera, on the ground.
  struct Sight {
    double azimuth = 0, distance = 0;
    int pixels = 0;
  };

  void findTeam(const Picture& picture, std::span<const PlayerIndication> indications,
                TeamColor team, std::vector<Vector2d>& players);
  void endCluster(const Picture& picture, std::vector<Vector2d>& players);

  std::vector<Sight> cluster_;
};

}  // namespace gt
