#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "debug/DebugKey.h"
#include "debug/Drawing.h"
#include "streams/MessageQueue.h"

namespace gt {

class Debug;

/// What a module draws on while its key is active; the drawing is sent when the canvas goes out of
/// scope. `if (auto canvas = debug.onField(key)) canvas.circle(...);`
class Canvas {
 public:
  Canvas() = default;
  Canvas(Debug& debug, const DebugKey& key, DrawingSpace space);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  explicit operator bool() const { return debug_ != nullptr; }

  void point(const Vector2d& at, Color color = {}, double radius = 1);
  void line(const Vector2d& from, const Vector2d& to, Color color = {}, double penWidth = 1);
  void arrow(const Vector2d& from, const Vector2d& to, Color color = {}, double penWidth = 1);
  void circle(const Vector2d& center, double radius, Color color = {}, double penWidth = 1);
  void disk(const Vector2d& center, double radius, Color color = {});
  void polygon(std::vector<Vector2d> corners, Color color = {}, double penWidth = 1);
  void text(const Vector2d& at, std::string text, Color color = {}, double height = 10);
  /// A robot's pose: an arrow of 100 mm from where it stands.
  void pose(const Pose2D& pose, Color color = {}, double length = 100);

 private:
  DrawingElement& add(ElementType type, std::vector<Vector2d> points, Color color, double penWidth);

  Debug* debug_ = nullptr;
  Drawing drawing_;
};

/// A process's way to whoever watches it (report, appendix E): keys, drawings, plots, text, any
/// representation. All of it leaves as messages; a key that nobody asked for costs one branch.
class Debug {
 public:
  explicit Debug(std::size_t queueCapacity = 1 << 20) : out_{queueCapacity} {}

  void begin(Time now) { now_ = now; }
  Time now() const { return now_; }

  Canvas onField(const DebugKey& key) { return draw(key, DrawingSpace::field); }
  Canvas onRobot(const DebugKey& key) { return draw(key, DrawingSpace::robot); }
  Canvas onImage(const DebugKey& key) { return draw(key, DrawingSpace::image); }

  void text(std::string text) { out_.write(now_, Text{std::move(text)}); }
  void plot(const DebugKey& key, double value) {
    if (keys_.isActive(key, now_)) out_.write(now_, Plot{std::string{key.name()}, value});
  }
  template <typename T>
  void send(const DebugKey& key, const T& representation) {
    if (keys_.isActive(key, now_)) out_.write(now_, representation);
  }

  DebugKeyTable& keys() { return keys_; }
  MessageQueue& out() { return out_; }

 private:
  Canvas draw(const DebugKey& key, DrawingSpace space) {
    return keys_.isActive(key, now_) ? Canvas{*this, key, space} : Canvas{};
  }

  DebugKeyTable keys_;
  MessageQueue out_;
  Time now_;
};

}  // namespace gt
