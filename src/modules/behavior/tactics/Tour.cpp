#include "modules/behavior/tactics/Tour.h"

#include <algorithm>
#include <array>
#include <limits>

namespace gt {
namespace {

double lengthOf(const Vector2d& from, const std::vector<Vector2d>& places) {
  double length = 0;
  Vector2d at = from;
  for (const Vector2d& place : places) {
    length += (place - at).norm();
    at = place;
  }
  return length;
}

}  // namespace

std::vector<Vector2d> shortestTour(const Vector2d& from, std::vector<Vector2d> places) {
  const auto before = [](const Vector2d& a, const Vector2d& b) {
    return std::pair{a.x(), a.y()} < std::pair{b.x(), b.y()};
  };
  std::ranges::sort(places, before);
  std::vector<Vector2d> best = places;
  double least = std::numeric_limits<double>::max();
  do {
    const double length = lengthOf(from, places);
    if (length < least) least = length, best = places;
  } while (std::next_permutation(places.begin(), places.end(), before));
  return best;
}

double towardsBorder(const Vector2d& place, const FieldDimensions& field) {
  // Nearer than that the border lies below the image, or fills it (report 4.2.2).
  constexpr double nearest = 500;  // mm
  const std::array<std::pair<double, double>, 4> borders{{{field.xGroundline - place.x(), 0},
                                                          {field.ySideline - place.y(), pi / 2},
                                                          {field.xGroundline + place.x(), -pi},
                                                          {field.ySideline + place.y(), -pi / 2}}};
  double rotation = 0, least = std::numeric_limits<double>::max();
  for (const auto& [distance, direction] : borders)
    if (distance >= nearest && distance < least) least = distance, rotation = direction;
  return rotation;
}

const Pose2D& Tour::at(std::size_t index, const WorldState& world) {
  constexpr std::int64_t forgotten = 5000;
  const Time now = world.frame.time;
  if (poses_.empty() || now - asked_ > forgotten) {
    poses_.clear();
    for (const Vector2d& place : shortestTour(world.self.pose.translation, world.targets.points))
      poses_.emplace_back(towardsBorder(place, world.field), place);
  }
  asked_ = now;
  own_ = world.self.pose;
  return index < poses_.size() ? poses_[index] : own_;
}

}  // namespace gt
