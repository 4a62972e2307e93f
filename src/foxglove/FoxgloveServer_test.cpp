#include "foxglove/FoxgloveServer.h"

#include <gmock/gmock.h>

#include <cmath>

#include "images/Jpeg.h"
#include "logs/RobotLog.h"
#include "representations/modeling/BallModel.h"
#include "support/TestFoxglove.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

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

/// Works until something holds, for a minute at most.
template <typename Condition, typename Work>
bool workUntil(Condition holds, Work work) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{1};
  while (!holds() && std::chrono::steady_clock::now() < end) work();
  return holds();
}

void subscribeToAll(TestViewer& viewer) {
  std::uint32_t subscription = 0;
  for (const char* topic : {"/blue1/camera", "/blue1/RobotPose", "/blue1/drawings/eyes/seen",
                            "/blue1/camera/drawings/eyes/seen", "/blue1/plots/eyes/seen", "/truth",
                            "/tf", "/log", "/field"})
    viewer.subscribe(++subscription, topic);
}

TEST_F(FoxgloveServerTest, EncodesNothingForNobody) {
  for (int i = 0; i < 100; ++i) update();
  EXPECT_EQ(server->encoded(), 0u) << "there is no viewer";
  auto idle = connect();
  for (int i = 0; i < 100; ++i) update();
  EXPECT_EQ(server->encoded(), 0u) << "it has subscribed nothing";
}

/// What finds its place taken is dropped once, until the viewer takes something again.
TEST_F(FoxgloveServerTest, EncodesForASlowViewerWhatItTakes) {
  auto viewer = connect();
  subscribeToAll(viewer);
  for (int round = 1; round <= 3; ++round) {
    EXPECT_TRUE(runUntilFull()) << "it reads nothing";
    EXPECT_TRUE(workUntil([&] { return 2 * viewer.data.size() + 9 >= server->encoded(); },
                          [&] {
                            viewer.read();
                            server->update(subject);
                          }))
        << viewer.data.size() << " taken of " << server->encoded();
  }
}

/// A viewer that reads nothing costs next to nothing.
TEST_F(FoxgloveServerTest, MakesNothingThatNobodyTakes) {
  int truths = 0;
  subject.truth = [&truths] {
    ++truths;
    return FoxgloveTruth{};
  };
  auto viewer = connect();
  viewer.subscribe(1, "/blue1/camera");
  viewer.subscribe(2, "/truth");
  EXPECT_TRUE(runUntilFull());
  EXPECT_LT(truths, 100);
  viewer.data.clear();
  const std::uint64_t last = static_cast<std::uint64_t>(subject.now.ms) * 1'000'000;
  const auto readWhileTimeStands = [&] {
    viewer.read();
    server->update(subject);
  };
  for (const std::uint32_t subscription : {1u, 2u})
    EXPECT_TRUE(workUntil(
        [&] {
          return std::ranges::any_of(viewer.data, [&](const auto& data) {
            return data.subscription == subscription && data.time == last;
          });
        },
        readWhileTimeStands))
        << "it gets the newest as soon as it reads again";
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
