#pragma once
#include <gtest/gtest.h>

#include "modules/motion/control/DefaultMotionControl.h"
#include "modules/motion/getup/GravityGetupEngine.h"
#include "modules/motion/specialactions/GT2003MotionNetSpecialActions.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "streams/Config.h"

namespace gt {

/// The modules of the motion in the order in which they run, for tests.
struct MotionHarness {
  InvKinWalkingEngine walkingEngine;
  GT2003MotionNetSpecialActions specialActions;
  GravityGetupEngine getupEngine;
  DefaultMotionControl motionControl;
  RobotDimensions robot;
  MotionNet net;
  FrameInfo frame;
  MotionRequest request;
  HeadMotionRequest head;
  WalkingEngineOutput walking;
  GetupEngineOutput getup;
  SensorDataBuffer sensors;
  SpecialActionsOutput special;
  JointData joints;
  JointGains gains;
  OdometryData odometry;
  Debug debug;
  MotionInfo info;

  MotionHarness() {
    EXPECT_TRUE(readConfig("config/modules/WalkingEngine.InvKin.cfg", walkingEngine.parameters));
    auto loaded = loadMotionNet("motions");
    EXPECT_TRUE(loaded) << loaded.error().text();
    net = *std::move(loaded);
  }

  void step() {
    frame.time.ms += 8;
    const MotionInfo infoBefore = info;
    const JointData jointsBefore = joints;
    walkingEngine.update(frame, request, robot, sensors, {infoBefore}, walking);
    specialActions.update(frame, request, net, {infoBefore}, {jointsBefore}, special, debug);
    getupEngine.update(frame, sensors, net, {infoBefore}, {jointsBefore}, getup, debug);
    motionControl.update(frame, request, walking, special, getup, head, joints, gains, odometry,
                         info);
  }
  void steps(int n) {
    for (int i = 0; i < n; ++i) step();
  }
  void walk(double x, double y, double rotation) {
    request = {};
    request.type = MotionType::walk;
    request.walk = {rotation, x, y};
  }
  void perform(std::string_view action) {
    request = {};
    request.type = MotionType::specialAction;
    request.specialAction = action;
  }
  bool performs(std::string_view action) const { return info.executed.specialAction == action; }
};

}  // namespace gt
