#include "modules/motion/specialactions/GT2003MotionNetSpecialActions.h"

#include <gtest/gtest.h>

#include <tuple>

#include "modules/motion/specialactions/MotionNetLoader.h"

namespace gt {
namespace {

/// A data line that moves the head's tilt only.
std::string data(int tilt, int interpolate, int frames) {
  std::string line = std::to_string(tilt);
  for (int i = 1; i < MotionNet::jointCount; ++i) line += " ~";
  return line + " " + std::to_string(interpolate) + " " + std::to_string(frames) + "\n";
}

/// Special actions on a small net, with what they read.
struct Actions {
  GT2003MotionNetSpecialActions module;
  MotionNet net;
  MotionRequest request;
  MotionInfo info;
  JointData joints;
  SpecialActionsOutput output;
  Debug debug;

  Actions() { compile({}, {}); }
  /// With another description of a motion.
  void replace(const std::string& motion, const std::string& body) { compile(motion, body); }
  void compile(const std::string& other, const std::string& itsBody) {
    const std::string begin = "\nlabel start\n", end = "transition allMotions extern start\n";
    std::vector<motionnet::Source> sources;
    for (const std::string id : {"stand", "getupFromBelly", "getupFromSide", "getupFromBack",
                                 "getupFromNose", "someKick"}) {
      std::string body = data(100, 1, 2) + end;
      if (id == "stand")
        body = data(-500, 1, 5) + "label hold\n" + data(-400, 0, 1) +
               "transition stand stand hold\n" + end;
      if (id == "someKick")
        body = "pid headTilt 1 2 3\nodometry 500 0 0\n" + data(200, 1, 10) + "odometry 0 0 1000\n" +
               data(0, 0, 3) + "transition allMotions stand start\n";
      if (id == other) body = itsBody;
      sources.push_back({id + ".mof", "motion_id = " + id + begin + body});
    }
    const auto compilation = motionnet::compile(sources, motionRules());
    EXPECT_TRUE(compilation) << compilation.errors.front().text();
    net = *motionNetOf(compilation.net, "test");
  }
  void perform(std::string_view action) {
    request.type = MotionType::specialAction;
    request.specialAction = action;
    info.executed.type = MotionType::specialAction;
  }
  void step() {
    const auto before = joints;
    module.update({}, request, net, {info}, {before}, output, debug);
    joints = output.joints;
  }
  double tilt() const { return output.joints.angles[Joint::headTilt]; }
};

TEST(GT2003MotionNetSpecialActions, InterpolatesAndRepeats) {
  Actions actions;
  actions.joints.angles[Joint::headTilt] = 0.1;
  actions.perform("someKick");
  for (int i = 1; i <= 10; ++i) {
    actions.step();
    EXPECT_NEAR(actions.tilt(), 0.1 + 0.01 * i, 1e-9);
    EXPECT_FALSE(actions.output.mayLeave);
    EXPECT_EQ(actions.output.action, "someKick");
    EXPECT_NEAR(actions.output.odometryStep.translation.x(), 4, 1e-9);
    EXPECT_TRUE(actions.output.dontCare[Joint::headPan]);
    EXPECT_FALSE(actions.output.dontCare[Joint::headTilt]);
  }
  for (int i = 0; i < 3; ++i) {
    actions.step();
    EXPECT_EQ(actions.tilt(), 0);
    EXPECT_NEAR(actions.output.odometryStep.rotation, 0.008, 1e-9);
    EXPECT_EQ(actions.output.odometryStep.translation.x(), 0);
  }
}

TEST(GT2003MotionNetSpecialActions, GoesOnByTheTransitionsToWhereItMayBeLeft) {
  Actions actions;
  actions.perform("someKick");
  actions.step();
  actions.request.type = MotionType::walk;  // too late: the kick is ended first, then stand
  for (int i = 1; i < 13; ++i) actions.step();
  EXPECT_EQ(actions.output.action, "someKick");
  for (int i = 0; i < 6; ++i) {
    actions.step();
    EXPECT_EQ(actions.output.action, "stand");
    EXPECT_FALSE(actions.output.mayLeave);
    EXPECT_EQ(actions.output.odometryStep.rotation, 0);  // a speed ends with its motion
  }
  EXPECT_NEAR(actions.tilt(), -0.4, 1e-9);
  actions.step();
  EXPECT_TRUE(actions.output.mayLeave);
  EXPECT_EQ(actions.output.action, "");
}

TEST(GT2003MotionNetSpecialActions, SetsGainsUntilTheMotionEnds) {
  Actions actions;
  const auto tilt = [&] { return actions.output.gains.gains[Joint::headTilt]; };
  actions.step();
  EXPECT_EQ(tilt(), defaultGains(Joint::headTilt));
  actions.perform("someKick");
  for (int i = 0; i < 13; ++i) {
    actions.step();
    EXPECT_EQ(tilt(), (PidGains{1, 2, 3}));
    EXPECT_EQ(actions.output.gains.gains[Joint::headPan], defaultGains(Joint::headPan));
  }
  actions.step();
  EXPECT_EQ(actions.output.action, "stand");
  EXPECT_EQ(tilt(), defaultGains(Joint::headTilt));
}

TEST(GT2003MotionNetSpecialActions, AnotherMoverEndsTheGainsOfAMotion) {
  Actions actions;
  actions.perform("someKick");
  actions.step();
  ASSERT_EQ(actions.output.gains.gains[Joint::headTilt], (PidGains{1, 2, 3}));
  actions.info.executed.type = MotionType::walk;
  actions.step();
  EXPECT_EQ(actions.output.gains.gains[Joint::headTilt], defaultGains(Joint::headTilt));
}

TEST(GT2003MotionNetSpecialActions, ADisplacementIsMadeByTheNextDataAlongAnArc) {
  for (const auto& [x, y, rotation] :
       {std::tuple{-80, 30, 3142}, std::tuple{120, 0, 0}, std::tuple{0, 50, -1571}}) {
    Actions actions;
    actions.replace("someKick", "displacement " + std::to_string(x) + " " + std::to_string(y) +
                                    " " + std::to_string(rotation) + "\n" + data(200, 1, 40) +
                                    data(0, 0, 3) + "transition allMotions stand start\n");
    actions.perform("someKick");
    Pose2D pose, firstStep;
    for (int i = 0; i < 40; ++i) {
      actions.step();
      if (i == 0) firstStep = actions.output.odometryStep;
      EXPECT_NEAR(actions.output.odometryStep.translation.norm(), firstStep.translation.norm(),
                  1e-9);
      pose = pose * actions.output.odometryStep;
    }
    EXPECT_NEAR((pose.translation - Vector2d(x, y)).norm(), 0, 1e-6);
    EXPECT_NEAR(normalize(pose.rotation - rotation / 1000.), 0, 1e-9);
    actions.step();
    EXPECT_EQ(actions.output.odometryStep.rotation, 0);
    EXPECT_EQ(actions.output.odometryStep.translation, Vector2d::Zero());
  }
}

TEST(GT2003MotionNetSpecialActions, StaysWhileItIsRequested) {
  Actions actions;
  actions.perform("stand");
  for (int i = 0; i < 50; ++i) {
    actions.step();
    EXPECT_FALSE(actions.output.mayLeave);
  }
  actions.perform("someKick");
  actions.step();
  EXPECT_EQ(actions.output.action, "someKick");
}

TEST(GT2003MotionNetSpecialActions, DoesNothingWhileAnotherModuleMoves) {
  Actions actions;
  actions.perform("someKick");
  actions.step();
  actions.info.executed.type = MotionType::walk;
  actions.step();
  EXPECT_TRUE(actions.output.mayLeave);
  EXPECT_EQ(actions.output.action, "");
}

TEST(GT2003MotionNetSpecialActions, ReportsAnUnknownMotionOnce) {
  Actions actions;
  actions.perform("moonwalk");
  for (int i = 0; i < 10; ++i) actions.step();
  EXPECT_TRUE(actions.output.mayLeave);
  int reports = 0;
  actions.debug.out().handleAllMessages([&](const Message&) { ++reports; });
  EXPECT_EQ(reports, 1);
  actions.perform("someKick");
  actions.step();
  EXPECT_EQ(actions.output.action, "someKick");
}

TEST(GT2003MotionNetSpecialActions, AWrongNetDoesNotHangTheRobot) {
  Actions actions;
  actions.perform("someKick");
  actions.net.nodes.assign(3, {});
  for (auto& node : actions.net.nodes) {
    node.kind = MotionNodeKind::transition;
    node.always = true;
    node.target = 1;
  }
  actions.net.entry = 0;
  actions.step();
  EXPECT_TRUE(actions.output.mayLeave);
  actions.net.nodes[1].target = 4711;
  actions.step();
  actions.net.nodes.clear();
  actions.step();
  EXPECT_TRUE(actions.output.mayLeave);
}

TEST(MotionNetLoader, TheMotionsInTheRepositoryAreRight) {
  const auto net = loadMotionNet("motions");
  ASSERT_TRUE(net) << net.error().text();
  EXPECT_GT(net->nodes.size(), 50u);
}

TEST(MotionNetLoader, ReadsLinesOfJointDataToTry) {
  const auto part = jointDataOf(data(100, 1, 5) + "posture stand 0 7\n", "typed", "motions");
  ASSERT_TRUE(part) << part.error().text();
  ASSERT_EQ(part->lines.size(), 2u);
  EXPECT_NEAR(part->lines[0].angles[0], 0.1, 1e-9);
  EXPECT_TRUE(part->lines[0].dontCare[1]);
  EXPECT_TRUE(part->lines[0].interpolate);
  EXPECT_EQ(part->lines[1].frames, 7);
  EXPECT_NEAR(part->lines[1].angles[8], 1.142, 1e-9) << "the posture of stand.mof";
  std::string angles = "5";
  for (int i = 1; i < MotionNet::jointCount; ++i) angles += " ~";
  angles += "\n";
  const auto whole = jointDataOf("motion_id = a\nlabel start\nposture b = " + angles +
                                     "posture b 1 2\ntransition allMotions extern start\n",
                                 "a.mof", "motions");
  EXPECT_TRUE(whole) << whole.error().text();
  const auto wrong = jointDataOf(data(1, 1, 1) + data(9999, 1, 5), "typed", "motions");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().line, 2);
  EXPECT_EQ(jointDataOf("posture moonwalk 1 2", "typed", "motions").error().line, 1);
  EXPECT_FALSE(jointDataOf("// nothing", "typed", "motions"));
  EXPECT_FALSE(jointDataOf(data(1, 1, 1), "typed", "no/such/folder"));
}

TEST(MotionNetLoader, TakesLimitsToTheNearestMilliradian) {
  // -11 degrees of the elevators are -191.99 milliradians, 147 degrees of the knees 2565.6.
  const auto atLimits = [](int elevator, int knee) {
    const std::string leg = std::to_string(elevator) + " " + std::to_string(knee);
    return jointDataOf("0 0 0 ~ ~ ~ 0 " + leg + " 0 " + leg + " 0 0 0 0 0 0 1 25\n", "typed",
                       "motions");
  };
  const auto there = atLimits(-192, 2566);
  EXPECT_TRUE(there) << there.error().text();
  EXPECT_FALSE(atLimits(-193, 2566));
  EXPECT_FALSE(atLimits(-192, 2567));
}

TEST(MotionNetLoader, NamesMotionsAndTakesKicksFromTheTable) {
  const auto compile = [](const std::vector<std::string>& names) {
    std::vector<motionnet::Source> sources;
    for (const auto& name : names)
      sources.push_back({name + ".mof", "motion_id = " + name + "\nlabel start\n" + data(0, 1, 1) +
                                            "transition allMotions extern start\n"});
    return motionnet::compile(sources, motionRules());
  };
  auto net = motionNetOf(compile({"getupFromBack", "getupFromBelly", "getupFromNose",
                                  "getupFromSide", "myKick", "stand"})
                             .net,
                         "motions");
  ASSERT_TRUE(net) << net.error().text();
  EXPECT_EQ(net->find(""), 0);
  EXPECT_EQ(net->find("moonwalk"), -1);
  ASSERT_EQ(net->find("myKick"), 5);
  EXPECT_FALSE(net->motions[5].isKick());
  const KickDescription measured{.motion = "myKick",
                                 .x = 150,
                                 .y = -20,
                                 .direction = -80,
                                 .step = 20,
                                 .places = {{150, -20, 1, -80, 10, 1000, 100},
                                            {170, -20, 1, -60, 15, 900, 100},
                                            {190, -20, 0.5, -80, 5, 900, 100}}};
  net->take({{measured, {.motion = "moonwalk", .places = {{1, 1, 1, 1, 1, 1, 1}}}}});
  ASSERT_TRUE(net->motions[5].isKick());
  const KickDescription& kick = net->motions[5].kick;
  EXPECT_EQ(kick.direction, -80);
  EXPECT_EQ(kick.spreadAt({150, -25}, 0), 10);
  EXPECT_EQ(kick.spreadAt({172, -20}, 0), 25) << "another direction, and the spread";
  EXPECT_FALSE(kick.spreadAt({195, -20}, 0)) << "hits half of the balls";
  EXPECT_FALSE(kick.spreadAt({135, -20}, 0));
  EXPECT_EQ(kick.spreadAt({135, -20}, 10), 10);
  EXPECT_EQ(kick.at({165, -15})->length, 900);
  EXPECT_FALSE(kick.at({150, 0}));
  EXPECT_FALSE(net->motions[0].isKick());
  const auto missing = motionNetOf(compile({"stand"}).net, "motions");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().field, "getupFromBelly");
  EXPECT_EQ(loadMotionNet("no/such/folder").error().file, "no/such/folder");
}

}  // namespace
}  // namespace gt
