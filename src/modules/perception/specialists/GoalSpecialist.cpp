#include "modules/perception/specialists/GoalSpecialist.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gt {
namespace {

constexpr int maxGap = 3;
constexpr double sameEdge = 1.2;  // Pixels, as for flags.
constexpr double straight = 0.5;  // The part of the rows that has to meet a post.
constexpr double rim = 3;  // Pixels at the image's border, whose colors blur and light change.
// Colors that are never seen where a goal meets the ground.
constexpr ColorSet notBelow{ColorClass::red, ColorClass::blue, ColorClass::black, ColorClass::gray,
                            ColorClass::noColor};

bool isAtRim(const CameraInfo& info, const Vector2d& p) {
  return p.x() < rim || p.x() > info.width - rim || p.y() < rim || p.y() > info.height - rim;
}

// Returns whether one of some colors begins beyond the edge.
bool borders(const CameraImage& picture, const Vector2d& edge, const Vector2d& outward,
             ColorSet colors, double distance) {
  const Vector2d beyond = edge + outward * distance;
  return picture.contains(beyond) && colors.contains(picture.classAt(beyond));
}

// Returns whether the goal ends at the white of the field's walls, as it does at its posts. Anywhere
// else something hides the rest of it: on a field without walls, a robot.
bool isPost(const CameraImage& picture, const Vector2d& edge, const Vector2d& outward,
            const FieldDimensions& field) {
  constexpr ColorSet wall{ColorClass::white};
  constexpr ColorSet robot{ColorClass::red, ColorClass::blue, ColorClass::black, ColorClass::gray};
  if (field.wallHeight == 0) return !borders(picture, edge, outward, robot, 2.5);
  return borders(picture, edge, outward, wall, 2.5) || borders(picture, edge, outward, wall, 3.5);
}

double heightOf(const GoalIndication& g) {
  return (g.bottom - g.top).norm();
}

// A single scan line may have met anything in the goal's color. It is enough on a field below what is
// as high as the farthest goal.
bool isEnough(std::span<const GoalIndication> group, const CameraInfo& info,
              const FieldDimensions& field) {
  if (group.size() != 1) return !group.empty();
  return group[0].meetsField &&
         heightOf(group[0]) > info.focalX * field.goalHeight / farthestLandmark;
}

// Positions of the scanned rows, as shares of the goal's height. Robots hide the lower ones.
constexpr std::array rows{0.15, 0.3, 0.5, 0.7, 0.85};

}  // namespace

void GoalSpecialist::find(const CameraImage& picture, std::span<const GoalIndication> indications,
                          const FieldDimensions& field, LandmarksPercept& percept) {
  percept.numberOfGoals = 0;
  for (const GoalColor color : {GoalColor::yellow, GoalColor::skyblue}) {
    selectGroup(picture, indications, color);
    GoalPercept goal;
    goal.color = color;
    if (isEnough(group_, picture.image.info, field) && measure(picture, field, goal))
      percept.goals[static_cast<std::size_t>(percept.numberOfGoals++)] = goal;
  }
}

// Robots divide a goal into parts. Gaps wider than the goal's height have other reasons and
// separate groups.
void GoalSpecialist::selectGroup(const CameraImage& picture,
                                 std::span<const GoalIndication> indications, GoalColor color) {
  group_.clear();
  members_.clear();
  double newest = 0, highest = 0;
  const auto close = [&] {
    if (members_.size() > group_.size()) std::swap(members_, group_);
    members_.clear();
    highest = 0;
  };
  for (const GoalIndication& indication : indications) {
    if (indication.color != color) continue;
    const double u = picture.horizon.fromImage(indication.bottom).x();
    if (!members_.empty() && u - newest > 8 + 1.3 * highest) close();
    newest = u;
    highest = std::max(highest, (indication.bottom - indication.top).norm());
    members_.push_back(indication);
  }
  close();
}

void GoalSpecialist::scanRows(const CameraImage& picture, const GoalIndication& from,
                              const FieldDimensions& field, ColorSet colors, double sign,
                              EdgeAngles& edge) {
  for (const double part : rows) {
    const Vector2d p = from.top + (from.bottom - from.top) * part;
    if (!colors.contains(picture.classAt(p))) continue;
    const Vector2d outward = picture.horizon.along * -sign;
    const ColorEdge end = picture.findEdge(p, outward, colors, maxGap);
    const bool cut = end.onBorder || isAtRim(picture.image.info, end.point);
    cutOff_ = cutOff_ || cut;
    edge.add(azimuth(picture.ray(end.point)), cut || !isPost(picture, end.point, outward, field));
  }
}

const GoalIndication& GoalSpecialist::highest() const {
  return *std::ranges::max_element(group_, {}, heightOf);
}

