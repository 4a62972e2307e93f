#include "modules/perception/processors/GridImageProcessor3.h"

namespace gt {
namespace {

const DebugKey drawBall{"ImageProcessor/blackWhiteBall"};

}  // namespace

void GridImageProcessor3::update(const Image& image, const CameraMatrix& matrix,
                                 const ColorTable64& colors, const FieldDimensions& field,
                                 Percepts found, Random& random, Debug& debug) {
  const auto findBall = [&](const CameraImage& picture, std::span<const BallSegment>) {
    ballSpecialist_.find(picture, field.ballRadius, random, found.ball);
    if (!found.ball.seen) ballSpotSpecialist_.find(picture, field.ballRadius, found.ball);
  };
  vision_.look(correction_.correct(image, horizonOf(matrix), colors), matrix, colors, field, found,
               debug, std::cref(findBall));
  auto canvas = debug.onImage(drawBall);
  if (!canvas) return;
  for (const BlackWhiteBallSpecialist::Edge& edge : ballSpecialist_.edges())
    canvas.point(edge.point, edge.onBall ? colors::green : colors::blue, 0.7);
  if (found.ball.seen)
    canvas.circle(found.ball.centerInImage, found.ball.radiusInImage, colors::red, 1);
}

}  // namespace gt
