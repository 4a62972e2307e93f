#pragma once
#include "colors/TslColors.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"

namespace gt {

/// Solution *GridImageProcessorTSL* of ImageProcessor: finds the same objects as GT2003, but with
/// color classes in the TSL space (report J.6.3), which depend less on the light.
class GridImageProcessorTSL {
 public:
  /// Provides the same percepts as GT2003, under the same conditions.
  void update(const Image& image, const CameraMatrix& matrix, const TslColors& colors,
              const FieldDimensions& field, Percepts found, Debug& debug);

 private:
  TslColors known_;  ///< The color classes from which `table_` was computed.
  ColorTable64 table_;
  GT2003ImageProcessor vision_;
};

}  // namespace gt
