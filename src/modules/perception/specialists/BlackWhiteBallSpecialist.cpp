#include "modules/perception/specialists/BlackWhiteBallSpecialist.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "modules/perception/specialists/BallView.h"

namespace gt {
namespace {

constexpr int cellSize = 5;                        // Pixels (report 4.1.1).
constexpr double smallest = 3, largest = 48;       // Pixels: the first and the last radius.
constexpr int minDifference = 24, minSobel = 110;  // Of the y channel.
constexpr int minVotes = 4;
constexpr std::size_t attempts = 10;  // Cells that are looked at, those with the most votes first.
constexpr double mostWrong = 1.5;  // That many times as large as the ball should be there at most.

/// The radius of a ball on the ground (pixels) for each pixel that it lies below the horizon; both
/// grow in proportion as it comes nearer.
double growth(const CameraMatrix& matrix, double ballRadius) {
  return ballRadius / std::max(matrix.pose.translation.z() - ballRadius, 20.0);
}

bool isBall(ColorClass c) {
  constexpr ColorSet ballColors{ColorClass::white, ColorClass::black, ColorClass::gray};
  return ballColors.contains(c);
}

}  // namespace

void BlackWhiteBallSpecialist::find(const CameraImage& picture, double ballRadius, Random& random,
                                    BallPercept& percept) {
  percept = {};
  for (std::size_t i = 0; i < radii; ++i)
    radius_[i] = smallest * std::pow(largest / smallest, static_cast<double>(i) / (radii - 1));
  findEdges(picture, ballRadius);
  vote(picture, ballRadius);
  const std::size_t most = std::min(attempts, candidates_.size());
  const auto last = candidates_.begin() + static_cast<std::ptrdiff_t>(most);
  std::partial_sort(candidates_.begin(), last, candidates_.end(),
                    [&](std::size_t a, std::size_t b) {
                      return votes_[a] != votes_[b] ? votes_[a] > votes_[b] : a < b;
                    });
  for (std::size_t i = 0; i < most; ++i) {
    if (look(picture, candidates_[i], ballRadius, random, percept)) return;
    percept = {};
  }
}

// Where balls are large, fewer rows suffice to see them. A ball at the horizon reaches above it.
void BlackWhiteBallSpecialist::findEdges(const CameraImage& picture, double ballRadius) {
  constexpr double rowsPerRadius = 5, highest = -2 * smallest, mostStep = 6;
  edges_.clear();
  const CameraInfo& info = picture.image.info;
  const double grows = growth(picture.matrix, ballRadius);
  for (int y = 1; y < info.height - 1;) {
    const double left = picture.horizon.fromImage({0, y + 0.5}).y();
    const double right = picture.horizon.fromImage({double(info.width), y + 0.5}).y();
    if (!std::isfinite(left + right + grows)) return;  // of a camera matrix that overflows
    int from = 1, to = info.width - 1;
    if (left < highest || right < highest) {
      // Where the row crosses the border of what is looked at.
      const double crossing =
          left == right ? 0 : std::clamp((highest - left) / (right - left), 0.0, 1.0);
      const int x = static_cast<int>(info.width * crossing);
      if (left < highest) from = right < highest ? to : std::max(x, from);
      if (right < highest) to = std::min(x, to);
    }
    scanRow(picture, y, from, to);
    const double radius = std::max(left, right) * grows;
    y += static_cast<int>(std::clamp(radius / rowsPerRadius, 1.0, mostStep));
  }
}

void BlackWhiteBallSpecialist::scanRow(const CameraImage& picture, int y, int from, int to) {
  constexpr int block = 16;
  const Image& image = picture.image;
  const Pixel* row = &image.at(0, y);
  const Pixel *above = &image.at(0, y - 1), *below = &image.at(0, y + 1);
  const auto difference = [&](int x) { return std::abs(row[x + 1].y - row[x - 1].y); };
  for (int x = from; x < to; ++x) {
    // Most pixels are not near any edge: their two neighbors show that, for many at once.
    if (x + block <= to) {
      bool any = false;
      for (int i = 0; i < block; ++i) any |= difference(x + i) >= minDifference;
      if (!any) {
        x += block - 1;
        continue;
      }
    }
    for (const int end = std::min(x + block, to); x < end; ++x) {
      if (difference(x) < minDifference) continue;
      const int gx = above[x + 1].y + 2 * row[x + 1].y + below[x + 1].y - above[x - 1].y -
                     2 * row[x - 1].y - below[x - 1].y;
      if (std::abs(gx) < minSobel) continue;
      const int gy = below[x - 1].y + 2 * below[x].y + below[x + 1].y - above[x - 1].y -
                     2 * above[x].y - above[x + 1].y;
      testEdge(picture, x, y, Vector2d(gx, gy));
      ++x;  // An edge is two pixels wide at least.
    }
    --x;
  }
}

// Most pixels left, right, above and below the edge must be green, white or black, and one side
// must belong to the ball (report 4.1.1).
void BlackWhiteBallSpecialist::testEdge(const CameraImage& picture, int x, int y,
                                        const Vector2d& gradient) {
  constexpr int near = 2, far = 4, minInside = 2;
  const Image& image = picture.image;
  int known = 0, all = 0;
  struct Side {
    int ball = 0, green = 0;
  };
  const auto count = [&](int dx, int dy) {
    Side side;
    for (int i = near; i <= far; ++i) {
      const int px = x + i * dx, py = y + i * dy;
      if (px < 0 || py < 0 || px >= image.info.width || py >= image.info.height) continue;
      const ColorClass c = picture.colors[image.at(px, py)];
      ++all;
      side.green += c == ColorClass::green ? 1 : 0;
      side.ball += isBall(c) ? 1 : 0;
    }
    known += side.green + side.ball;
    return side;
  };
  const Side left = count(-1, 0), right = count(1, 0);
  const bool leftInside = left.ball - left.green > right.ball - right.green;
  const Side &inside = leftInside ? left : right, &outside = leftInside ? right : left;
  Edge edge;
  edge.point = {x + 0.5, y + 0.5};
  if (inside.ball >= minInside && inside.green == 0) {
    const Side above = count(0, -1), below = count(0, 1);
    edge.onBall = 3 * known >= 2 * all && outside.green + above.green + below.green > 0;
    edge.inward = gradient.normalized() * (gradient.x() > 0 ? 1 : -1) * (leftInside ? -1 : 1);
  }
  edges_.push_back(edge);
}

// Each point of the boundary votes for the cells in which the center may lie: all of a circle in
// the report, here the part of it into which the edge points. Radii that no ball on the ground has
// there are left out.
void BlackWhiteBallSpecialist::vote(const CameraImage& picture, double ballRadius) {
  cellsX_ = picture.image.info.width / cellSize + 1;
  cellsY_ = picture.image.info.height / cellSize + 1;
  candidates_.clear();
  votes_.assign(radii * static_cast<std::size_t>(cellsX_ * cellsY_), 0);
  const double grows = growth(picture.matrix, ballRadius);
  for (const Edge& edge : edges_) {
    if (!edge.onBall) continue;
    const double below = picture.horizon.fromImage(edge.point).y();
    for (std::size_t i = 0; i < radii; ++i) {
      // The edge is at most a radius above or below the center.
      const double least = (below - radius_[i]) * grows / mostWrong;
      const double most = (below + radius_[i]) * grows * mostWrong + 2;
      if (!picture.matrix.valid || (radius_[i] > least && radius_[i] < most))
        voteFor(edge, i, radius_[i]);
    }
  }
}

void BlackWhiteBallSpecialist::voteFor(const Edge& edge, std::size_t radius, double pixels) {
  constexpr double halfArc = 0.35;  // rad
  const int steps = static_cast<int>(halfArc * pixels / cellSize);
  std::size_t last = votes_.size();
  for (int i = -steps; i <= steps; ++i) {
    const double turn = i * cellSize / pixels;
    const Vector2d way = edge.inward + turn * Vector2d{-edge.inward.y(), edge.inward.x()};
    const Vector2d center = edge.point + pixels / std::sqrt(1 + turn * turn) * way;
    if (center.x() < 0 || center.y() < 0) continue;
    const int cx = static_cast<int>(center.x()) / cellSize;
    const int cy = static_cast<int>(center.y()) / cellSize;
    if (cx >= cellsX_ || cy >= cellsY_) continue;
    const std::size_t cell =
        (radius * static_cast<std::size_t>(cellsY_) + static_cast<std::size_t>(cy)) *
            static_cast<std::size_t>(cellsX_) +
        static_cast<std::size_t>(cx);
    if (cell != last && ++votes_[cell] == minVotes) candidates_.push_back(cell);
    last = cell;
  }
}

Vector2d BlackWhiteBallSpecialist::cellCenter(std::size_t cell) const {
  const auto width = static_cast<std::size_t>(cellsX_), height = static_cast<std::size_t>(cellsY_);
  return cellSize * Vector2d{static_cast<double>(cell % width) + 0.5,
                             static_cast<double>(cell / width % height) + 0.5};
}

bool BlackWhiteBallSpecialist::look(const CameraImage& picture, std::size_t cell, double ballRadius,
                                    Random& random, BallPercept& percept) {
  Vector2d center = cellCenter(cell);
  double radius = radius_[cell / static_cast<std::size_t>(cellsX_ * cellsY_)];
  if (!isFull(picture, center, radius, random) || !traceCircle(picture, center, radius) ||
      !isFull(picture, center, radius, random))
    return false;
  const Vector3d axis = picture.ray(center);
  const Vector3d side = picture.ray(center + picture.horizon.along * radius);
  const double angle = std::acos(std::clamp(axis.dot(side), -1.0, 1.0));
  constexpr double radiusError = 0.6;  // Pixels.
  if (!describeBall(picture, {axis, angle, radiusError / focalLength(picture.matrix.info)},
                    ballRadius, percept))
    return false;
  percept.seen = isOnGround(picture, percept, axis, ballRadius);
  return percept.seen;
}

// Follows paths from within the ball to all sides while the image is black and white, because
// eleven radii and cells of five pixels alone give poor distances. Next to a line or a robot the
// path continues beyond the ball: only ends that are about as far away as the others count.
bool BlackWhiteBallSpecialist::traceCircle(const CameraImage& picture, Vector2d& center,
                                           double& radius) {
  constexpr int rays = 24, least = 8, maxGap = 1, mostColor = 16;
  const auto belongs = [](const Pixel& pixel, ColorClass c) {
    return isBall(c) || (c == ColorClass::noColor && std::abs(pixel.cb - 128) < mostColor &&
                         std::abs(pixel.cr - 128) < mostColor);
  };
  std::array<Vector2d, rays> points;
  int count = 0;
  for (int i = 0; i < rays; ++i) {
    const ColorEdge edge =
        picture.findEdgeOf(center, direction(2 * pi * i / rays), maxGap, belongs);
    if (!edge.onBorder) points[static_cast<std::size_t>(count++)] = edge.point;
  }
  int inside = 0;
  const double found = radius;
  for (const double tolerance : {0.5, 0.3, 0.2}) {
    // |p|^2 = 2 p.c + (r^2 - |c|^2), which is linear, around the center known so far.
    Matrix3d a = Matrix3d::Zero();
    Vector3d b = Vector3d::Zero();
    inside = 0;
    for (int i = 0; i < count; ++i) {
      const Vector2d p = points[static_cast<std::size_t>(i)] - center;
      if (std::abs(p.norm() - radius) > std::max(tolerance * radius, 1.0)) continue;
      const Vector3d row{p.x(), p.y(), 1};
      a += row * row.transpose();
      b += row * p.squaredNorm();
      ++inside;
    }
    if (inside < least || std::abs(a.determinant()) < 1e-6) return false;
    const Vector3d solution = a.inverse() * b;
    const Vector2d shift = solution.head<2>() / 2;
    const double squared = solution.z() + shift.squaredNorm();
    if (!(squared > 0) || shift.norm() > radius) return false;
    center += shift;
    radius = std::sqrt(squared);
    if (radius < 0.5 * found || radius > 1.8 * found) return false;
  }
  return 5 * inside >= 2 * count;
}

// At least half of 80 pixels chosen at random must be black or white, and a tenth must be black
// (report 4.1.1). Some must be white, because legs of robots are gray and black.
bool BlackWhiteBallSpecialist::isFull(const CameraImage& picture, const Vector2d& center,
                                      double radius, Random& random) {
  constexpr int samples = 80, first = 16;
  int inside = 0, ball = 0, black = 0, white = 0;
  for (int i = 0; i < samples; ++i) {
    Vector2d p{random.symmetric(), random.symmetric()};
    while (p.squaredNorm() > 1) p = {random.symmetric(), random.symmetric()};
    p = center + radius * p;
    if (!picture.contains(p)) continue;
    const ColorClass c = picture.classAt(p);
    ++inside;
    ball += isBall(c) ? 1 : 0;
    black += c == ColorClass::black ? 1 : 0;
    white += c == ColorClass::white ? 1 : 0;
    // Most places are nothing like a ball.
    if (i == first && (black == 0 || white == 0)) return false;
  }
  return 2 * inside >= samples / 2 && 2 * ball >= inside && 10 * black >= inside &&
         10 * white >= inside;
}

}  // namespace gt
