#include "modules/perception/scanning/EdgeScanner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "modules/perception/scanning/FieldView.h"
#include "modules/perception/scanning/IndicationScanner.h"

namespace gt {
namespace {

constexpr int reach = 3;      // Pixels over which an edge is spread at most.
constexpr int contrast = 24;  // Of the y channel, between both sides of an edge.
constexpr int minPoints = 3;  // Of a type in an image; fewer are noise.
constexpr int farMore = 4;    // That many times more points on lines than on the border.

}  // namespace

/// The position, with subpixel accuracy, where the brightness is halfway between both sides of the
/// edge.
double EdgeScanner::sharpest(int at) const {
  const auto y = [&](int i) { return static_cast<double>(y_[static_cast<std::size_t>(i)]); };
  const int first = at - reach, last = at;
  const double middle = (y(first) + y(last)) / 2;
  for (int i = first; i < last; ++i) {
    const double before = y(i) - middle, behind = y(i + 1) - middle;
    if (before * behind <= 0 && before != behind) return i + before / (before - behind);
  }
  return first + reach / 2.0;
}

void EdgeScanner::findBright(const CameraImage& picture, const ScanLine& line) {
  const int length = line.length;
  y_.resize(static_cast<std::size_t>(length));
  std::uint8_t* const y = y_.data();
  PixelWalk walk{picture.image, line};
  for (int i = 0; i < length; ++i, walk.step()) y[i] = walk.pixel().y;
  const auto difference = [y](int i) { return y[i] - y[i - reach]; };
  // All at once, and then only where it is steep.
  steep_.resize(y_.size() + sizeof(std::uint64_t));
  std::uint8_t* const steep = steep_.data();
  for (int i = reach; i < length; ++i) {
    const std::uint8_t high = std::max(y[i], y[i - reach]), low = std::min(y[i], y[i - reach]);
    steep[i] = static_cast<std::uint8_t>(high - low) > contrast ? 1 : 0;
  }
  const auto nextSteep = [&](int i) {
    for (; i < length; i += 8) {
      std::uint64_t eight;
      std::memcpy(&eight, steep + i, sizeof eight);
      if (eight != 0) return i + std::countr_zero(eight) / 8;
    }
    return length;
  };
  const auto isAt = [&](int k, ColorClass color) {
    return k >= 0 && k < length && picture.classAt(line.at(k)) == color;
  };
  const auto is = [&](double from, int by, ColorClass color) {
    // One of two pixels beyond the edge's blur.
    const int i = static_cast<int>(std::lround(from)) + 2 * by;
    return isAt(i, color) || isAt(i + by, color);
  };
  bright_.clear();
  Bright bright;
  bool inside = true;  // perhaps: a wall that reaches beyond the image is bright from the start
  for (int i = nextSteep(reach); i < length; i = nextSteep(i + 1)) {
    const bool rising = difference(i) > 0;
    // The steepest place of this edge.
    int best = i;
    while (i + 1 < length &&
           (rising ? difference(i + 1) > contrast : difference(i + 1) < -contrast)) {
      ++i;
      if (std::abs(difference(i)) > std::abs(difference(best))) best = i;
    }
    const double edge = sharpest(best);
    if (rising) {
      bright = {edge, 0, true, is(edge, -1, ColorClass::green)};
      inside = true;
    } else if (inside) {
      inside = false;
      bright.fall = edge;
      const bool white = is(edge, -1, ColorClass::white) ||
                         (bright.riseSeen && isAt(static_cast<int>((bright.rise + edge) / 2 + 0.5),
                                                  ColorClass::white));
      if (white && is(edge, 1, ColorClass::green)) bright_.push_back(bright);
    }
  }
}

void EdgeScanner::scanDown(const CameraImage& picture, const ScanLine& line,
                           const FieldDimensions& field) {
  findBright(picture, line);
  for (const Bright& bright : bright_) {
    const auto foot = onGround(picture, line.at(bright.fall));
    if (!foot) continue;
    const double distance = (*foot - picture.matrix.pose.translation.head<2>()).norm();
    const double width = expectedLineWidth(picture, distance, field);
    const double height = expectedBorderHeight(picture, distance, field);
    classify(picture, line, bright, std::sqrt(width * std::max(height, 2 * width)));
  }
}

void EdgeScanner::scanAcross(const CameraImage& picture, const ScanLine& line,
                             const FieldDimensions& field) {
  constexpr double oblique = 3;  // a line is seen that much wider at most
  findBright(picture, line);
  for (const Bright& bright : bright_) {
    const auto foot = onGround(picture, line.at(bright.fall));
    if (!foot) continue;
    const Vector3d way = Vector3d{foot->x(), foot->y(), 0} - picture.matrix.pose.translation;
    classify(picture, line, bright,
             oblique * picture.matrix.info.focalX * field.lineWidth / way.norm());
  }
}

// A line has green on both sides, the border does not. If size and colors contradict each other, a
// line was seen lengthwise or only a part of the border; no point is added then.
void EdgeScanner::classify(const CameraImage& picture, const ScanLine& line, const Bright& bright,
                           double longestLine) {
  const double size = (bright.fall - bright.rise) * line.step.norm();
  if (size < longestLine && bright.riseSeen && bright.greenBefore)
    add(picture, EdgeType::line, line.at((bright.rise + bright.fall) / 2));
  else if (size >= longestLine && !bright.greenBefore)
    add(picture, EdgeType::border, line.at(bright.fall));
}

void EdgeScanner::addGoal(const CameraImage& picture, const GoalIndication& goal) {
  if (!goal.meetsField) return;
  add(picture, goal.color == GoalColor::yellow ? EdgeType::yellowGoal : EdgeType::skyblueGoal,
      goal.foot);
}

void EdgeScanner::add(const CameraImage& picture, EdgeType type, const Vector2d& inImage) {
  if (const auto point = onGround(picture, inImage)) points_.push_back({type, inImage, *point});
}

void EdgeScanner::finish(LinesPercept& percept) {
  EnumArray<EdgeType, int> count{};
  for (const EdgePoint& point : points_) ++count[point.type];
  const auto isNoise = [&](const EdgePoint& point) {
    return count[point.type] < minPoints ||
           (point.type == EdgeType::border &&
            count[EdgeType::line] > farMore * count[EdgeType::border]);
  };
  points_.erase(std::remove_if(points_.begin(), points_.end(), isNoise), points_.end());
  for (auto& list : percept.points) list.clear();
  for (const EdgePoint& point : points_) percept.points[point.type].push_back(point.onGround);
}

void scan(const CameraImage& picture, const ScanGrid& grid, const FieldDimensions& field,
          IndicationScanner& objects, EdgeScanner& edges) {
  objects.clear();
  edges.clear();
  for (const ScanLine& line : grid.lines()) {
    objects.scan(picture, line, field);
    if (line.whole) edges.scanDown(picture, line, field);
  }
  for (const ScanLine& row : grid.rows()) edges.scanAcross(picture, row, field);
  for (const GoalIndication& goal : objects.goals) edges.addGoal(picture, goal);
}

}  // namespace gt
