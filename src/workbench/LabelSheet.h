#pragma once
#include "labels/LabelEditor.h"
#include "representations/infrastructure/Image.h"
#include "views/painting/Sheet.h"

namespace gt {

/// An image as a sheet on which labels are drawn.
class LabelSheet {
 public:
  /// Units of the sheet for a pixel of the image.
  static constexpr int zoom = 3;

  explicit LabelSheet(const Image& image);

  /// Adds the percepts in the image, in pink; percepts of other images are ignored.
  void addPercepts(const SeenInImage& seen);
  /// Adds the labels of the image with a number, in green.
  void addLabels(const ImageLabels& labels, int number);
  /// Adds a label that is being drawn between two pixels, in white. Only balls and rectangles are
  /// shown.
  void addUnfinished(const LabelTool& tool, const Vector2d& from, const Vector2d& to);

  const Sheet& sheet() const { return sheet_; }

 private:
  Time taken_;
  Sheet sheet_;
};

}  // namespace gt
