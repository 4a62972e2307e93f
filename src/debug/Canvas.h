#pragma once
#include <memory>
#include <string>
#include <vector>

#include "debug/DebugKey.h"
#include "debug/Drawing.h"

namespace gt {

class Debug;

/// The drawing of a module while its key is active; it is sent when the canvas goes out of scope:
/// `if (auto canvas = debug.onField(key)) canvas.circle(...);` Positions and sizes are in mm on the
/// field or relative to the robot, or in pixels of the image.
class Canvas {
 public:
  Canvas() = default;
  Canvas(Debug& debug, const DebugKey& key, DrawingSpace space);
  ~Canvas() {
    if constexpr (debugging)
      if (drawing_) send();
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  explicit operator bool() const { return debugging && drawing_ != nullptr; }

  void point(const Vector2d& at, Color color = {}, double radius = 1);
  void line(const Vector2d& from, const Vector2d& to, Color color = {}, double penWidth = 1,
            PenStyle style = {});
  void arrow(const Vector2d& from, const Vector2d& to, Color color = {}, double penWidth = 1,
             PenStyle style = {});
  void circle(const Vector2d& center, double radius, Color color = {}, double penWidth = 1,
              PenStyle style = {});
  void disk(const Vector2d& center, double radius, Color color = {});
  /// An ellipse by its half axes; `direction` (rad) is that of the first one.
  void ellipse(const Vector2d& center, double first, double second, double direction,
               Color color = {}, double penWidth = 1, PenStyle style = {});
  /// A filled sector of a disk, counterclockwise from direction `from` to direction `to` (rad).
  void sector(const Vector2d& center, double radius, double from, double to, Color color = {});
  void path(std::vector<Vector2d> points, Color color = {}, double penWidth = 1,
            PenStyle style = {});
  void polygon(std::vector<Vector2d> corners, Color color = {}, double penWidth = 1,
               PenStyle style = {});
  void area(std::vector<Vector2d> corners, Color color = {});
  void cross(const Vector2d& at, double size, Color color = {}, double penWidth = 1);
  void text(const Vector2d& at, std::string text, Color color = {}, double height = 10);
  /// A robot's pose: an arrow of `length` that begins at its position.
  void pose(const Pose2D& pose, Color color = {}, double length = 100);

 private:
  DrawingElement& add(ElementType type, std::vector<Vector2d> points, Color color,
                      double penWidth = 1, PenStyle style = {});
  void send();

  Debug* debug_ = nullptr;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace gt
