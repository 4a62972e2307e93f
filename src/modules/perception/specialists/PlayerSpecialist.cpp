#include "modules/perception/specialists/PlayerSpecialist.h"

#include <algorithm>
#include <cmath>

#include "modules/perception/scanning/FieldView.h"

namespace gt {
namespace {

constexpr int minPixels = 3;            // Of tricot on a scan line.
constexpr int minClusterPixels = 8;     // Of tricot in all of a robot.
constexpr int minGreen = 2;             // Pixels below a foot.
constexpr int minWall = 4;              // White pixels of a wall.
constexpr int minLeg = 3;               // Pixels above it.
constexpr double typicalHeight = 55;    // mm: of a piece of tricot, seen from the side
constexpr double mostHeight = 120;      // mm: the same with that of a leg below
constexpr double typicalTricot = 6400;  // mm2: of a side
constexpr double mostTricot = 11600;    // mm2: with legs and back
constexpr double typicalShare = 0.65;   // of the way to where a leg leaves the image
constexpr double footToMiddle = 105;    // mm: from the nearest foot to the middle of the body
constexpr double sideToMiddle = 40;     // mm: from what is seen of a tricot to it
constexpr double bodyWidth = 300;       // mm: the longest that a robot is seen
constexpr double footBeside = 60;       // mm: feet stand that far beside the tricot
constexpr double farBelow = 1e4;        // pixels: to the end of the image
// Tricots are lower than the camera; its matrix errs by 1.5 degrees.
constexpr double highestTricot = fromDegrees(4);

// What is below the tricot and does not belong to the ground, nor to what lies on it.
bool isBody(ColorClass color) {
  constexpr ColorSet bodyColors{ColorClass::gray, ColorClass::black, ColorClass::red,
                                ColorClass::blue, ColorClass::noColor};
  return bodyColors.contains(color);
}

double focal(const CameraImage& picture) {
  return picture.matrix.info.focalX;
}

}  // namespace

void PlayerSpecialist::find(const CameraImage& picture,
                            std::span<const PlayerIndication> indications,
                            PlayersPercept& percept) {
  feet_.clear();
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    std::vector<Vector2d>& players = percept.players[team];
    players.clear();
    cluster_.clear();
    for (const PlayerIndication& indication : indications) {
      if (indication.team != team || indication.pixels < minPixels) continue;
      if (elevation(picture.ray(indication.upper)) > highestTricot) continue;
      if (!cluster_.empty()) {
        // A robot seen at this size is at most that far away.
        const int pixels = std::max(indication.pixels, cluster_.back().pixels);
        const double widest = bodyWidth / 2 * pixels / typicalHeight;
        if (indication.u - cluster_.back().u > std::max(8., widest)) endCluster(picture, players);
      }
      cluster_.push_back(indication);
    }
    endCluster(picture, players);
  }
}

void PlayerSpecialist::endCluster(const CameraImage& picture, std::vector<Vector2d>& players) {
  int pixels = 0, longest = 0, lines = 0;
  for (const PlayerIndication& piece : cluster_) {
    lines += &piece == &cluster_.front() || piece.u != (&piece - 1)->u ? 1 : 0;
    pixels += piece.pixels;
    longest = std::max(longest, piece.pixels);
  }
  if (pixels >= minClusterPixels) {
    const double width = cluster_.back().u - cluster_.front().u + 1, area = pixels * width / lines;
    const double left = azimuth(picture.ray(cluster_.front().upper));
    const double right = azimuth(picture.ray(cluster_.back().upper));
    const double bearing = right + normalize(left - right) / 2;
    lookForFeet(picture);
    if (std::min(foot_, border_) == farthestOnGround) return cluster_.clear();
    // How far away it looks if `height` of it are the longest piece and `surface` is all of it.
    const auto bySize = [&](double height, double surface) {
      return focal(picture) * std::min(height / longest, std::sqrt(surface / area));
    };
    // Of a robot so close that its feet are not in the image only the size gives the distance.
    const bool byFoot = foot_ < border_;
    const double distance = byFoot ? footToMiddle + std::min(foot_, bySize(mostHeight, mostTricot))
                                   : sideToMiddle + std::min(typicalShare * border_,
                                                             bySize(typicalHeight, typicalTricot));
    players.push_back(picture.matrix.pose.translation.head<2>() + distance * direction(bearing));
  }
  cluster_.clear();
}

