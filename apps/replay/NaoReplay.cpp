#include "replay/NaoReplay.h"

#include <cmath>

namespace gt {

FieldDimensions fieldOf2009() {
  FieldDimensions field;
  field.ballRadius = 43;
  field.goalHeight = 800;
  field.yGoal = 700;
  return field;
}

NaoReplay::NaoReplay(const NaoLog& log, const ColorTable64& colors) : log_(log), colors_(colors) {
  for (const char* name : {"ImageProcessor/horizon", "ImageProcessor/percepts"})
    if (const DebugKey* key = DebugKey::find(name)) debug_.keys().set(*key, {DebugKeyMode::always});
}

Result<void> NaoReplay::look(const NaoPicture& picture, NaoView& view) {
  if (auto done = log_.decode(picture, view.image); !done) return done;
  debug_.begin(view.image.time);
  debug_.out().clear();
  imageProcessor_.update(view.image, picture.cameraMatrix, colors_, field_, view.ball,
                         view.landmarks, debug_);
  view.drawings.clear();
  debug_.out().handleAllMessages([&](const Message& message) {
    Drawing drawing;
    if (message.is<Drawing>() && message.read(drawing)) view.drawings.push_back(drawing);
  });
  return {};
}

double differenceOfDistances(const BallPercept& ball) {
  if (ball.distanceByProjection <= 0 || ball.distanceBySize <= 0) return 0;
  return ball.distanceByProjection / ball.distanceBySize - 1;
}

Verdict compareDistances(const BallPercept& ball, const BallLabel* label) {
  constexpr double nearest = 1500, most = 0.1, sameRadius = 0.05;
  if (!ball.seen || ball.distanceByProjection <= 0 || ball.distanceBySize <= 0)
    return Verdict::notCompared;
  if (std::min(ball.distanceBySize, ball.distanceByProjection) >= nearest)
    return Verdict::notCompared;
  if (std::abs(differenceOfDistances(ball)) <= most) return Verdict::agree;
  if (!label || label->view != BallView::whole) return Verdict::notKnown;
  return std::abs(ball.radiusInImage / label->radius - 1) <= sameRadius ? Verdict::cameraMatrixIsOff
                                                                        : Verdict::visionIsOff;
}

}  // namespace gt
