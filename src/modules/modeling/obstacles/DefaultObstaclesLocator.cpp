#include "modules/modeling/obstacles/DefaultObstaclesLocator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gt {
namespace {

const DebugKey drawRadar{"ObstaclesLocator/radar"};
const DebugKey drawRadarOnImage{"ObstaclesLocator/image"};

using Sector = ObstaclesModel::Sector;

/// The directions in which a sector begins and ends.
struct Borders {
  Vector2d right, left;
};
const auto sectorBorders = [] {
  std::array<Borders, ObstaclesModel::numberOfSectors> borders;
  for (int i = 0; i < ObstaclesModel::numberOfSectors; ++i) {
    constexpr double half = pi / ObstaclesModel::numberOfSectors;
    const double middle = ObstaclesModel::middleOf(i);
    borders[static_cast<std::size_t>(i)] = {direction(middle - half), direction(middle + half)};
  }
  return borders;
}();

/// Returns whether a point clearly lies within a sector, without computing its angle.
bool isWellWithin(int sector, const Vector2d& place, double distance) {
  if (sector < 0) return false;
  const auto cross = [](const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const double sure = 1e-9 * distance;
  const Borders& borders = sectorBorders[static_cast<std::size_t>(sector)];
  return cross(borders.right, place) > sure && cross(place, borders.left) > sure;
}

}  // namespace

void DefaultObstaclesLocator::update(const ObstaclesPercept& percept, const PsdPercept& psd,
                                     const LandmarksPercept& landmarks, const BallModel& ball,
                                     const CameraMatrix& camera, const OdometryData& odometry,
                                     const FrameInfo& frame, ObstaclesModel& model, Debug& debug) {
  move(first_ ? Pose2D{} : odometry.pose.relativeTo(lastOdometry_.pose), frame.time);
  first_ = false;
  lastOdometry_ = odometry;
  if (parameters.useImages && percept.time != lastPicture_) seeImage(percept, ball, camera);
  lastPicture_ = percept.time;
  if (parameters.usePsd && psd.time != lastPsd_ && camera.valid) seePsd(psd, camera);
  lastPsd_ = psd.time;
  if (landmarks.time != lastLandmarks_)
    for (int i = 0; i < landmarks.numberOfGoals; ++i)
      seeGoal(landmarks.goals[static_cast<std::size_t>(i)], landmarks);
  lastLandmarks_ = landmarks.time;
  model_.time = frame.time;
  model = model_;
  draw(camera, debug);
}

// Moves the representatives against the robot's motion; some leave their sectors. If two come to
// lie in one sector, the nearer one is kept (report 3.5.2).
void DefaultObstaclesLocator::move(const Pose2D& step, Time now) {
  for (ObstaclesModel::SeenGoal& goal : model_.goals) {
    goal.left = relative(step, goal.left);
    goal.right = relative(step, goal.right);
  }
  const auto old = model_.sectors;
  model_.sectors.fill({});
  for (const Sector& sector : old)
    if (now - sector.lastSeen <= parameters.forgetAfter)
      model_.enter(relative(step, sector.representative), sector.obstacle, sector.lastSeen);
}

// First all ground seen to be free is cleared, then the seen obstacles are entered. Known obstacles
// nearer than the image's lower border stay, all others are replaced (report 3.5.1, figure 3.13).
void DefaultObstaclesLocator::seeImage(const ObstaclesPercept& percept, const BallModel& ball,
                                       const CameraMatrix& camera) {
  sure_.clear();
  for (const FreeGround& seen : percept.lines) {
    sure_.push_back(surelyFree(seen, camera));
    clear(sure_.back().nearPoint, sure_.back().farPoint);
  }
  const bool ballKnown = percept.time - ball.lastSeen <= parameters.ballTime;
  for (std::size_t i = 0; i < sure_.size(); ++i) {
    const Vector2d& seen = percept.lines[i].farPoint;
    const bool isBall = ballKnown && (seen - ball.position).norm() < parameters.ballSize;
    model_.enter(sure_[i].farPoint, !sure_[i].farOnBorder && !isBall, percept.time);
  }
}

// Shortens free ground to allow for an error of the camera matrix. An error of the tilt causes an
// error of distance that grows with the distance.
FreeGround DefaultObstaclesLocator::surelyFree(const FreeGround& line,
                                               const CameraMatrix& camera) const {
  const double height = camera.pose.translation.z();
  if (line.farOnBorder || height <= 0) return line;
  const Vector2d from = camera.pose.translation.head<2>(), way = line.farPoint - from;
  const double distance = way.norm(), nearest = (line.nearPoint - from).norm();
  if (distance <= nearest) return line;
  // The distance at which the camera looks down more steeply, by the tangent of a sum of angles.
  const double caution = std::tan(parameters.caution);
  const double shorter = height * (distance - height * caution) / (height + distance * caution);
  FreeGround sure = line;
  sure.farPoint = from + way * (std::max(shorter, nearest) / distance);
  return sure;
}

// The sensor's ray passes over obstacles that are lower. Only the part of the ray that is low
// enough shows free ground.
void DefaultObstaclesLocator::seePsd(const PsdPercept& psd, const CameraMatrix& camera) {
  const Vector3d start = camera.pose.translation, way = psd.offset - start;
  const Vector2d hit = psd.offset.head<2>();
  const double agreement = parameters.psdAgreement;
  const bool agrees = agreement == 0 || (hit - psdHit_).norm() <= agreement;
  psdHit_ = hit;
  if (!agrees) return;
  const double fall = start.z() - psd.offset.z();
  if (psd.offset.z() < parameters.lowestObstacle && fall > 0) {
    const double share = std::clamp((start.z() - parameters.lowestObstacle) / fall, 0., 1.);
    clear((start + share * way).head<2>(), hit);
  }
  constexpr double ground = 30;  // mm: what is hit lower is the ground
  if (psd.tooFarAway || psd.offset.z() < ground || psd.offset.z() > parameters.highestObstacle)
    return;
  model_.enter(hit, true, psd.time);
}

// The lines of an image begin at the camera, not at the robot's center, so that they cross
// sectors.
void DefaultObstaclesLocator::clear(const Vector2d& from, const Vector2d& to) {
  constexpr double stride = 50, margin = 50;  // mm
  const double length = (to - from).norm();
  int sector = -1;
  double nearest = 0, farthest = 0;
  const auto free = [&] {
    if (sector < 0) return;
    Sector& known = model_.sectors[static_cast<std::size_t>(sector)];
    const double distance = known.representative.norm();
    if (distance >= nearest - margin && distance <= farthest + margin) known = {};
  };
  const int strides = static_cast<int>(std::min(length, 3000.) / stride) + 1;
  for (int i = 0; i <= strides; ++i) {
    const Vector2d place = from + (to - from) * (static_cast<double>(i) / strides);
    const double distance = place.norm();
    if (!isWellWithin(sector, place, distance)) {
      if (const int here = ObstaclesModel::sectorOf(place); here != sector) {
        free();
        sector = here;
        nearest = farthest = distance;
      }
    }
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  free();
}

// The direction of a seen goal is free. An edge on the image's border is not the end of the goal;
// if the goal was seen to extend farther before, that still counts.
void DefaultObstaclesLocator::seeGoal(const GoalPercept& percept,
                                      const LandmarksPercept& landmarks) {
  ObstaclesModel::SeenGoal& goal = model_.goals[percept.color];
  const Vector2d camera = landmarks.cameraOffset.head<2>();
  constexpr double unknown = 1500;  // mm: what a goal's distance is taken for
  constexpr std::int64_t sameGlance = 1000;
  const bool known = landmarks.time - goal.lastSeen < sameGlance;
  const double distance = percept.distance > 0 ? percept.distance
                          : known              ? ((goal.left + goal.right) / 2).norm()
                                               : unknown;
  const auto seen = [&](double angle) { return Vector2d{camera + distance * direction(angle)}; };
  const auto isLeftOf = [](const Vector2d& a, const Vector2d& b) {
    return b.x() * a.y() - b.y() * a.x() > 0;
  };
  const Vector2d left = seen(percept.boundary.left), right = seen(percept.boundary.right);
  const bool touches = known && isLeftOf(goal.left, right) && isLeftOf(left, goal.right);
  if (!(touches && percept.boundary.leftOnBorder && isLeftOf(goal.left, left))) goal.left = left;
  if (!(touches && percept.boundary.rightOnBorder && isLeftOf(right, goal.right)))
    goal.right = right;
  goal.lastSeen = landmarks.time;
}

// Figure 3.12: as seen from above, and projected into the camera image.
void DefaultObstaclesLocator::draw(const CameraMatrix& camera, Debug& debug) const {
  constexpr double half = pi / ObstaclesModel::numberOfSectors;
  if (auto canvas = debug.onRobot(drawRadar))
    for (int i = 0; i < ObstaclesModel::numberOfSectors; ++i) {
      const Sector& sector = model_.sectors[static_cast<std::size_t>(i)];
      if (sector.lastSeen == never()) continue;
      const double middle = ObstaclesModel::middleOf(i);
      const double distance = std::min(sector.representative.norm(), ObstaclesModel::farAway);
      canvas.area(
          {{0, 0}, distance * direction(middle - half), distance * direction(middle + half)},
          {30, 160, 50, 70});
      if (sector.obstacle)
        canvas.line(distance * direction(middle - half), distance * direction(middle + half),
                    colors::red, 2);
    }
  auto canvas = debug.onImage(drawRadarOnImage);
  if (!canvas || !camera.valid) return;
  const Matrix3d toCamera = camera.pose.rotation.transpose();
  for (const Sector& sector : model_.sectors) {
    const Vector2d& p = sector.representative;
    const Vector3d seen = toCamera * (Vector3d{p.x(), p.y(), 0} - camera.pose.translation);
    if (sector.lastSeen == never() || seen.x() < 1) continue;
    canvas.cross(camera.info.project(seen), 4, sector.obstacle ? colors::red : colors::green, 2);
  }
}

}  // namespace gt
