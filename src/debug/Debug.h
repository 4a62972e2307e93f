#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "debug/Canvas.h"
#include "debug/DebugKey.h"
#include "debug/Drawing.h"
#include "debug/Stopwatch.h"
#include "streams/MessageQueue.h"

namespace gt {

/// The debug output of a process (report, appendix E): keys, drawings, plots, text, any
/// representation. All output is sent as messages. A key that is switched off costs one branch, and
/// nothing if `debugging` is off.
class Debug {
 public:
  explicit Debug(std::size_t queueCapacity = 1 << 20) : out_{queueCapacity} {}

  /// Begins a frame. All output until the next call belongs to this frame.
  void begin(Time now) {
    now_ = now;
    keys_.begin(now);
  }
  Time now() const { return now_; }

  Canvas onField(const DebugKey& key) { return draw(key, DrawingSpace::field); }
  Canvas onRobot(const DebugKey& key) { return draw(key, DrawingSpace::robot); }
  Canvas onImage(const DebugKey& key) { return draw(key, DrawingSpace::image); }

  /// Sends any representation: always, or only if the key is active (report E.4, OUTPUT and INFO).
  template <typename T>
  void send(const T& representation) {
    if constexpr (debugging) out_.write(now_, representation);
  }
  template <typename T>
  void send(const DebugKey& key, const T& representation) {
    if (isActive(key)) send(representation);
  }
  /// Sends a text, independent of any key.
  void text(std::string text) { send(Text{std::move(text)}); }
  /// Sends a warning about something that should not happen; it makes a strict run fail.
  void warn(std::string text) { send(Text{std::move(text), Severity::warning}); }
  void plot(const DebugKey& key, double value) {
    if (isActive(key)) send(Plot{std::string{key.name()}, value});
  }
  /// Executes `work` and sends its duration: always, or only if the key is active (report E.7).
  template <typename Work>
  void stopTime(std::string_view event, Work&& work) {
    Stopwatch watch{std::string{event}};
    {
      const Stopwatch::Lap lap{watch};
      std::forward<Work>(work)();
    }
    send(StopwatchTime{watch.name, 1000 * watch.totalMs});
  }
  template <typename Work>
  void stopTime(const DebugKey& key, Work&& work) {
    if (!isActive(key)) return std::forward<Work>(work)();
    stopTime(key.name(), std::forward<Work>(work));
  }

  bool isActive(const DebugKey& key) { return debugging && keys_.isActive(key); }
  DebugKeyTable& keys() { return keys_; }
  MessageQueue& out() { return out_; }

 private:
  Canvas draw(const DebugKey& key, DrawingSpace space) {
    return isActive(key) ? Canvas{*this, key, space} : Canvas{};
  }

  DebugKeyTable keys_;
  MessageQueue out_;
  Time now_;
};

}  // namespace gt
