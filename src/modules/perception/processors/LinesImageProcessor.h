#pragma once
#include "debug/Debug.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/colors/ImageCorrection.h"
#include "modules/perception/scanning/EdgeScanner.h"
#include "modules/perception/scanning/IndicationScanner.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {

/// Solution *Lines* of ImageProcessor: finds only points on edges of field lines, field border and
/// goals (report 3.2.2), the input of the self-locator Lines.
class LinesImageProcessor {
 public:
  /// Provides the points on edges; all other percepts are those of an image that shows nothing.
  /// Without a valid camera matrix there are no points.
  void update(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
              const FieldDimensions& field, Percepts found, Debug& debug);

 private:
  ImageCorrection correction_;
  ScanGrid grid_;
  IndicationScanner scanner_;
  EdgeScanner edgeScanner_;
};

}  // namespace gt
