#include "foxglove/FoxgloveServer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "observer/RobotLog.h"
#include "representations/infrastructure/Image.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Jpeg.h"
#include "support/TestViewer.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::TestViewer;

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
      Image image;
      image.time = now;
      image.info.width = 160;
      image.info.height = 120;
      image.allocate();
      for (Pixel& pixel : image.pixels)  // noise makes JPEG long
        pixel.y = static_cast<std::uint8_t>((noise_ = 1'664'525 * noise_ + 1'013'904'223) >> 24);
      out_.write(now, image);
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
  std::string gain = "0.5";

 private:
  void answer(const Message& message) {
    WatchRequest watch;
    DebugRequest key;
    ParameterRequest parameter;
    if (message.is<DescriptionRequest>()) {
      out_.write({}, description());
    } else if (message.is<WatchRequest>() && message.read(watch)) {
      ask(watch.representation, watch.mode);
      if (watch.representation == "Player")
        out_.write({}, Player{TeamColor::blue, PlayerRole::goalie});
    } else if (message.is<DebugRequest>() && message.read(key)) {
      ask(key.key, key.mode);
    } else if (message.is<ParameterRequest>() && message.read(parameter)) {
      if (parameter.value != "high") {
        gain = parameter.value;
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
    description.tasks = {{"Seeing", "Sharp", {}, {{"Sharp", {}, {{"gain", gain, "", "", 0, 1}}}}}};
    return description;
  }

  MessageQueue in_, out_;
  std::uint32_t noise_ = 1;
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

TEST_F(FoxgloveServerTest, IntroducesItselfByBothNamesOfTheProtocol) {
  for (const char* name : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
    auto viewer = TestViewer::connect(server->port(), name);
    ASSERT_TRUE(viewer) << name;
    EXPECT_EQ(viewer->subprotocol, name);
    const Json info = text(*viewer, "serverInfo");
    EXPECT_EQ(info["name"], "a test");
    EXPECT_THAT(info["capabilities"], Contains("time"));
  }
  EXPECT_FALSE(TestViewer::connect(server->port(), "chat"));
}

TEST_F(FoxgloveServerTest, AsksForWhatIsSubscribedOnly) {
  auto viewer = connect();
  EXPECT_EQ(viewer.channels["/blue1/BallModel"]["encoding"], "cdr");
  EXPECT_EQ(viewer.channels["/blue1/BallModel"]["schema"], schemaOf<BallModel>().text);
  EXPECT_THAT(link->asked, IsEmpty());
  for (int i = 0; i < 20; ++i) update();
  viewer.read();
  EXPECT_THAT(viewer.data, IsEmpty());
  viewer.subscribe(7, "/blue1/RobotPose");
  EXPECT_EQ(next<RobotPose>(viewer, 7).pose.translation, Vector2d(100, 200));
  EXPECT_THAT(link->asked, ElementsAre("RobotPose"));
  EXPECT_EQ(viewer.data.back().time % 8'000'000, 0u);
  {
    auto other = connect();
    other.subscribe(1, "/blue1/RobotPose");
    EXPECT_EQ(next<RobotPose>(other, 1).validity, 1);
    viewer.send(R"({"op":"unsubscribe","subscriptionIds":[7]})");
    next<RobotPose>(other, 1);
    EXPECT_THAT(link->asked, ElementsAre("RobotPose")) << "another viewer wants it";
  }
  EXPECT_TRUE(waitFor(viewer, [&] { return link->asked.empty(); })) << "nobody wants it any more";
}

TEST_F(FoxgloveServerTest, SendsImagesAsJpeg) {
  auto viewer = connect();
  viewer.subscribe(1, "/blue1/camera");
  const auto picture = next<CompressedImage>(viewer, 1);
  EXPECT_EQ(picture.header.frameId, "blue1/camera");
  const auto image = decodeJpeg(picture.data);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 160);
}

TEST_F(FoxgloveServerTest, SendsDrawingsWholeAndInTheirSpaces) {
  auto viewer = connect();
  viewer.subscribe(1, "/blue1/drawings/eyes/seen");
  const auto scene = next<foxglove::SceneUpdate>(viewer, 1);
  ASSERT_EQ(scene.entities.size(), 1u);
  EXPECT_EQ(scene.entities[0].frameId, "field/blue");
  EXPECT_EQ(scene.entities[0].id, "eyes/seen");
  ASSERT_EQ(scene.entities[0].triangles.size(), 1u);
  const auto& points = scene.entities[0].triangles[0].points;
  const auto [left, right] = std::ranges::minmax(points, {}, &foxglove::Point3::x);
  EXPECT_NEAR(left.x, 0.99, 1e-9) << "of the first module's disk";
  EXPECT_NEAR(right.x, 2.01, 1e-9) << "of the second one's";
  EXPECT_THAT(robot.drawings(), IsEmpty()) << "views do not show what viewers asked for";
  viewer.subscribe(2, "/blue1/camera/drawings/eyes/seen");
  const auto annotations = next<foxglove::ImageAnnotations>(viewer, 2);
  ASSERT_EQ(annotations.circles.size(), 1u);
  EXPECT_EQ(annotations.circles[0].diameter, 20);
  viewer.subscribe(3, "/blue1/plots/eyes/seen");
  EXPECT_EQ(next<Plot>(viewer, 3).value, 0.25);
}

TEST_F(FoxgloveServerTest, SendsFramesTruthLogAndTime) {
  subject.truth = [] {
    FoxgloveTruth truth{.robots = {{"blue1", TeamColor::blue, {}}}, .balls = {{"ball0"}}};
    truth.ballRadius = 43;
    return truth;
  };
  auto viewer = connect();
  viewer.subscribe(1, "/tf");
  std::map<std::string, foxglove::FrameTransform> frames;
  while (!frames.contains("blue1") && !HasFailure())
    for (const auto& frame : next<foxglove::FrameTransforms>(viewer, 1).transforms)
      frames[frame.childFrameId] = frame;
  EXPECT_EQ(frames["blue1"].parentFrameId, "field/blue");
  EXPECT_NEAR(frames["blue1"].translation.y, 0.2, 1e-9);
  EXPECT_NEAR(frames["blue1"].rotation.z, std::sin(0.25), 1e-9);
  EXPECT_NEAR(frames["field/blue"].rotation.z, 1, 1e-9);
  EXPECT_TRUE(frames.contains("blue1/truth"));
  viewer.subscribe(2, "/truth");
  const auto truth = next<foxglove::SceneUpdate>(viewer, 2);
  ASSERT_EQ(truth.entities.size(), 2u);
  EXPECT_NEAR(truth.entities[1].spheres.at(0).size.x, 0.086, 1e-9);
  viewer.subscribe(3, "/field");
  EXPECT_EQ(next<foxglove::SceneUpdate>(viewer, 3).entities.at(0).cylinders.size(), 12u);
  viewer.subscribe(4, "/log");
  const auto log = next<foxglove::Log>(viewer, 4);
  EXPECT_EQ(log.message, "careful");
  EXPECT_EQ(log.level, foxglove::Log::warning);
  EXPECT_EQ(log.name, "blue1");
  EXPECT_TRUE(waitFor(viewer, [&] { return viewer.time > 8'000'000; }));
}

TEST_F(FoxgloveServerTest, GetsSetsAndFollowsParameters) {
  auto viewer = connect(), other = connect();
  other.send(R"({"op":"subscribeParameterUpdates","parameterNames":[]})");
  viewer.send(R"({"op":"getParameters","parameterNames":[],"id":"all"})");
  const Json all = text(viewer, "parameterValues");
  EXPECT_EQ(all["id"], "all");
  EXPECT_EQ(all["parameters"].dump(), R"([{"name":"blue1.Seeing.Sharp.gain","value":0.5}])");
  viewer.texts.clear();
  viewer.send(
      R"({"op":"setParameters","parameters":[{"name":"blue1.Seeing.Sharp.gain","value":0.75}],"id":"set"})");
  EXPECT_EQ(text(viewer, "parameterValues")["parameters"][0]["value"], 0.75);
  EXPECT_EQ(link->gain, "0.75");
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(text(other, "parameterValues")["parameters"][0]["value"], 0.75);
  other.texts.clear();
  link->gain = "1";  // by another tool
  EXPECT_EQ(text(other, "parameterValues")["parameters"][0]["value"], 1);
  for (const char* wrong :
       {R"({"name":"blue1.Seeing.Sharp.gain","value":"high"})",
        R"({"name":"blue1.Seeing.Sharp.gain","value":[1]})",
        R"({"name":"blue1.Hearing.gain","value":1})", R"({"name":"blue1","value":1})",
        R"({"name":"","value":1})", R"({"name":"red9.Seeing.Sharp.gain","value":1})"}) {
    viewer.texts.clear();
    viewer.send(std::string{R"({"op":"setParameters","parameters":[)"} + wrong + "]}");
    EXPECT_EQ(text(viewer, "status")["level"], 2) << wrong;
  }
  EXPECT_EQ(changes, 1);
}

TEST_F(FoxgloveServerTest, SetsParametersOfRobotsThatAreNamedByTheirAddress) {
  auto* elsewhere = new SendingRobot;
  ObservedRobot other{"127.0.0.11", std::unique_ptr<RobotLink>{elsewhere}};
  subject.robots.push_back(&other);
  auto viewer = connect();
  EXPECT_TRUE(waitFor(viewer, [&] {
    other.update();
    return viewer.channels.contains("/127.0.0.11/RobotPose");
  }));
  viewer.send(
      R"({"op":"setParameters","parameters":[{"name":"127.0.0.11.Seeing.Sharp.gain","value":0.25}],"id":"set"})");
  EXPECT_TRUE(waitFor(viewer, [&] {
    other.update();
    return elsewhere->gain == "0.25";
  }));
  EXPECT_EQ(link->gain, "0.5");
  server->forget();
}

TEST_F(FoxgloveServerTest, RefusesWhatIsNoRequest) {
  auto viewer = connect();
  for (const char* wrong :
       {"{", "[]", R"({"op":1})", R"({"op":"advertise","channels":[]})", R"({"op":"subscribe"})",
        R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":99999}]})",
        R"({"op":"unsubscribe","subscriptionIds":["x"]})",
        R"({"op":"setParameters","parameters":[{"name":"blue1","value":1}]})"}) {
    viewer.texts.clear();
    viewer.send(wrong);
    EXPECT_GT(text(viewer, "status")["message"].get<std::string>().size(), 0u) << wrong;
  }
  EXPECT_TRUE(viewer.isOpen);
}

/// What this program has of the memory, in MB.
double residentMemory() {
  std::ifstream file{"/proc/self/statm"};
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

TEST_F(FoxgloveServerTest, SurvivesNestedValues) {
  auto viewer = connect();
  constexpr std::size_t levels = 170'000;
  std::string value;
  for (std::size_t i = 0; i < levels; ++i)
    value += R"(["]",)";  // a bracket in a string closes none
  value += '1' + std::string(levels, ']');
  viewer.send(R"({"op":"setParameters","id":"a","parameters":[{"name":"blue1.Seeing.x","value":)" +
              value + "}]}");
  EXPECT_THAT(text(viewer, "status")["message"].get<std::string>(), HasSubstr("nested too deeply"));
}

/// Each subscription gets every message.
TEST_F(FoxgloveServerTest, LimitsTheSubscriptionsOfAViewer) {
  auto viewer = connect();
  const auto channel = viewer.channels["/blue1/RobotPose"]["id"].get<std::uint32_t>();
  Json wanted = Json::array();
  for (std::uint32_t id = 0; id < 15'000; ++id)
    wanted.push_back({{"id", id}, {"channelId", channel}});
  viewer.send(Json{{"op", "subscribe"}, {"subscriptions", wanted}}.dump());
  const std::string answer = text(viewer, "status")["message"];
  EXPECT_THAT(answer, HasSubstr("4 subscriptions of channel"));
  EXPECT_THAT(answer, HasSubstr("14995 more faults"));
  EXPECT_THAT(viewer.texts, Not(Contains(::testing::Truly([&](const Json& other) {
                return other["op"] == "status" && other["message"] != answer;
              }))));
  next<RobotPose>(viewer, 3);
  std::set<std::uint32_t> served;
  std::uint64_t time = viewer.data.back().time;
  EXPECT_TRUE(waitFor(viewer, [&] { return viewer.data.back().time > time + 80'000'000; }));
  for (const auto& data : viewer.data) served.insert(data.subscription);
  EXPECT_THAT(served, ElementsAre(0, 1, 2, 3));
  viewer.send(R"({"op":"unsubscribe","subscriptionIds":[0]})");
  viewer.subscribe(20'000, "/blue1/RobotPose");
  next<RobotPose>(viewer, 20'000);
}

TEST_F(FoxgloveServerTest, KeepsOnlyNamesOfParametersThatThereAre) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer keeps what is freed";
#endif
  auto viewer = connect();
  const auto ask = [&](int from) {
    Json names = Json::array();
    for (int i = 0; i < 8'000; ++i)
      names.push_back("blue1.Seeing.Sharp.nothing.of.this.name.is.there." +
                      std::to_string(from * 8'000 + i));
    viewer.send(Json{{"op", "subscribeParameterUpdates"}, {"parameterNames", names}}.dump());
    viewer.texts.clear();
    viewer.send(R"({"op":"getParameters","parameterNames":["blue1.Seeing.Sharp.gain"],"id":"x"})");
    EXPECT_EQ(text(viewer, "parameterValues")["parameters"].size(), 1u);  // it has come that far
  };
  for (int i = 0; i < 10; ++i) ask(i);
  const double before = residentMemory();
  for (int i = 10; i < 110; ++i) ask(i);
  EXPECT_LT(residentMemory() - before, 25) << "MB";
}

TEST_F(FoxgloveServerTest, RefusesListsThatAreTooLong) {
  auto viewer = connect();
  Json names = Json::array();
  for (int i = 0; i <= 20'000; ++i) names.push_back("a");
  viewer.send(Json{{"op", "getParameters"}, {"parameterNames", names}}.dump());
  EXPECT_EQ(text(viewer, "status")["message"],
            "client: parameterNames: has more than 20000 elements");
}

// Robots are destroyed when a session begins anew.
TEST_F(FoxgloveServerTest, ForgetsRobotsAndFindsThemAgain) {
  auto viewer = connect();
  viewer.subscribe(1, "/blue1/RobotPose");
  next<RobotPose>(viewer, 1);
  const auto before = viewer.channels["/blue1/RobotPose"]["id"];
  server->forget();
  EXPECT_THAT(link->asked, IsEmpty());
  EXPECT_TRUE(waitFor(viewer, [&] {
    return viewer.channels.contains("/blue1/RobotPose") &&
           viewer.channels["/blue1/RobotPose"]["id"] != before;
  }));
  viewer.subscribe(1, "/blue1/RobotPose");
  next<RobotPose>(viewer, 1);
}

TEST_F(FoxgloveServerTest, SlowViewersLoseImagesAndHoldNobodyUp) {
  auto slow = connect(), quick = connect();
  slow.subscribe(1, "/blue1/camera");
  slow.subscribe(2, "/blue1/RobotPose");
  quick.subscribe(1, "/blue1/camera");
  next<CompressedImage>(quick, 1);
  const std::uint64_t before = server->dropped();
  for (int i = 0; i < 1000 && server->dropped() < before + 100; ++i)
    EXPECT_GT(next<CompressedImage>(quick, 1).data.size(), 0u) << "the quick one gets its images";
  EXPECT_GE(server->dropped(), before + 100);
  slow.read();
  EXPECT_TRUE(slow.isOpen);
  slow.data.clear();
  update();
  const std::uint64_t now = static_cast<std::uint64_t>(subject.now.ms) * 1'000'000;
  EXPECT_TRUE(waitFor(slow, [&] {
    return std::ranges::any_of(slow.data, [&](const auto& data) { return data.time >= now; });
  })) << "it gets the newest as soon as it reads again";
}

/// A browser lets any page that its user visits connect to this machine.
TEST(FoxgloveServer, TurnsPagesAwayThatAreFromElsewhere) {
  std::unique_ptr<FoxgloveServer> server;
  const auto answerTo = [&](const std::string& origin) {
    return TestViewer::answerTo(server->port(), origin);
  };
  const std::vector<std::string> named{"https://app.foxglove.dev", "file://"};
  for (const bool withNames : {false, true}) {
    FoxgloveAccess access{"127.0.0.1:0"};
    if (withNames) access.origins = named;
    server = *FoxgloveServer::open(access, "");
    for (const char* own : {"", "http://localhost", "http://localhost:8080",
                            "https://localhost:8080", "http://127.0.0.1:8080", "http://[::1]:80"})
      EXPECT_EQ(answerTo(own), 101u) << own;
    for (const std::string& name : named)
      EXPECT_EQ(answerTo(name), withNames ? 101u : 403u) << name;
    for (const char* other :
         {"https://elsewhere.example", "http://localhost.elsewhere.example", "null",
          "https://app.foxglove.dev.elsewhere.example", "http://elsewhere.example:8765",
          "http://localhost:80.elsewhere.example", "file://elsewhere",
          "https://app.foxglove.dev:8"})
      EXPECT_EQ(answerTo(other), 403u) << other;
  }
}

TEST(FoxgloveServer, TakesOnlyOriginsThatABrowserNames) {
  for (const char* wrong : {"", "app.foxglove.dev", "https://app.foxglove.dev/", "://a", "https://",
                            "null", "*", "https://a b"}) {
    const auto opened = FoxgloveServer::open({"0", {wrong}}, "");
    ASSERT_FALSE(opened) << wrong;
    EXPECT_THAT(opened.error().what, HasSubstr("expected an origin")) << wrong;
  }
}

TEST(FoxgloveEndpoint, IsAPortOrAnAddressAndAPort) {
  for (const char* wrong : {"", "here", "70000", "here:8765", ":8765", "127.0.0.1:", "-1"})
    EXPECT_FALSE(FoxgloveServer::open({wrong}, "")) << wrong;
  const auto server = FoxgloveServer::open({"127.0.0.1:0"}, "");
  ASSERT_TRUE(server);
  EXPECT_THAT(FoxgloveServer::open({std::to_string((*server)->port())}, "").error().what,
              HasSubstr("in use"));
}

}  // namespace
}  // namespace gt
