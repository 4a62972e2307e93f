#include "modules/perception/processors/GT2003ImageProcessor.h"

#include <algorithm>

#include "modules/perception/scanning/FieldView.h"
#include "modules/perception/scanning/ScanDrawing.h"

namespace gt {
namespace {

const DebugKey drawHorizon{"ImageProcessor/horizon"};
const DebugKey drawIndications{"ImageProcessor/indications"};
const DebugKey drawSpecialistsPaths{"ImageProcessor/specialists"};
const DebugKey drawOnGround{"ImageProcessor/ground"};
const DebugKey drawFreeGround{"ImageProcessor/freeGround"};
const DebugKey drawFound{"ImageProcessor/percepts"};

Color colorOf(TeamColor team) {
  return team == TeamColor::red ? colors::red : colors::blue;
}

}  // namespace

// Objects that are small in the image are far away and therefore close to the horizon. Lines of one
// spacing must reach as far from the horizon as the largest object that they meet twice, but that
// the next coarser lines, twice as far apart, do not meet twice.
GridSpacing GT2003ImageProcessor::spacing(const CameraMatrix& matrix,
                                          const FieldDimensions& field) const {
  const double height = std::max(matrix.pose.translation.z(), field.ballRadius);
  GridSpacing spacing;
  spacing.dense = parameters.denseSpacing;
  spacing.reachDown = 2 * height / field.ballRadius;
  spacing.reachUp = std::clamp(4 * (field.flagTop - height) / (2 * field.flagRadius), 2.0, 12.0);
  return spacing;
}

void GT2003ImageProcessor::look(const Image& image, const CameraMatrix& matrix,
                                const ColorTable64& colors, const FieldDimensions& field,
                                const Percepts& found, Debug& debug, const FindBall& findBall) {
  fetch(image);
  const Horizon horizon = horizonOf(matrix);
  paths_.clear();
  const bool watched = debug.isActive(drawSpecialistsPaths);
  const CameraImage picture{image, colors, matrix, horizon, watched ? &paths_ : nullptr};
  grid_.build(image.info, horizon, spacing(matrix, field));
  scan(picture, grid_, field, scanner_, edgeScanner_);
  if (!matrix.valid) found.clear(image.time);
  findBall(picture, scanner_.balls);
  if (matrix.valid) findPlaces(picture, field, found);
  found.setTime(image.time);
  drawScan(picture, debug);
  drawSpecialists(matrix.valid, debug);
  drawPercepts(picture, found, debug);
  drawGround(found, debug);
}

void GT2003ImageProcessor::findPlaces(const CameraImage& picture, const FieldDimensions& field,
                                      const Percepts& found) {
  found.landmarks.cameraOffset = picture.matrix.pose.translation;
  flagSpecialist_.find(picture, scanner_.flags, field, found.landmarks);
  goalSpecialist_.find(picture, scanner_.goals, field, found.landmarks);
  edgeScanner_.finish(found.lines);
  const CameraMatrix& corrected =
      tiltCorrection_.correct(picture.matrix, found.ball, found.landmarks, field);
  const CameraImage level{picture.image, picture.colors, corrected, picture.horizon, picture.paths};
  playerSpecialist_.find(level, scanner_.players, found.players);
  findFreeGround(level, found.obstacles);
}

void GT2003ImageProcessor::findFreeGround(const CameraImage& picture,
                                          ObstaclesPercept& percept) const {
  percept.lines.clear();
  for (const GreenSection& green : scanner_.greens) {
    const auto nearPoint = onGround(picture, green.end);
    if (!nearPoint) continue;
    // Green up to the horizon is as far as a field can reach.
    auto farPoint = onGround(picture, green.begin);
    if (!farPoint)
      farPoint = picture.matrix.pose.translation.head<2>() +
                 farthestOnGround * picture.ray(green.begin).head<2>().normalized();
    percept.lines.push_back({*nearPoint, *farPoint, green.beginOnBorder});
  }
}

void GT2003ImageProcessor::drawScan(const CameraImage& picture, Debug& debug) const {
  const double wide = picture.image.info.width;
  if (auto canvas = debug.onImage(drawHorizon))
    canvas.line(picture.horizon.toPicture(-wide, 0), picture.horizon.toPicture(wide, 0),
                colors::white);
  drawGrid(grid_, debug);
  if (auto canvas = debug.onImage(drawIndications)) {
    for (const BallSegment& s : scanner_.balls) canvas.line(s.upper, s.lower, colors::red);
    for (const FlagIndication& f : scanner_.flags) canvas.point(f.position, colors::pink, 2);
    for (const GoalIndication& g : scanner_.goals) canvas.line(g.top, g.bottom, colors::blue);
    for (const PlayerIndication& p : scanner_.players)
      canvas.line(p.upper, p.lower, colorOf(p.team));
  }
  drawEdges(edgeScanner_, debug);
  if (auto canvas = debug.onImage(drawFreeGround))
    for (const GreenSection& green : scanner_.greens)
      canvas.line(green.end, green.begin, colors::green);
}

void GT2003ImageProcessor::drawPercepts(const CameraImage& picture, const Percepts& found,
                                        Debug& debug) const {
  auto canvas = debug.onImage(drawFound);
  if (!canvas) return;
  const auto& [ball, landmarks, lines, players, obstacles] = found;
  if (ball.seen) canvas.circle(ball.centerInImage, ball.radiusInImage, colors::red, 2);
  const auto outline = [&](const ConditionalBoundary& b, Color color) {
    const auto corner = [&](double azimuth, double elevation) {
      return picture.pointOf({std::cos(azimuth), std::sin(azimuth), std::tan(elevation)});
    };
    canvas.polygon({corner(b.left, b.top), corner(b.right, b.top), corner(b.right, b.bottom),
                    corner(b.left, b.bottom)},
                   color, 2);
  };
  for (int i = 0; i < landmarks.numberOfFlags; ++i)
    outline(landmarks.flags[static_cast<std::size_t>(i)].boundary, colors::pink);
  for (int i = 0; i < landmarks.numberOfGoals; ++i)
    outline(landmarks.goals[static_cast<std::size_t>(i)].boundary, colors::blue);
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    for (const Vector2d& p : players.players[team]) {
      const Vector3d ray = Vector3d{p.x(), p.y(), 0} - picture.matrix.pose.translation;
      if (picture.matrix.pose.rotation.col(0).dot(ray) > 0)
        canvas.point(picture.pointOf(ray), colorOf(team), 4);
    }
}

// The pixels that the specialists have touched, and the edges that they have found there
// (report, figure 3.3c).
void GT2003ImageProcessor::drawSpecialists(bool hasPlaces, Debug& debug) const {
  auto canvas = debug.onImage(drawSpecialistsPaths);
  if (!canvas) return;
  for (const ScanPath& path : paths_) canvas.line(path.start, path.end.point, colors::gray);
  for (const ScanPath& path : paths_)
    if (!path.end.onBorder) canvas.point(path.end.point, colors::green, 0.7);
  if (!hasPlaces) return;
  for (const Vector2d& foot : playerSpecialist_.feet()) canvas.point(foot, colors::pink, 0.7);
}

// Draws the percepts on the ground, relative to the robot (report, figure 3.1b).
void GT2003ImageProcessor::drawGround(const Percepts& found, Debug& debug) const {
  auto canvas = debug.onRobot(drawOnGround);
  if (!canvas) return;
  const auto& [ball, landmarks, lines, players, obstacles] = found;
  for (const FreeGround& line : obstacles.lines) {
    canvas.line(line.nearPoint, line.farPoint, colors::green);
    if (!line.farOnBorder) canvas.point(line.farPoint, colors::black, 15);
  }
  for (std::size_t t = 0; t < enumCount<EdgeType>; ++t)
    for (const Vector2d& p : lines.points[static_cast<EdgeType>(t)])
      canvas.point(p, colorOf(static_cast<EdgeType>(t)), 20);
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    for (const Vector2d& p : players.players[team]) canvas.circle(p, 120, colorOf(team), 2);
  if (ball.seen) canvas.disk(ball.offset, 43, colors::orange);
}

}  // namespace gt
