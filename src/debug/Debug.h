#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "debug/DebugKey.h"
#include "debug/Drawing.h"
#include "debug/Stopwatch.h"
#include "streams/MessageQueue.h"

namespace gt {

class Debug;

/// What a module draws on while its key is active; the drawing is sent when the canvas goes out of
/// scope. `if (auto canvas = debug.onField(key)) canvas.circle(...);` Positions and sizes are mm on
/// the field or around the robot, or pixels of the picture.
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
  /// An ellipse by its half axes; the first one points into the direction (rad).
  void ellipse(const Vector2d& center, double first, double second, double direction,
               Color color = {}, double penWidth = 1, PenStyle style = {});
  /// A filled part of a disk, counterclockwise from one direction to another (rad).
  void sector(const Vector2d& center, double radius, double from, double to, Color color = {});
  void path(std::vector<Vector2d> points, Color color = {}, double penWidth = 1,
            PenStyle style = {});
  void polygon(std::vector<Vector2d> corners, Color color = {}, double penWidth = 1,
               PenStyle style = {});
  void area(std::vector<Vector2d> corners, Color color = {});
  void cross(const Vector2d& at, double size, Color color = {}, double penWidth = 1);
  void text(const Vector2d& at, std::string text, Color color = {}, double height = 10);
  /// A robot's pose: an arrow of 100 mm from where it stands.
  void pose(const Pose2D& pose, Color color = {}, double length = 100);

 private:
  DrawingElement& add(ElementType type, std::vector<Vector2d> points, Color color,
                      double penWidth = 1, PenStyle style = {});
  void send();

  Debug* debug_ = nullptr;
  std::unique_ptr<Drawing> drawing_;
};

/// A process's way to whoever watches it (report, appendix E): keys, drawings, plots, text, any
/// representation. All of it leaves as messages; a key that nobody asked for costs one branch, and
/// nothing at all where `debugging` is off.
class Debug {
 public:
  explicit Debug(std::size_t queueCapacity = 1 << 20) : out_{queueCapacity} {}

  void begin(Time now) { now_ = now; }
  Time now() const { return now_; }

  Canvas onField(const DebugKey& key) { return draw(key, DrawingSpace::field); }
  Canvas onRobot(const DebugKey& key) { return draw(key, DrawingSpace::robot); }
  Canvas onImage(const DebugKey& key) { return draw(key, DrawingSpace::image); }

  /// Sends any representation: in any case, or if the key is active (report E.4, OUTPUT and INFO).
  template <typename T>
  void send(const T& representation) {
    if constexpr (debugging) out_.write(now_, representation);
  }
  template <typename T>
  void send(const DebugKey& key, const T& representation) {
    if (isActive(key)) send(representation);
  }
  /// Sends a text in any case.
  void text(std::string text) { send(Text{std::move(text)}); }
  void plot(const DebugKey& key, double value) {
    if (isActive(key)) send(Plot{std::string{key.name()}, value});
  }
  /// Does some work and sends how long it took: in any case, or if the key is active (report E.7).
  template <typename Work>
  void stopTime(std::string_view event, Work&& work) {
    Stopwatch watch{std::string{event}};
    {
      const Stopwatch::Lap lap{watch};
      std::forward<Work>(work)();
    }
    send(StopwatchTime{watch.name(), 1000 * watch.totalMs()});
  }
  template <typename Work>
  void stopTime(const DebugKey& key, Work&& work) {
    if (!isActive(key)) return std::forward<Work>(work)();
    stopTime(key.name(), std::forward<Work>(work));
  }

  /// The numbers that a tool has sent under a key since the last cycle (report E.2); null if it has
  /// not.
  const std::vector<double>* received(const DebugKey& key) const;
  /// Hands numbers in, for the modules of this cycle.
  void receive(GenericDebugData data) {
    if constexpr (debugging) received_.push_back(std::move(data));
  }
  void forgetReceived() { received_.clear(); }

  bool isActive(const DebugKey& key) { return debugging && keys_.isActive(key, now_); }
  DebugKeyTable& keys() { return keys_; }
  MessageQueue& out() { return out_; }

 private:
  Canvas draw(const DebugKey& key, DrawingSpace space) {
    return isActive(key) ? Canvas{*this, key, space} : Canvas{};
  }

  DebugKeyTable keys_;
  MessageQueue out_;
  Time now_;
  std::vector<GenericDebugData> received_;
};

}  // namespace gt
