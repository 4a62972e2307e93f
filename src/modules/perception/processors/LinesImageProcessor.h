#pragma once
#include "debug/Debug.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/scanning/EdgeScanner.h"
#include "modules/perception/scanning/LineScanner.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {

/// Finds points on edges of lines, border and goals and nothing else (report 3.2.2), which is all
/// that the LinesSelfLocator needs; the solution Lines of the ImageProcessor.
class LinesImageProcessor {
 public:
  void update(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
              const FieldDimensions& field, BallPercept& ball, LandmarksPercept& landmarks,
              LinesPercept& lines, PlayersPercept& players, ObstaclesPercept& obstacles,
              Debug& debug);

 private:
  ScanGrid grid_;
  LineScanner scanner_;
  EdgeScanner edgeScanner_;
};

}  // namespace gt
