#include "modules/perception/scanning/IndicationScanner.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "modules/perception/scanning/FieldView.h"

namespace gt {
namespace {

constexpr int maxGap = 2;      // Pixels of a wrong class accepted within an object.
constexpr int minPink = 2;     // Pixels of each of a flag's colors.
constexpr int minGoal = 3;     // Pixels of a goal's color.
constexpr int minHidden = 8;   // The same, of a goal whose foot is hidden.
constexpr int minRobot = 6;    // Pixels of a robot that hides a goal's foot,
constexpr int minTricot = 3;   // of which so many are tricot,
constexpr int nearRobot = 12;  // and which begin so near below what is seen of the goal.
constexpr int minBall = 2;     // Orange pixels.
constexpr int maxToField = 6;  // Pixels from a goal's lower end to the green.

static_assert(sizeof(ColorClass) == 1 && std::endian::native == std::endian::little);

}  // namespace

void IndicationScanner::clear() {
  balls.clear();
  flags.clear();
  goals.clear();
  players.clear();
  greens.clear();
}

void IndicationScanner::scan(const CameraImage& picture, const ScanLine& line,
                             const FieldDimensions& field) {
  findRuns(picture, line);
  if (line.whole) findGreen(picture, line, field);
  for (std::size_t i = 0; i < runs_.size();) {
    std::size_t next = i + 1;
    switch (runs_[i].color) {
      case ColorClass::orange:
      case ColorClass::red:
        next = findBall(line, i);
        break;
      case ColorClass::blue: {
        const Stretch tricot = stretchFrom(i, ColorSet{ColorClass::blue}, maxGap);
        findPlayer(line, tricot, TeamColor::blue);
        next = tricot.last + 1;
        break;
      }
      case ColorClass::pink:
        if (runs_[i].length() >= minPink) findFlag(line, i);
        break;
      case ColorClass::yellow:
      case ColorClass::skyblue:
        next = findGoal(picture, line, field, i);
        break;
      default:
        break;
    }
    i = next;
  }
}

// First the classes of all pixels are looked up, independently of each other. Then changes are
// searched in eight pixels at a time, since changes are rare.
void IndicationScanner::findRuns(const CameraImage& picture, const ScanLine& line) {
  const int length = line.length;
  if (classes_.size() < static_cast<std::size_t>(length))
    classes_.resize(static_cast<std::size_t>(length));
  ColorClass* const classes = classes_.data();
  PixelWalk walk{picture.image, line};
  for (int i = 0; i < length; ++i, walk.step()) classes[i] = picture.colors[walk.pixel()];

  runs_.clear();
  int begin = 0;
  const auto endRun = [&](int end) {
    runs_.push_back({classes[begin], begin, end});
    begin = end;
  };
  const auto eightFrom = [&](int i) {
    std::uint64_t eight;
    std::memcpy(&eight, classes + i, sizeof eight);
    return eight;
  };
  int i = 1;
  for (; i + 8 <= length; i += 8)
    for (std::uint64_t changes = eightFrom(i) ^ eightFrom(i - 1); changes != 0;) {
      const int pixel = std::countr_zero(changes) / 8;
      endRun(i + pixel);
      changes &= ~(std::uint64_t{0xff} << 8 * pixel);
    }
  for (; i < length; ++i)
    if (classes[i] != classes[i - 1]) endRun(i);
  endRun(length);
}

IndicationScanner::Stretch IndicationScanner::stretchFrom(std::size_t first, ColorSet classes,
                                                          int gap) const {
  Stretch stretch{first, first, runs_[first].length()};
  for (std::size_t i = first + 1; i < runs_.size(); ++i) {
    if (runs_[i].begin - runs_[stretch.last].end > gap) break;
    if (!classes.contains(runs_[i].color)) continue;
    stretch.last = i;
    stretch.pixels += runs_[i].length();
  }
  return stretch;
}

// Color tables leave holes in balls. Unclassified pixels between orange ones are bridged as long as
// they are not many more than the orange ones.
IndicationScanner::Stretch IndicationScanner::ballFrom(std::size_t first) const {
  constexpr ColorSet classes{ColorClass::orange, ColorClass::red};
  Stretch stretch{first, first, runs_[first].length()};
  int wrong = 0;
  for (std::size_t i = first + 1; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    if (classes.contains(run.color)) {
      stretch.last = i;
      stretch.pixels += run.length();
      wrong = 0;
    } else if (run.color != ColorClass::noColor) {
      wrong += run.length();
    }
    if (wrong > maxGap || run.end - runs_[stretch.last].end > maxGap + 2 * stretch.pixels) break;
  }
  return stretch;
}

// Shaded orange often appears as red. Red counts as ball if there is at least as much orange.
std::size_t IndicationScanner::findBall(const ScanLine& line, std::size_t first) {
  const Stretch stretch = ballFrom(first);
  const std::size_t next = stretch.last + 1;
  int orange = 0;
  for (std::size_t i = stretch.first; i <= stretch.last; ++i)
    if (runs_[i].color == ColorClass::orange) orange += runs_[i].length();
  if (orange < minBall || 2 * orange < stretch.pixels) {
    findPlayer(line, stretch, TeamColor::red);
    return next;
  }
  BallSegment segment;
  segment.u = line.u;
  segment.orange = orange;
  segment.upper = line.at(runs_[stretch.first].begin - 0.5);
  segment.lower = line.at(runs_[stretch.last].end - 0.5);
  segment.upperKnown = stretch.first > 0;
  segment.lowerKnown = next < runs_.size();
  if (segment.upperKnown) segment.above = runs_[stretch.first - 1].color;
  if (segment.lowerKnown) segment.below = runs_[next].color;
  balls.push_back(segment);
  return next;
}

// The colors next to pink identify the flag. Single wrong pixels between the colors are skipped.
void IndicationScanner::findFlag(const ScanLine& line, std::size_t first) {
  const Stretch pink = stretchFrom(first, ColorSet{ColorClass::pink}, maxGap);
  const auto partner = [&](std::size_t from, int direction) -> const Run* {
    int skipped = 0;
    for (auto i = static_cast<std::ptrdiff_t>(from);
         i >= 0 && i < static_cast<std::ptrdiff_t>(runs_.size()); i += direction) {
      const Run& run = runs_[static_cast<std::size_t>(i)];
      const bool colored = run.color == ColorClass::yellow || run.color == ColorClass::skyblue ||
                           run.color == ColorClass::green;
      if (colored && run.length() >= minPink) return &run;
      skipped += run.length();
      if (skipped > maxGap) break;
    }
    return nullptr;
  };
  if (const Run* below = partner(pink.last + 1, 1)) {
    const auto type = flagOf({ColorClass::pink, below->color});
    flags.push_back({*type, line.at((runs_[pink.last].end + below->begin - 1) / 2.0)});
  }
  if (const Run* above = first > 0 ? partner(first - 1, -1) : nullptr) {
    const auto type = flagOf({above->color, ColorClass::pink});
    flags.push_back({*type, line.at((runs_[pink.first].begin + above->end - 1) / 2.0)});
  }
}

// A goal stands on the field: below its color there is green, possibly after a line, or the image's
// border, or a robot that hides the rest.
std::size_t IndicationScanner::findGoal(const CameraImage& picture, const ScanLine& line,
                                        const FieldDimensions& field, std::size_t first) {
  const ColorClass color = runs_[first].color;
  const Stretch stretch = stretchFrom(first, ColorSet{color}, maxGap);
  const std::size_t next = stretch.last + 1;
  if (stretch.pixels < minGoal) return next;
  GoalIndication goal;
  goal.color = color == ColorClass::yellow ? GoalColor::yellow : GoalColor::skyblue;
  goal.top = line.at(runs_[stretch.first].begin);
  goal.bottom = line.at(runs_[stretch.last].end - 1);
  const int end = runs_[stretch.last].end;
  bool onField = next == runs_.size() && line.toBorder;
  for (std::size_t i = next; i < runs_.size() && !onField; ++i) {
    const Run& run = runs_[i];
    if (run.begin - end > maxToField) break;
    onField = run.color == ColorClass::green && run.length() >= minPink;
    // Between both colors may lie some pixels that are mixed of them.
    goal.meetsField = onField && run.begin - end <= maxGap;
    goal.foot = line.at((run.begin + end - 1) / 2.0);
  }
  onField = onField && picture.horizon.fromImage(goal.bottom).y() >= 0;
  if (!onField && !isHidden(stretch)) return next;
  if (onField && goal.meetsField) cutOff(picture, field, goal);
  goals.push_back(goal);
  return next;
}

// A person in the goal's color may stand behind it. The top is therefore limited to the height of a
// goal that stands at the foot.
void IndicationScanner::cutOff(const CameraImage& picture, const FieldDimensions& field,
                               GoalIndication& goal) {
  constexpr double tolerance = fromDegrees(4);  // the errors of a camera matrix at top and foot
  const auto place = onGround(picture, goal.foot);
  if (!place) return;
  const double distance = (*place - picture.matrix.pose.translation.head<2>()).norm();
  const double height = field.goalHeight / distance, focal = picture.matrix.info.focalX;
  const Vector2d up = goal.top - goal.bottom;
  if (up.norm() <= focal * (height + tolerance)) return;
  goal.top = goal.bottom + up.normalized() * focal * height;
  goal.topKnown = false;
}

// Whether a robot is below the goal, down to the green or to the end of the line, and no color of a
// flag is near, since objects above a wall are no goal. Gray does not indicate a robot, because it
// is everywhere; black alone does not either, because people's legs are black.
bool IndicationScanner::isHidden(const Stretch& goal) const {
  constexpr ColorSet flag{ColorClass::pink, ColorClass::white};
  constexpr ColorSet tricots{ColorClass::red, ColorClass::blue};
  const int end = runs_[goal.last].end;
  if (goal.pixels < minHidden || runs_.back().end - end < maxToField) return false;
  int black = 0, tricot = 0;
  for (std::size_t i = goal.last + 1; i < runs_.size() && runs_[i].begin - end < nearRobot; ++i) {
    if (tricots.contains(runs_[i].color)) tricot += runs_[i].length();
    if (runs_[i].color == ColorClass::black) black += runs_[i].length();
  }
  if (tricot < minTricot || tricot + black < minRobot) return false;
  for (std::size_t i = goal.last + 1; i < runs_.size(); ++i) {
    if (flag.contains(runs_[i].color) && runs_[i].length() >= minPink) return false;
    if (runs_[i].color == ColorClass::green && runs_[i].length() >= minPink) break;
  }
  for (std::size_t i = goal.first; i-- > 0 && runs_[goal.first].begin - runs_[i].end <= maxGap;)
    if (flag.contains(runs_[i].color)) return false;
  return true;
}

void IndicationScanner::findPlayer(const ScanLine& line, const Stretch& tricot, TeamColor team) {
  PlayerIndication player;
  player.team = team;
  player.u = line.u;
  player.pixels = tricot.pixels;
  player.upper = line.at(runs_[tricot.first].begin - 0.5);
  player.lower = line.at(runs_[tricot.last].end - 0.5);
  player.upperKnown = tricot.first > 0 || !line.fromBorder;
  player.lowerKnown = tricot.last + 1 < runs_.size() || !line.toBorder;
  players.push_back(player);
}

// Searches from the bottom upwards for green, with gaps that may be field lines (report 3.2.7).
void IndicationScanner::findGreen(const CameraImage& picture, const ScanLine& line,
                                  const FieldDimensions& field) {
  int begin = line.length;
  for (std::size_t i = runs_.size(); i-- > 0;) {
    const Run& run = runs_[i];
    if (run.color == ColorClass::green && run.length() >= minPink) begin = run.begin;
    if (begin == run.begin) continue;
    // What has a color of its own is no line.
    constexpr ColorSet lineColors{ColorClass::white, ColorClass::green};
    if (!lineColors.contains(run.color) && run.length() > maxGap) break;
    if (begin - run.begin <= maxGap) continue;
    const auto place = onGround(picture, line.at(begin - 1));
    if (!place) break;
    const double distance = (*place - picture.matrix.pose.translation.head<2>()).norm();
    const double gap = 4 * expectedLineWidth(picture, distance, field);
    if (begin - run.begin > gap &&
        !isSeenLengthwise(picture, line.at((run.begin + begin - 1) / 2.0), distance, field))
      break;
  }
  GreenSection green;
  green.end = line.at(line.length - 1);
  green.begin = greenEnd(picture, line, begin);
  green.beginOnBorder = begin == 0 && line.fromBorder;
  greens.push_back(green);
}

// Lengthwise, a field line may have any length; across, it is as narrow as painted. Robots and
// walls are wider.
bool IndicationScanner::isSeenLengthwise(const CameraImage& picture, const Vector2d& middle,
                                         double distance, const FieldDimensions& field) {
  constexpr double blur = 1.5, widest = 1.3;  // Pixels, painted widths.
  const double most = widest * picture.matrix.info.focalX * field.lineWidth / distance + blur;
  double width = 0;
  for (const double side : {-1., 1.})
    for (Vector2d p = middle; width <= most; width += 0.5) {
      if (!picture.contains(p)) return false;
      if (picture.classAt(p) != ColorClass::white) break;
      p += 0.5 * side * picture.horizon.along;
    }
  return width > 0 && width <= most;
}

// The point where the image is halfway between green and the next color. The color class ends a
// pixel or two before it.
Vector2d IndicationScanner::greenEnd(const CameraImage& picture, const ScanLine& line, int begin) {
  constexpr int inside = 2;  // Pixels, from where the color is not mixed.
  if (begin == 0 || begin == line.length) return line.at(std::min(begin, line.length - 1));
  const int from = std::min(begin + inside, line.length - 1);
  const Vector2d end =
      picture.findEdge(line.at(from), -line.step, ColorSet{ColorClass::green}, 0).point;
  return picture.contains(end) ? end : line.at(begin);
}

}  // namespace gt
