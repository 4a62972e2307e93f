#include "modules/perception/specialists/FlagSpecialist.h"

#include <algorithm>
#include <cmath>

#include "modules/perception/scanning/FlagColors.h"

namespace gt {
namespace {

constexpr int maxGap = 2;
// Positions of the scanned rows and columns, as shares of a color's height and the flag's width.
constexpr std::array parts{0.25, 0.5, 0.75};
// Scans whose edges differ by less than this many pixels met the same edge.
constexpr double sameEdge = 1.2;
constexpr double straight = 0.5;  // The part of the scans that has to meet an edge.

}  // namespace

void FlagSpecialist::find(const CameraImage& picture, std::span<const FlagIndication> indications,
                          const FieldDimensions& field, LandmarksPercept& percept) {
  percept.numberOfFlags = 0;
  cluster(picture, indications);
  std::array<int, 6> found{};  // Votes of the flags found, to keep the better one of two.
  for (std::size_t i = 0; i < used_; ++i) {
    Cluster& c = clusters_[i];
    // Somebody behind a flag may make another one of it, which fails when it is measured.
    for (auto best = c.votes.begin(); *(best = std::ranges::max_element(c.votes)) > 0; *best = 0) {
      const auto type = static_cast<std::size_t>(best - c.votes.begin());
      FlagPercept flag;
      flag.type = static_cast<FlagType>(type);
      if (!measure(picture, c.sums[type] / *best, field, flag)) continue;
      if (*best > found[type]) keep(flag, percept);
      found[type] = std::max(found[type], *best);
      break;
    }
  }
}

void FlagSpecialist::keep(const FlagPercept& flag, LandmarksPercept& percept) {
  std::size_t i = 0;
  const auto known = static_cast<std::size_t>(percept.numberOfFlags);
  while (i < known && percept.flags[i].type != flag.type) ++i;
  percept.flags[i] = flag;
  if (i == known) ++percept.numberOfFlags;
}

void FlagSpecialist::cluster(const CameraImage& picture,
                             std::span<const FlagIndication> indications) {
  constexpr double widestGap = 12, highestGap = 8;
  used_ = 0;
  for (const FlagIndication& indication : indications) {
    const Vector2d p = picture.horizon.fromImage(indication.position);
    Cluster* home = nullptr;
    for (std::size_t i = 0; i < used_ && !home; ++i) {
      const Vector2d gap = p - clusters_[i].newest;
      if (std::abs(gap.x()) <= widestGap && std::abs(gap.y()) <= highestGap) home = &clusters_[i];
    }
    if (!home) {
      if (used_ == clusters_.size()) continue;
      home = &clusters_[used_++];
      home->votes.fill(0);
      home->sums.fill(Vector2d::Zero());
    }
    const auto type = static_cast<std::size_t>(indication.type);
    home->newest = p;
    ++home->votes[type];
    home->sums[type] += indication.position;
  }
}

bool FlagSpecialist::measure(const CameraImage& picture, const Vector2d& start,
                             const FieldDimensions& field, FlagPercept& flag) {
  Measurement m;
  const FlagColors colors = colorsOf(flag.type);
  m.pinkAbove = colors.pinkIsAbove();
  m.pink = ColorSet{ColorClass::pink};
  m.other = ColorSet{colors.other()};
  m.otherIsGreen = colors.other() == ColorClass::green;
  m.upper = m.pinkAbove ? m.pink : m.other;
  m.lower = m.pinkAbove ? m.other : m.pink;
  if (!picture.contains(start) || !measureHeights(picture, start, m)) return false;
  if (!scanWidth(picture, start, m)) return false;
  if (!isSolid(picture, start, m) || !standsOnPole(picture, start, m)) return false;
  if (!m.pinkAbove && isPaleRed(picture, start, m)) return false;
  scanColumns(picture, start, m);
  const double tolerance = sameEdge / picture.matrix.info.focalX;
  const auto left = left_.merge(1, tolerance, straight),
             right = right_.merge(-1, tolerance, straight);
  const auto top = top_.merge(1, tolerance, straight),
             bottom = bottom_.merge(-1, tolerance, straight);
  flag.boundary = {left.angle,    right.angle,    top.angle,    bottom.angle,
                   left.onBorder, right.onBorder, top.onBorder, bottom.onBorder};
  return locateFlag(picture.matrix, field, elevation(picture.ray(start)), flag);
}

bool FlagSpecialist::measureHeights(const CameraImage& picture, const Vector2d& start,
                                    Measurement& m) const {
  const Vector2d down = picture.horizon.down;
  const ColorEdge above = picture.findEdge(start, -down, m.upper, maxGap);
  const ColorEdge below = picture.findEdge(start, down, m.lower, maxGap);
  m.heightAbove = (above.point - start).norm();
  m.heightBelow = (below.point - start).norm();
  m.aboveOnBorder = above.onBorder;
  m.belowOnBorder = below.onBorder;
  if (std::min(m.heightAbove, m.heightBelow) < 1) return false;
  // Somebody behind a flag may wear its upper color, which then seems to go on.
  constexpr double goesOn = 1.4;
  if (m.heightAbove > goesOn * m.heightBelow + 1 && !m.belowOnBorder) {
    m.heightAbove = m.heightBelow;
    m.aboveOnBorder = m.aboveGoesOn = true;
  }
  // Both colors are equally high, as far as they are in the image.
  constexpr double mostUneven = 2.5;
  return m.heightBelow <= mostUneven * m.heightAbove || m.aboveOnBorder;
}

// Scans rows of one color. `offset` is the position of the color's far end relative to `start`
// (pixels, positive: down).
void FlagSpecialist::scanRows(const CameraImage& picture, const Vector2d& start, double offset,
                              ColorSet colors, double& widest) {
  const Vector2d along = picture.horizon.along;
  for (const double part : parts) {
    const Vector2d p = start + picture.horizon.down * (offset * part);
    if (!picture.contains(p) || !colors.contains(picture.classAt(p))) continue;
    const ColorEdge left = picture.findEdge(p, -along, colors, maxGap);
    const ColorEdge right = picture.findEdge(p, along, colors, maxGap);
    const double l = along.dot(left.point - start), r = along.dot(right.point - start);
    // Behind the upper part of a flag there may be more of its color.
    constexpr double margin = 2;
    const bool first = widest == 0;
    if (first || l >= leftmost_ - margin) {
      leftmost_ = first ? l : std::min(leftmost_, l);
      left_.add(azimuth(picture.ray(left.point)), left.onBorder);
    }
    if (first || r <= rightmost_ + margin) {
      rightmost_ = first ? r : std::max(rightmost_, r);
      right_.add(azimuth(picture.ray(right.point)), right.onBorder);
    }
    widest = rightmost_ - leftmost_;
  }
}

bool FlagSpecialist::scanWidth(const CameraImage& picture, const Vector2d& start,
                               const Measurement& m) {
  left_.clear();
  right_.clear();
  double widest = 0;
  // Green cannot always be distinguished from the background (report 3.2.4).
  if (!m.otherIsGreen || !m.pinkAbove) scanRows(picture, start, m.heightBelow, m.lower, widest);
  if (!m.otherIsGreen || m.pinkAbove) scanRows(picture, start, -m.heightAbove, m.upper, widest);
  return !left_.empty() && widest >= 1.5;
}

// Tests nine points between the flag's sides, in a range of `height` from `from` on (pixels down
// from `start`).
FlagSpecialist::Places FlagSpecialist::look(const CameraImage& picture, const Vector2d& start,
                                            double from, double height, ColorSet colors) const {
  Places places;
  for (const double down : parts)
    for (const double across : parts) {
      const Vector2d p = start + picture.horizon.down * (from + height * down) +
                         picture.horizon.along * (leftmost_ + (rightmost_ - leftmost_) * across);
      if (!picture.contains(p)) continue;
      ++places.inside;
      places.colored += colors.contains(picture.classAt(p)) ? 1 : 0;
    }
  return places;
}

// Blurred edges between other colors look like the edge between a flag's colors, but do not have
// its two colored areas.
bool FlagSpecialist::isSolid(const CameraImage& picture, const Vector2d& start,
                             const Measurement& m) const {
  for (const bool upper : {true, false}) {
    const double height = upper ? -m.heightAbove : m.heightBelow;
    const auto [inside, right] = look(picture, start, 0, height, upper ? m.upper : m.lower);
    if (2 * right <= inside) return false;
  }
  return true;
}

// Below a flag is its white pole or a robot in front of it, but no other flag, no goal and no
// ground.
bool FlagSpecialist::standsOnPole(const CameraImage& picture, const Vector2d& start,
                                  const Measurement& m) const {
  constexpr int most = 4, mostOfUncertain = 2;  // of nine places
  constexpr ColorSet others{ColorClass::pink, ColorClass::yellow, ColorClass::skyblue,
                            ColorClass::green, ColorClass::orange};
  if (m.belowOnBorder) return true;
  const auto [inside, wrong] = look(picture, start, m.heightBelow + 1, m.heightBelow, others);
  return 9 * wrong <= (m.aboveGoesOn ? mostOfUncertain : most) * inside;
}

// Where a red tricot blurs into white, gray or a goal behind it, the mixture looks pink. It lies
// between red and gray, while a flag's pink is bluer. Only differences within the image count, so
// that brightness and a cast of the light hardly matter.
bool FlagSpecialist::isPaleRed(const CameraImage& picture, const Vector2d& start,
                               const Measurement& m) const {
  // How much bluer it is than red, by how much less red it is: a mixture 0.25, pink 2.
  constexpr double leastBlue = 0.6;
  struct Mean {
    double cb = 0, cr = 0;
    int pixels = 0;

    void add(const Pixel& p) {
      cb += p.cb;
      cr += p.cr;
      ++pixels;
    }
  };
  Mean pink, red;
  // Inside of the lower color, beside it and below it.
  for (const double down : {0.25, 0.5, 0.75, 1.25, 1.75})
    for (const double across : {-0.4, -0.15, 0.15, 0.5, 0.85, 1.15, 1.4}) {
      const Vector2d p = start + picture.horizon.down * (m.heightBelow * down) +
                         picture.horizon.along * (leftmost_ + (rightmost_ - leftmost_) * across);
      if (!picture.contains(p)) continue;
      const ColorClass color = picture.classAt(p);
      if (color == ColorClass::pink) pink.add(picture.pixelAt(p));
      if (color == ColorClass::red) red.add(picture.pixelAt(p));
    }
  if (pink.pixels == 0 || red.pixels == 0) return false;
  const double bluer = pink.cb / pink.pixels - red.cb / red.pixels;
  const double lessRed = red.cr / red.pixels - pink.cr / pink.pixels;
  return bluer < leastBlue * lessRed;
}

void FlagSpecialist::scanColumns(const CameraImage& picture, const Vector2d& start,
                                 const Measurement& m) {
  top_.clear();
  bottom_.clear();
  const Vector2d along = picture.horizon.along, down = picture.horizon.down;
  for (const double part : parts) {
    const Vector2d p = start + along * (leftmost_ + (rightmost_ - leftmost_) * part);
    const Vector2d above = p - down * (m.heightAbove * 0.5);
    const Vector2d below = p + down * (m.heightBelow * 0.5);
    if (m.aboveGoesOn) {
      top_.add(elevation(picture.ray(p - down * m.heightAbove)), true);
    } else if (picture.contains(above) && m.upper.contains(picture.classAt(above))) {
      const ColorEdge top = picture.findEdge(above, -down, m.upper, maxGap);
      top_.add(elevation(picture.ray(top.point)), top.onBorder);
    }
    if (picture.contains(below) && m.lower.contains(picture.classAt(below))) {
      const ColorEdge bottom = picture.findEdge(below, down, m.lower, maxGap);
      bottom_.add(elevation(picture.ray(bottom.point)), bottom.onBorder);
    }
  }
}

bool locateFlag(const CameraMatrix& matrix, const FieldDimensions& field, double middle,
                FlagPercept& flag) {
  const ConditionalBoundary& b = flag.boundary;
  const double width = b.left - b.right;
  const double height = std::tan(b.top) - std::tan(b.bottom);
  if (width <= 0 || height <= 0) return false;
  const bool wide = !b.leftOnBorder && !b.rightOnBorder;
  const bool high = !b.topOnBorder && !b.bottomOnBorder;
  const double flagHeight = field.flagTop - field.flagBottom;
  const double proportion = flagHeight / (2 * field.flagRadius);
  if (high && height < 0.55 * proportion * width) return false;
  if (wide && height > 1.6 * proportion * width) return false;

  // The edges at top and bottom are seen on the side that faces the camera; of what the image
  // cuts off one of the two colors may still be whole.
  const double half = !b.topOnBorder      ? std::tan(b.top) - std::tan(middle)
                      : !b.bottomOnBorder ? std::tan(middle) - std::tan(b.bottom)
                                          : 0;
  const double byWidth = wide ? field.flagRadius / std::sin(width / 2) : 0;
  const double byHeight = high       ? field.flagRadius + flagHeight / height
                          : half > 0 ? field.flagRadius + flagHeight / 2 / half
                                     : 0;
  // The height is twice the width and so twice as exact.
  const double distance = high && wide   ? (4 * byHeight + byWidth) / 5
                          : byHeight > 0 ? byHeight
                                         : byWidth;
  if (distance > farthestLandmark) return false;
  const Vector3d camera = matrix.pose.translation;
  if (distance > 0) {
    // What is not where a flag's edges must be is no flag.
    const double tolerance = 70 + 0.12 * distance;
    const auto isAt = [&](double elevation, double z) {
      const double side = distance - field.flagRadius;
      return std::abs(camera.z() + side * std::tan(elevation) - z) <= tolerance;
    };
    if (!b.topOnBorder && !isAt(b.top, field.flagTop)) return false;
    if (!b.bottomOnBorder && !isAt(b.bottom, field.flagBottom)) return false;
    if (!isAt(middle, (field.flagTop + field.flagBottom) / 2)) return false;
  }
  double bearing = (b.left + b.right) / 2;
  if (distance > field.flagRadius && !wide) {
    const double side = std::asin(field.flagRadius / distance);
    if (!b.leftOnBorder) bearing = b.left - side;
    if (!b.rightOnBorder) bearing = b.right + side;
  }
  const Vector2d axis = camera.head<2>() + direction(bearing) * distance;
  flag.distance = distance > 0 ? axis.norm() : 0;
  flag.angle = distance > 0 ? angleOf(axis) : bearing;
  return true;
}

}  // namespace gt
