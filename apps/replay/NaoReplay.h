#pragma once
#include <vector>

#include "modules/perception/GT2003ImageProcessor.h"
#include "replay/Labels.h"
#include "robot/logs/NaoLog.h"

namespace gt {

/// The league of that log: only what vision needs (facts, 3). Against the field line's 50 mm the
/// ball is 86 mm wide in the pictures.
FieldDimensions fieldOf2009();

/// What vision makes of one picture of a log.
struct NaoView {
  Image image;
  BallPercept ball;
  LandmarksPercept landmarks;
  std::vector<Drawing> drawings;
};

/// Shows a log's pictures with their recorded camera matrices to the robot's own image processor.
class NaoReplay {
 public:
  NaoReplay(const NaoLog& log, const ColorTable64& colors);

  Result<void> look(const NaoPicture& picture, NaoView& view);

 private:
  const NaoLog& log_;
  const ColorTable64& colors_;
  FieldDimensions field_ = fieldOf2009();
  GT2003ImageProcessor imageProcessor_;
  Debug debug_;
};

/// Who is to blame where the two distances of a ball differ.
enum class Verdict { notCompared, agree, visionIsOff, cameraMatrixIsOff, notKnown };

/// How much further away the projection puts the ball than its size does; 0 if one is not known.
double differenceOfDistances(const BallPercept& ball);

/// Compares the two distances of a ball nearer than 1.5 m. Where they differ by more than 10 %, a
/// person's circle decides: if vision's radius is within 5 % of it, the size is right and the
/// camera matrix is off.
Verdict compareDistances(const BallPercept& ball, const BallLabel* label);

}  // namespace gt
