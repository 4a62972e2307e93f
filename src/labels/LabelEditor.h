#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "labels/LabelErrors.h"

namespace gt {

/// What a person marks in an image, and how.
struct LabelTool {
  enum class Kind {
    ball,      ///< From the middle to the rim.
    noBall,    ///< Anywhere.
    line,      ///< Point by point, along its middle.
    leftPost,  ///< Where it meets the ground.
    rightPost,
    box,     ///< From corner to corner.
    nothing  ///< Nothing of a field can be seen.
  };

  std::string name;
  Kind kind = Kind::ball;
  BallView view = BallView::whole;
  BoxName box{};
};

/// All tools, in the order in which a person chooses from them.
std::vector<LabelTool> labelTools();

/// Labels that are edited, with undo.
class LabelEditor {
 public:
  const ImageLabels& labels() const { return labels_; }
  /// Begins with other labels.
  void load(ImageLabels labels);

  /// Marks something in an image that was taken at a time (ms); places are pixels. What one image
  /// has once replaces what it had.
  void draw(int picture, std::int64_t time, const LabelTool& tool, const Vector2d& from,
            const Vector2d& to);
  /// The next point of a line begins another one.
  void endLine() { lineOf_ = -1; }
  /// What is labeled in an image: ball, line1, leftPost, flag.pinkAboveYellow, …
  std::vector<std::string> names(int picture) const;
  void remove(int picture, const std::string& name);
  /// Takes the last change back, up to a hundred; false if there is none.
  bool undo();

  /// Whether anything was changed since the labels were loaded or saved.
  bool changed() const { return changed_; }
  void saved() { changed_ = false; }

 private:
  void remember();

  ImageLabels labels_;
  std::deque<ImageLabels> before_;
  int lineOf_ = -1;  ///< The image whose last line goes on.
  bool changed_ = false;
};

}  // namespace gt
