#pragma once
#include "colors/TslColors.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"

namespace gt {

/// Solution *GridImageProcessorTSL* of ImageProcessor: finds what GT2003 finds with color classes
/// in the TSL space (report J.6.3), which suffer less from other light.
class GridImageProcessorTSL {
 public:
  /// Provides what GT2003 provides, with the same limits.
  void update(const Image& image, const CameraMatrix& matrix, const TslColors& colors,
              const FieldDimensions& field, Percepts found, Debug& debug);

 private:
  TslColors known_;  ///< What the table was made from.
  ColorTable64 table_;
  GT2003ImageProcessor vision_;
};

}  // namespace gt
