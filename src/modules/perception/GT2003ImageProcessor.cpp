#include "modules/perception/GT2003ImageProcessor.h"

#include <algorithm>

namespace gt {
namespace {

const DebugKey drawHorizon{"ImageProcessor/horizon"};
const DebugKey drawGrid{"ImageProcessor/grid"};
const DebugKey drawIndications{"ImageProcessor/indications"};
const DebugKey drawPercepts{"ImageProcessor/percepts"};

}  // namespace

// Objects that are small in the picture are far away and so close to the horizon. Lines of one
// spacing have to reach as far as the largest object that only they would meet twice, which the
// next coarser lines, twice as far apart, do not.
GridSpacing GT2003ImageProcessor::spacing(const CameraMatrix& matrix,
                                          const FieldDimensions& field) const {
  const double height = std::max(matrix.pose.translation.z(), field.ballRadius);
  GridSpacing spacing;
  spacing.dense = parameters.denseSpacing;
  spacing.reachDown = 2 * height / field.ballRadius;
  spacing.reachUp = std::clamp(4 * (field.flagTop - height) / (2 * field.flagRadius), 2.0, 12.0);
  return spacing;
}

void GT2003ImageProcessor::update(const Image& image, const CameraMatrix& matrix,
                                  const ColorTable64& colors, const FieldDimensions& field,
                                  BallPercept& ball, LandmarksPercept& landmarks, Debug& debug) {
  const Horizon horizon = horizonOf(matrix);
  const Picture picture{image, colors, matrix, horizon};
  grid_.build(image.info, horizon, spacing(matrix, field));
  scanner_.clear();
  for (const ScanLine& line : grid_.lines()) scanner_.scan(picture, line);

  ballSpecialist_.find(picture, scanner_.balls, field.ballRadius, ball);
  ball.time = image.time;
  landmarks.time = image.time;
  landmarks.cameraOffset = matrix.pose.translation;
  flagSpecialist_.find(picture, scanner_.flags, field, landmarks);
  goalSpecialist_.find(picture, scanner_.goals, field, landmarks);
  draw(picture, ball, landmarks, debug);
}

void GT2003ImageProcessor::draw(const Picture& picture, const BallPercept& ball,
                                const LandmarksPercept& landmarks, Debug& debug) const {
  const double wide = picture.image.info.width;
  if (auto canvas = debug.onImage(drawHorizon))
    canvas.line(picture.horizon.toPicture(-wide, 0), picture.horizon.toPicture(wide, 0),
                colors::white);
  if (auto canvas = debug.onImage(drawGrid))
    for (const ScanLine& line : grid_.lines())
      canvas.line(line.start, line.at(line.length - 1), colors::gray);
  if (auto canvas = debug.onImage(drawIndications)) {
    for (const BallSegment& s : scanner_.balls) canvas.line(s.upper, s.lower, colors::red);
    for (const FlagIndication& f : scanner_.flags) canvas.point(f.position, colors::pink, 2);
    for (const GoalIndication& g : scanner_.goals) canvas.line(g.top, g.bottom, colors::blue);
  }
  if (auto canvas = debug.onImage(drawPercepts)) {
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
  }
}

}  // namespace gt
