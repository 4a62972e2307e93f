#include "modules/perception/PlayerSpecialist.h"

#include <algorithm>

#include "modules/perception/FieldView.h"

namespace gt {
namespace {

constexpr int minPixels = 3;         // Of tricot on a scan line.
constexpr int minClusterPixels = 8;  // Of tricot in all of a robot.
constexpr double tricotTop = 190;    // mm: typical height of the back of a robot that walks
constexpr double tricotHeight = 60;  // mm: typical height of its tricot, seen from the side
constexpr double mostTricot = 120;   // mm: the most of it in a row, with that of a leg below
constexpr double bodyRadius = 10;    // mm: from what is nearest of a robot to its middle
constexpr double bodyWidth = 300;    // mm: the longest that a robot is seen

}  // namespace

void PlayerSpecialist::find(const Picture& picture, std::span<const PlayerIndication> indications,
                            PlayersPercept& percept) {
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    percept.players[team].clear();
    findTeam(picture, indications, team, percept.players[team]);
  }
}

void PlayerSpecialist::findTeam(const Picture& picture,
                                std::span<const PlayerIndication> indications, TeamColor team,
                                std::vector<Vector2d>& players) {
  const Vector2d camera = picture.matrix.pose.translation.head<2>();
  cluster_.clear();
  for (const PlayerIndication& indication : indications) {
    if (indication.team != team || indication.pixels < minPixels) continue;
    Sight sight;
    sight.azimuth = azimuth(picture.ray(indication.upper));
    sight.pixels = indication.pixels;
    std::optional<Vector2d> place;
    if (indication.footKnown) place = onGround(picture, indication.foot);
    if (!place && indication.upperKnown) place = onPlane(picture, indication.upper, tricotTop);
    sight.distance = place ? (*place - camera).norm()
                           : picture.matrix.info.focalX * tricotHeight / indication.pixels;
    // Through its legs the green behind a close robot is seen.
    sight.distance =
        std::min(sight.distance, picture.matrix.info.focalX * mostTricot / indication.pixels);
    if (!cluster_.empty()) {
      const Sight& last = cluster_.back();
      const double gap = std::abs(normalize(sight.azimuth - last.azimuth));
      if (gap * std::min(sight.distance, last.distance) > bodyWidth / 2)
        endCluster(picture, players);
    }
    cluster_.push_back(sight);
  }
  endCluster(picture, players);
}

// Not all foot points are below a foot, some are below the body: the smallest distance counts, but
// for the one scan line in eight that may have got lost.
void PlayerSpecialist::endCluster(const Picture& picture, std::vector<Vector2d>& players) {
  int pixels = 0;
  for (const Sight& sight : cluster_) pixels += sight.pixels;
  if (pixels >= minClusterPixels) {
    const double middle = (cluster_.front().azimuth + cluster_.back().azimuth) / 2;
    const auto least = cluster_.begin() + static_cast<std::ptrdiff_t>(cluster_.size() / 8);
    std::nth_element(cluster_.begin(), least, cluster_.end(),
                     [](const Sight& a, const Sight& b) { return a.distance < b.distance; });
    players.push_back(picture.matrix.pose.translation.head<2>() +
                      (least->distance + bodyRadius) * direction(middle));
  }
  cluster_.clear();
}

}  // namespace gt
