#include "modules/perception/processors/GridImageProcessor3.h"

namespace gt {
namespace {

const DebugKey drawBall{"ImageProcessor/blackWhiteBall"};

}  // namespace

void GridImageProcessor3::update(const Image& image, const CameraMatrix& matrix,
                                 const ColorTable64& colors, const FieldDimensions& field,
                                 BallPercept& ball, LandmarksPercept& landmarks,
                                 LinesPercept& lines, PlayersPercept& players,
                                 ObstaclesPercept& obstacles, Random& random, Debug& debug) {
  const auto findBall = [&](const CameraImage& picture, std::span<const BallSegment>) {
    ballSpecialist_.find(picture, field.ballRadius, random, ball);
  };
  vision_.look(image, matrix, colors, field, {ball, landmarks, lines, players, obstacles}, debug,
               std::cref(findBall));
  auto canvas = debug.onImage(drawBall);
  if (!canvas) return;
  for (const BlackWhiteBallSpecialist::Edge& edge : ballSpecialist_.edges())
    canvas.point(edge.point, edge.onBall ? colors::green : colors::blue, 0.7);
  if (ball.seen) canvas.circle(ball.centerInImage, ball.radiusInImage, colors::red, 1);
}

}  // namespace gt
