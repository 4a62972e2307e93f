#include "modules/perception/specialists/PlayerSpecialist.h"

#include <algorithm>
#include <cmath>

#include "modules/perception/scanning/FieldView.h"

namespace gt {
namespace {

constexpr int minPixels = 2;            // Of tricot on a scan line.
constexpr int minClusterPixels = 8;     // Of tricot in all of a robot.
constexpr int minGreen = 2;             // Pixels below a foot.
constexpr int minWall = 4;              // White pixels of a wall.
constexpr int minLeg = 5;               // Pixels above it.
constexpr double typicalHeight = 55;    // mm: of a piece of tricot, seen from the side
constexpr double typicalTricot = 6400;  // mm2: of a side
constexpr double typicalShare = 0.8;  // of that size, or of the way to where a leg leaves the image
constexpr double sizeWeight = 0.2;    // of the distance by size, against that by the lower end
constexpr double lowerEnd = 85;       // mm above the ground: of a tricot, at a leg
constexpr double upperEnd = 212;      // mm above the ground: of a tricot, on the back
constexpr double leastUpperEnd = 200;  // mm: the same while the robot walks
constexpr double clearlyBelow = 25;    // mm: that a tricot must be lower than the camera
constexpr double upperError = 0.15;    // standard deviation of the upper end's height, as a share
constexpr double mostBeyond = 1.25;    // a robot's distance over that of its lower end
constexpr double footToMiddle = 100;   // mm: from the nearest foot to the middle of the body
constexpr double sideToMiddle = 40;    // mm: from what is seen of a tricot to it
constexpr double footBlur = 0.7;       // pixels of a foot that look green
constexpr double footApart = 200;      // mm: between the feet of a robot, and a share of
constexpr double footError = 0.1;      // their distance, as matrix and image err
constexpr double bodyWidth = 300;      // mm: the longest that a robot is seen
constexpr double footBeside = 60;      // mm: feet stand that far beside the tricot
constexpr double farBelow = 1e4;       // pixels: to the end of the image
// Greatest elevation of a tricot. Tricots are lower than the camera; the rest allows for errors of
// its matrix.
constexpr double highestTricot = fromDegrees(4);

// Returns whether a color below the tricot belongs to a robot, and not to the ground or to objects
// on it.
bool isBody(ColorClass color) {
  constexpr ColorSet bodyColors{ColorClass::gray, ColorClass::black, ColorClass::red,
                                ColorClass::blue, ColorClass::noColor};
  return bodyColors.contains(color);
}

double focal(const CameraImage& picture) {
  return picture.matrix.info.focalX;
}

// The tangent of a point's elevation.
double slopeOf(const CameraImage& picture, const Vector2d& p) {
  const Vector3d ray = picture.ray(p);
  return ray.z() / std::hypot(ray.x(), ray.y());
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
      // The report ignores heads. All of a head is above the camera.
      if (picture.ray(indication.lower).z() > 0) continue;
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
    const double bySize =
        focal(picture) * std::min(typicalHeight / longest, std::sqrt(typicalTricot / area));
    const double distance =
        foot_ < border_ ? distanceByFoot(picture) : distanceByTricot(picture, bySize);
    players.push_back(picture.matrix.pose.translation.head<2>() + distance * direction(bearing));
  }
  cluster_.clear();
}

// A robot has several feet, and several lines meet each of them. A single point nearer than the
// others is no foot.
double PlayerSpecialist::nearestFoot() {
  std::sort(distances_.begin(), distances_.end());
  for (std::size_t i = 0; i + 1 < distances_.size(); ++i)
    if (distances_[i + 1] < (1 + footError) * distances_[i] + footApart) return distances_[i];
  return distances_.front();
}

// The ray to the tricot's lower end meets the plane at its height at the robot, or behind it if
// other parts of the robot hide that end.
double PlayerSpecialist::distanceOfLowerEnd(const CameraImage& picture) const {
  double lowest = 0;
  bool known = false;
  for (const PlayerIndication& piece : cluster_) {
    const double slope = slopeOf(picture, piece.lower);
    if (slope > lowest) continue;
    lowest = slope;
    known = piece.lowerKnown;
  }
  const double below = picture.matrix.pose.translation.z() - lowerEnd;
  const bool meets = known && below > 0 && below < -lowest * farthestOnGround;
  return meets ? -below / lowest : farthestOnGround;
}

std::optional<double> PlayerSpecialist::slopeOfUpperEnd(const CameraImage& picture) const {
  double highest = -1;
  for (const PlayerIndication& piece : cluster_) {
    if (!piece.upperKnown) return std::nullopt;
    highest = std::max(highest, slopeOf(picture, piece.upper));
  }
  return highest;
}

// A foot's ray meets the ground, with the error of the matrix. The height from the foot to the
// tricot's upper end gives the distance without that error. The inverse distances are averaged,
// weighted by their variances.
double PlayerSpecialist::distanceByFoot(const CameraImage& picture) {
  const double foot = nearestFoot(), distance = footToMiddle + foot;
  const double ofLowerEnd = distanceOfLowerEnd(picture);
  if (distance > mostBeyond * ofLowerEnd) return ofLowerEnd;
  const auto slope = slopeOfUpperEnd(picture);
  if (!slope) return distance;
  const double height = picture.matrix.pose.translation.z();
  const double byFoot = 1 / distance, byHeight = (*slope + height / foot) / upperEnd;
  const double bearing = azimuth(picture.ray(cluster_.front().upper));
  const double footVariance = picture.matrix.elevationVariance(bearing) / (height * height);
  const double pixel = 1 / focal(picture);
  const double heightVariance = std::pow(upperError * byFoot, 2) + std::pow(pixel / upperEnd, 2);
  return (footVariance + heightVariance) / (heightVariance * byFoot + footVariance * byHeight);
}

// The feet of a near robot are not in the image; a leg that leaves the image stands nearer than
// where it does. From a camera that is clearly higher than the tricot, the ray to its upper end
// meets the plane at the least height of that end at the robot or behind it (report 3.2.6).
double PlayerSpecialist::distanceByTricot(const CameraImage& picture, double bySize) const {
  const double ofLowerEnd = distanceOfLowerEnd(picture);
  const double distance =
      ofLowerEnd < border_ + footToMiddle
          ? (1 + sizeWeight) / (1 / ofLowerEnd + sizeWeight / (sideToMiddle + bySize))
          : sideToMiddle + typicalShare * std::min(border_, bySize);
  const auto slope = slopeOfUpperEnd(picture);
  const double below = picture.matrix.pose.translation.z() - leastUpperEnd;
  if (!slope || *slope >= 0 || below < clearlyBelow) return distance;
  return std::min(distance, below / -*slope);
}

// Below a tricot, or a place beside it, are legs, then green. The first green below the tricot may
// be seen between the legs; the last green before `end` is at a foot. A leg that leaves the image
// stands nearer than the point where it does. Objects seen above a wall have no foot.
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
    // At a field line colors are mixed that look like a leg's, and so does the shaded side of a
    // ball, down to the next green.
    if (which == Which::last && color == ColorClass::white) body = 0;
    if (which == Which::last && color == ColorClass::orange) body = -length;
    body += isBody(color) ? 1 : 0;
    if (green < minGreen) continue;
    if (body >= (which == Which::first ? minGreen : minLeg))
      foot = start + down * (i - minGreen + 0.5 + footBlur);
    if (foot && which == Which::first) break;
    body = 0;
  }
  const auto distanceOf = [&](const Vector2d& at) {
    const auto place = onGround(picture, at);
    return place ? (*place - picture.matrix.pose.translation.head<2>()).norm() : farthestOnGround;
  };
  if (foot) {
    feet_.push_back(*foot);
    distances_.push_back(distanceOf(*foot));
    foot_ = std::min(foot_, distances_.back());
  } else if (which == Which::first && body > minGreen) {
    border_ = std::min(border_, distanceOf(start + down * (length - 1)));
  }
}

// Some foot points are below the body, not below a foot; the smallest distance counts. The legs of
// the nearer side reach farther down and are also seen beside the tricot.
void PlayerSpecialist::lookForFeet(const CameraImage& picture) {
  foot_ = border_ = farthestOnGround;
  distances_.clear();
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
