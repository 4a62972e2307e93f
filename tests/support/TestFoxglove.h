#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "foxglove/FoxgloveServer.h"
#include "representations/infrastructure/Image.h"
#include "representations/modeling/RobotPose.h"
#include "support/TestViewer.h"

namespace gt {

using testing::TestViewer;

/// Noise makes JPEG long.
inline Image noisyImage() {
  Image image;
  image.info.width = 160;
  image.info.height = 120;
  image.allocate();
  std::uint32_t noise = 1;
  for (Pixel& pixel : image.pixels)
    pixel.y = static_cast<std::uint8_t>((noise = 1'664'525 * noise + 1'013'904'223) >> 24);
  return image;
}

/// A robot with one process, which sends what it is asked for in each of its cycles.
class SendingRobot : public RobotLink {
 public:
  MessageQueue& toRobot() override { return in_; }
  void exchange(const Taker& take) override {
    in_.handleAllMessages([this](const Message& message) { answer(message); });
    in_.clear();
    take(out_);
    out_.clear();
  }

  void cycle(Time now) {
    if (asked.contains("RobotPose")) out_.write(now, RobotPose{{0.5, {100, 200}}, 1});
    if (asked.contains("Image")) {
      image_.time = now;
      out_.write(now, image_);
    }
    if (asked.contains("eyes/seen")) {
      const auto disk = [](double x) {
        return DrawingElement{ElementType::disk, {{x, 0}}, 10, colors::orange, 1, ""};
      };
      out_.write(now, Drawing{"eyes/seen", DrawingSpace::field, {disk(1000)}});
      out_.write(now, Drawing{"eyes/seen", DrawingSpace::field, {disk(2000)}});
      out_.write(now, Drawing{"eyes/seen", DrawingSpace::image, {disk(5)}});
      out_.write(now, Plot{"eyes/seen", 0.25});
    }
    out_.write(now, Text{"careful", Severity::warning});
  }

  std::set<std::string> asked;
  std::string gain = "0.5", title = "\"a b\"", weights = "1 2";
  std::chrono::milliseconds toDescribe{};  ///< How long that takes.

 private:
  void answer(const Message& message) {
    WatchRequest watch;
    DebugRequest key;
    ParameterRequest parameter;
    if (message.is<DescriptionRequest>()) {
      std::this_thread::sleep_for(toDescribe);
      out_.write({}, description());
    } else if (message.is<WatchRequest>() && message.read(watch)) {
      ask(watch.representation, watch.mode);
      if (watch.representation == "Player")
        out_.write({}, Player{TeamColor::blue, PlayerRole::goalie});
    } else if (message.is<DebugRequest>() && message.read(key)) {
      ask(key.key, key.mode);
    } else if (message.is<ParameterRequest>() && message.read(parameter)) {
      if (parameter.value != "high") {
        (parameter.path == "title"     ? title
         : parameter.path == "weights" ? weights
                                       : gain) = parameter.value;
      } else {
        out_.write({}, answerTo(message, "Eyes", Error{.what = "expected a number"}));
        return;
      }
    }
    out_.write({}, answerTo(message, "Eyes", {}));
  }
  void ask(const std::string& name, DebugKeyMode mode) {
    if (mode == DebugKeyMode::always)
      asked.insert(name);
    else
      asked.erase(name);
  }
  ProcessDescription description() const {
    ProcessDescription description;
    description.process = "Eyes";
    for (const char* name : {"BallModel", "Image", "Player", "RobotPose"})
      description.representations.push_back({name, RepresentationOrigin::provided, true, 0});
    description.debugKeys = {"eyes/seen"};
    description.tasks = {{"Seeing",
                          "Sharp",
                          {},
                          {{"Sharp",
                            {},
                            {{"gain", gain, "", "", 0, 1},
                             {"title", title, "", "", 0, 0},
                             {"weights", weights, "", "", 0, 0}}}}}};
    return description;
  }

  MessageQueue in_, out_;
  Image image_ = noisyImage();
};

class FoxgloveServerTest : public ::testing::Test {
 protected:
  FoxgloveServerTest() {
    auto opened = FoxgloveServer::open({"0"}, "a test");
    EXPECT_TRUE(opened) << opened.error().text();
    server = std::move(*opened);
    subject.robots = {&robot};
    subject.parameterChanged = [this] { ++changes; };
  }

  TestViewer connect() {
    auto viewer = TestViewer::connect(server->port());
    EXPECT_TRUE(viewer);
    EXPECT_TRUE(waitFor(*viewer, [&] { return viewer->channels.contains("/blue1/RobotPose"); }));
    return std::move(*viewer);
  }
  void update() {
    subject.now.ms += 8;
    link->cycle(subject.now);
    robot.update();
    server->update(subject);
  }
  /// Lets the robot run until viewers take nothing any more: many messages were dropped since the
  /// last one was encoded, during many of the server's intervals. Returns whether that happens
  /// within a minute.
  bool runUntilFull() {
    using Clock = std::chrono::steady_clock;
    constexpr std::uint64_t many = 100;
    constexpr std::chrono::milliseconds manyIntervals{300};
    const auto end = Clock::now() + std::chrono::minutes{1};
    auto encodedAt = Clock::now();
    std::uint64_t encoded = 0, dropped = server->dropped();
    while (server->dropped() < dropped + many || Clock::now() < encodedAt + manyIntervals) {
      if (Clock::now() > end) return false;
      update();
      if (std::exchange(encoded, server->encoded()) == encoded) continue;
      encodedAt = Clock::now();
      dropped = server->dropped();
    }
    return true;
  }
  /// Lets the robot run until something holds.
  template <typename Condition>
  bool waitFor(TestViewer& viewer, Condition holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{1};
    while (!holds()) {
      if (std::chrono::steady_clock::now() > end) return false;
      update();
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
      viewer.read();
    }
    return true;
  }
  /// Runs until a message of a subscription comes, and decodes it.
  template <typename T>
  T next(TestViewer& viewer, std::uint32_t subscription) {
    T value;
    viewer.data.clear();
    const auto sought = [&] {
      return std::ranges::find(viewer.data, subscription, &TestViewer::Data::subscription);
    };
    EXPECT_TRUE(waitFor(viewer, [&] { return sought() != viewer.data.end(); }));
    if (sought() == viewer.data.end()) return value;
    EXPECT_TRUE(decode(std::as_bytes(std::span{sought()->bytes}), value));
    return value;
  }
  /// The first text of an operation.
  Json text(TestViewer& viewer, const std::string& op) {
    const auto sought = [&] {
      return std::ranges::find_if(viewer.texts, [&](const Json& json) { return json["op"] == op; });
    };
    EXPECT_TRUE(waitFor(viewer, [&] { return sought() != viewer.texts.end(); })) << op;
    return sought() == viewer.texts.end() ? Json{} : *sought();
  }

  SendingRobot* link = new SendingRobot;
  ObservedRobot robot{"blue1", std::unique_ptr<RobotLink>{link}};
  std::unique_ptr<FoxgloveServer> server;
  FoxgloveSubject subject;
  int changes = 0;
};

}  // namespace gt