// Below a tricot, or a place beside it, come legs, then green. The first green below the tricot may
// be seen between the legs, the last one before `end` is at a foot. A leg that leaves the image
// stands nearer than that. What is seen above a wall has no foot.
void PlayerSpecialist::follow(const CameraImage& picture, double u, double v, double end,
                              Which which) {
  int green = 0, white = 0, body = which == Which::first ? minGreen : 0;
  const Vector2d& down = picture.horizon.down;
  const Vector2d start = picture.horizon.toPicture(u, v);
  if (!(v < end)) return;
  const int length = std::min(stepsInImage(picture.image.info, start, down),
                              static_cast<int>(std::ceil(std::min(end - v, farBelow))));
  PixelWalk walk{picture.image, {.start = start, .step = down}};
  std::optional<Vector2d> foot;
  const bool aboveHorizon = v < 0;
  const ColorClass others =
      cluster_.front().team == TeamColor::red ? ColorClass::blue : ColorClass::red;
  for (int i = 0; i < length; ++i, walk.step()) {
    const ColorClass color = picture.colors[walk.pixel()];
    white += color == ColorClass::white ? 1 : 0;
    if (color == others || (aboveHorizon && white >= minWall)) return;
    green = color == ColorClass::green ? green + 1 : 0;
    // At a line of the field colors are mixed that look like a leg's.
    if (which == Which::last && color == ColorClass::white) body = 0;
    body += isBody(color) ? 1 : 0;
    if (green < minGreen) continue;
    if (body >= (which == Which::first ? minGreen : minLeg))
      foot = start + down * (i - minGreen + 0.5);
    if (foot && which == Which::first) break;
    body = 0;
  }
  const auto distanceOf = [&](const Vector2d& at) {
    const auto place = onGround(picture, at);
    return place ? (*place - picture.matrix.pose.translation.head<2>()).norm() : farthestOnGround;
  };
  if (foot) {
    feet_.push_back(*foot);
    foot_ = std::min(foot_, distanceOf(*foot));
  } else if (which == Which::first && body > minGreen) {
    border_ = std::min(border_, distanceOf(start + down * (length - 1)));
  }
}

// Not all foot points are below a foot, some are below the body: the smallest distance counts. The
// legs of the side that is nearer reach further down, and stand beside the tricot, too.
void PlayerSpecialist::lookForFeet(const CameraImage& picture) {
  foot_ = border_ = farthestOnGround;
  for (const PlayerIndication& piece : cluster_)
    follow(picture, piece.u, picture.horizon.fromImage(piece.lower).y(), farBelow, Which::first);
  if (foot_ == farthestOnGround) return;
  const double until = 0.6 * foot_;
  const double bearing = azimuth(picture.ray(cluster_[cluster_.size() / 2].lower));
  const Vector2d below = until * direction(bearing);
  const double end =
      picture.horizon
          .fromImage(picture.pointOf({below.x(), below.y(), -picture.matrix.pose.translation.z()}))
          .y();
  const double beside = focal(picture) * footBeside / std::max(foot_, footBeside);
  std::size_t piece = 0;
  for (double u = cluster_.front().u - beside; u <= cluster_.back().u + beside; u += 2) {
    while (piece + 1 < cluster_.size() && cluster_[piece + 1].u < u + 1) ++piece;
    follow(picture, u, picture.horizon.fromImage(cluster_[piece].lower).y(), end, Which::last);
  }
}

}  // namespace gt
