#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "labels/LabelErrors.h"

namespace gt {

/// A kind of label, and the way a person marks it in an image.
struct LabelTool {
  enum class Kind {
    ball,      ///< From center to rim.
    noBall,    ///< Anywhere.
    line,      ///< Point by point, along its center.
    leftPost,  ///< At the point where it meets the ground.
    rightPost,
    box,     ///< From corner to corner.
    nothing  ///< Nothing of a field is visible.
  };

  std::string name;
  Kind kind = Kind::ball;
  BallView view = BallView::whole;
  BoxName box{};
};

/// All tools, in the order in which a person chooses from them.
std::vector<LabelTool> labelTools();

/// Edits labels, with undo.
class LabelEditor {
 public:
  const ImageLabels& labels() const { return labels_; }
  /// Replaces all labels and clears the undo history.
  void load(ImageLabels labels);

  /// Marks something in an image that was taken at a time (ms); positions are in pixels. A label
  /// that an image can have only once replaces the previous one.
  void draw(int picture, std::int64_t time, const LabelTool& tool, const Vector2d& from,
            const Vector2d& to);
  /// Ends the line; the next point begins another one.
  void endLine() { lineOf_ = -1; }
  /// Names of the labels in an image: ball, line1, leftPost, flag.pinkAboveYellow, …
  std::vector<std::string> names(int picture) const;
  void remove(int picture, const std::string& name);
  /// Undoes the last change, up to a hundred. Returns false if there is none.
  bool undo();

  /// Whether the labels were changed since they were loaded or saved.
  bool changed() const { return changed_; }
  void saved() { changed_ = false; }

 private:
  void remember();

  ImageLabels labels_;
  std::deque<ImageLabels> before_;
  int lineOf_ = -1;  ///< Number of the image whose last line is being continued.
  bool changed_ = false;
};

}  // namespace gt