// The outermost line that shows most of the goal's height. Lines farther out may be hidden by
// robots.
const GoalIndication& GoalSpecialist::outermost(bool left) const {
  const double enough = 0.6 * heightOf(highest());
  const std::size_t n = group_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const GoalIndication& g = group_[left ? i : n - 1 - i];
    if (heightOf(g) >= enough) return g;
  }
  return group_.front();
}

void GoalSpecialist::scanColumn(const CameraImage& picture, const GoalIndication& at,
                                ColorSet colors) {
  const Vector2d middle = (at.top + at.bottom) / 2;
  if (!picture.contains(middle) || !colors.contains(picture.classAt(middle))) return;
  const ColorEdge top = picture.findEdge(middle, -picture.horizon.down, colors, maxGap);
  const ColorEdge bottom = picture.findEdge(middle, picture.horizon.down, colors, maxGap);
  if (at.topKnown) top_.add(elevation(picture.ray(top.point)), top.onBorder);
  bottom_.add(
      elevation(picture.ray(bottom.point)),
      bottom.onBorder || borders(picture, bottom.point, picture.horizon.down, notBelow, 2.5));
}

bool GoalSpecialist::measure(const CameraImage& picture, const FieldDimensions& field,
                             GoalPercept& goal) {
  const ColorSet colors{goal.color == GoalColor::yellow ? ColorClass::yellow : ColorClass::skyblue};
  for (EdgeAngles* edge : {&left_, &right_, &top_, &bottom_}) edge->clear();
  cutOff_ = false;
  // Rows from the outermost lines: what lies between them may be hidden.
  scanRows(picture, outermost(true), field, colors, 1, left_);
  scanRows(picture, outermost(false), field, colors, -1, right_);
  constexpr std::size_t columns = 8;
  for (std::size_t i = 0; i < columns; ++i)
    scanColumn(picture, group_[i * (group_.size() - 1) / (columns - 1)], colors);
  if (left_.empty() || right_.empty() || bottom_.empty()) return false;
  const double tolerance = sameEdge / picture.matrix.info.focalX;
  const auto left = left_.merge(1, tolerance, straight),
             right = right_.merge(-1, tolerance, straight);
  if (top_.empty()) top_.add(elevation(picture.ray(highest().top)), true);
  const auto top = top_.merge(1, tolerance, 0), bottom = bottom_.merge(-1, tolerance, 0);
  goal.boundary = {left.angle,    right.angle,    top.angle,    bottom.angle,
                   left.onBorder, right.onBorder, top.onBorder, bottom.onBorder};
  return locateGoal(picture.matrix, field, cutOff_, goal);
}

bool locateGoal(const CameraMatrix& matrix, const FieldDimensions& field, bool cutOff,
                GoalPercept& goal) {
  const ConditionalBoundary& b = goal.boundary;
  const double width = b.left - b.right;
  const double height = std::tan(b.top) - std::tan(b.bottom);
  if (width <= 0 || height <= 0) return false;
  const Vector3d camera = matrix.pose.translation;
  const bool high = !b.topOnBorder && !b.bottomOnBorder;
  const double distance = high ? field.goalHeight / height : 0;
  if (high) {
    // The goal's lower edge lies on the ground; robots may hide some of it.
    const double bottom = camera.z() + distance * std::tan(b.bottom);
    if (std::abs(bottom) > 80 + 0.12 * distance) return false;
  }
  const double widest = 2.0 * field.yGoal;
  if (distance > 0 && width * distance > 1.6 * widest) return false;
  // A robot hides one side of what is much narrower than a goal, and nothing shows which one.
  constexpr double leastShare = 0.45;
  if (high && width * distance < leastShare * widest)
    goal.boundary.leftOnBorder = goal.boundary.rightOnBorder = true;
  // It stands on the ground, below the horizon.
  if (!b.bottomOnBorder && b.bottom > fromDegrees(1)) return false;
  // Of a goal whose foot is hidden the upper edge gives the distance, and the greatest one if the
  // image cuts off its top: flags and people are narrower.
  constexpr double narrowest = 180;
  const double above = field.goalHeight - camera.z();
  if (!cutOff && b.bottomOnBorder && above > 0 && width * above < narrowest * std::tan(b.top))
    return false;
  const double bearing = (b.left + b.right) / 2;
  // The height is that of all walls of the goal: on average it is seen halfway to its back. If it
  // is not seen as a whole, it is as far as its foot.
  const double depth = field.xGoalBack - field.xGroundline;
  const bool onGround = !b.bottomOnBorder && b.bottom < 0;
  const double away = high       ? std::max(distance - depth / 2, 0.0)
                      : onGround ? camera.z() / std::tan(-b.bottom)
                                 : 0;
  const Vector2d middle = camera.head<2>() + direction(bearing) * away;
  goal.distance = high ? middle.norm() : 0;
  goal.angle = away > 0 ? angleOf(middle) : bearing;
  return true;
}

}  // namespace gt
