#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/File.h"
#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "framework/Requests.h"
#include "representations/behavior/BehaviorRequest.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/CameraMatrix.h"
#include "support/SteppedRobot.h"

namespace gt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

enum class Form { inOneProgram, asPrograms };

/// A robot in one program and as programs of their own: to who asks it, it is the same.
class RobotForms : public ::testing::TestWithParam<Form> {
 protected:
  RobotForms() {
    const auto configuration = loadConfiguration({});
    EXPECT_TRUE(configuration) << configuration.error().text();
    const auto layout = loadLayout("layouts/cmd.layout");
    EXPECT_TRUE(layout) << layout.error().text();
    const RobotSetup setup{*configuration, *layout, {TeamColor::red, PlayerRole::striker1}, 1};
    if (GetParam() == Form::inOneProgram)
      robot = std::make_unique<testing::RobotInOneProgram>(setup);
    else
      robot = std::make_unique<testing::RobotAsPrograms>(setup);
    // Programs find each other after a while.
    for (int i = 0; i < 100 && answersTo<DescriptionRequest>().size() < 2; ++i) {
      robot->ask(DescriptionRequest{});
      robot->runFor(200);
    }
    EXPECT_GE(answersTo<DescriptionRequest>().size(), 2u);
    robot->runFor(1000);
    hear();
    messages.clear();
  }

  /// Takes what the robot sent meanwhile.
  void hear() { robot->toTools().moveAllMessages(messages); }
  template <typename T>
  std::vector<T> heard() {
    hear();
    std::vector<T> all;
    messages.handleAllMessages([&](const Message& message) {
      T value;
      if (message.is<T>() && message.read(value)) all.push_back(std::move(value));
    });
    return all;
  }
  /// Asks, and runs until that many processes have answered; false if they do not.
  template <typename Request>
  bool answered(const Request& request, std::size_t answers) {
    messages.clear();
    robot->ask(request);
    return robot->runUntil([&] { return answersTo<Request>().size() >= answers; });
  }
  template <typename Request>
  std::vector<RequestAnswer> answersTo() {
    std::vector<RequestAnswer> answers;
    for (RequestAnswer& answer : heard<RequestAnswer>())
      if (answer.request == messageId<Request>()) answers.push_back(std::move(answer));
    return answers;
  }
  /// Asks what concerns one process, and returns its answer.
  template <typename Request>
  RequestAnswer answerTo(const Request& request) {
    EXPECT_TRUE(answered(request, 2));
    RequestAnswer concerned;
    concerned.outcome = RequestOutcome::notConcerned;
    for (const RequestAnswer& answer : answersTo<Request>())
      if (answer.outcome != RequestOutcome::notConcerned) concerned = answer;
    return concerned;
  }
  template <typename T>
  bool arrives() {
    return robot->runUntil([&] { return !heard<T>().empty(); });
  }

  std::unique_ptr<testing::SteppedRobot> robot;
  MessageQueue messages{16 << 20};
};

TEST_P(RobotForms, ItsProcessesDescribeThemselves) {
  ASSERT_TRUE(answered(DescriptionRequest{}, 2));
  const auto descriptions = heard<ProcessDescription>();
  ASSERT_EQ(descriptions.size(), 2u);
  for (const ProcessDescription& process : descriptions) {
    EXPECT_THAT(process.process, ::testing::AnyOf("Cognition", "Motion"));
    EXPECT_GE(process.tasks.size(), 6u);
    EXPECT_FALSE(process.tasks.front().solutions.empty());
  }
}

TEST_P(RobotForms, SolutionsAndParametersAreSwitched) {
  EXPECT_EQ(answerTo(SolutionRequest{"BallLocator", "disabled"}).outcome, RequestOutcome::done);
  EXPECT_EQ(answerTo(ParameterRequest{"WalkingEngine", "", "normal.maxStepSizeX", "20"}).outcome,
            RequestOutcome::done);
  ASSERT_TRUE(answered(DescriptionRequest{}, 2));
  bool disabled = false, slower = false;
  for (const ProcessDescription& process : heard<ProcessDescription>())
    for (const TaskDescription& task : process.tasks) {
      disabled |= task.name == "BallLocator" && task.active == "disabled";
      for (const SolutionDescription& solution : task.solutions)
        for (const ParameterDescription& parameter : solution.parameters)
          slower |= parameter.path == "normal.maxStepSizeX" && parameter.value == "20";
    }
  EXPECT_TRUE(disabled);
  EXPECT_TRUE(slower);
}

TEST_P(RobotForms, WhatNobodyCanDoIsAnswered) {
  EXPECT_EQ(answerTo(SolutionRequest{"NoTask", "X"}).outcome, RequestOutcome::notConcerned);
  EXPECT_EQ(answerTo(WatchRequest{"NoRepresentation", ""}).outcome, RequestOutcome::notConcerned);
  EXPECT_EQ(answerTo(DebugRequest{"no such key"}).outcome, RequestOutcome::notConcerned);
  const RequestAnswer wrong = answerTo(SolutionRequest{"BallLocator", "X"});
  EXPECT_EQ(wrong.outcome, RequestOutcome::refused);
  EXPECT_THAT(wrong.what, HasSubstr("there is no solution 'X'"));
  EXPECT_EQ(wrong.process, "Cognition");
}

TEST_P(RobotForms, RepresentationsAreWatchedWhereverTheyAre) {
  EXPECT_EQ(answerTo(WatchRequest{"OdometryData", ""}).process, "Motion");
  EXPECT_EQ(answerTo(WatchRequest{"CameraMatrix", ""}).process, "Cognition");
  EXPECT_EQ(answerTo(WatchRequest{"Image", "", DebugKeyMode::times, 1}).process, "Cognition");
  EXPECT_TRUE(arrives<OdometryData>());
  EXPECT_TRUE(arrives<CameraMatrix>());
  EXPECT_TRUE(arrives<Image>());
}

TEST_P(RobotForms, ALayoutIsChangedInOneProgramOnly) {
  robot->ask(LayoutRequest{"single.layout", *readFile("layouts/single.layout")});
  ASSERT_TRUE(robot->runUntil([&] { return !answersTo<LayoutRequest>().empty(); }));
  const RequestAnswer answer = answersTo<LayoutRequest>().front();
  if (GetParam() == Form::inOneProgram) {
    EXPECT_EQ(answer.outcome, RequestOutcome::done);
    ASSERT_TRUE(answered(DescriptionRequest{}, 1));
    EXPECT_EQ(heard<ProcessDescription>().at(0).process, "Robot");
  } else {
    EXPECT_EQ(answer.outcome, RequestOutcome::refused);
    EXPECT_EQ(answer.what,
              "single.layout: the robot's processes are programs of their own: start those of the "
              "layout");
  }
}

TEST_P(RobotForms, ABehaviorComesAsTextOrByItsName) {
  ASSERT_EQ(answerTo(DebugRequest{"BehaviorControl/activations", DebugKeyMode::always}).outcome,
            RequestOutcome::done);
  const auto playing = [&](const std::string& option) {
    messages.clear();
    return robot->runUntil([&] {
      const auto states = heard<BehaviorState>();
      return !states.empty() && toString(states.back()).find(option) != std::string::npos;
    });
  };
  EXPECT_TRUE(playing("play_soccer("));
  const RequestAnswer wrong =
      answerTo(BehaviorRequest{"wrong.xabsl", {{"wrong.xabsl", "option play {"}}});
  EXPECT_EQ(wrong.outcome, RequestOutcome::refused);
  EXPECT_THAT(wrong.what, HasSubstr("wrong.xabsl:1"));
  const std::string lie =
      "namespace s(\"\") { behavior getup {} } agent a(\"\", lie);"
      "option lie { initial state wait { action { getup(); } } }";
  EXPECT_EQ(answerTo(BehaviorRequest{"lie.xabsl", {{"lie.xabsl", lie}}}).outcome,
            RequestOutcome::done);
  EXPECT_TRUE(playing("lie("));
  for (const char* name : {"GT2003", "behavior/GT2003.xabsl"})
    EXPECT_EQ(answerTo(BehaviorRequest{name, {}}).outcome, RequestOutcome::done) << name;
  EXPECT_TRUE(playing("play_soccer("));
}

/// No message makes a robot read a file that is none of its behaviors, or write one.
TEST_P(RobotForms, NoFileIsChosenFromOutside) {
  for (const char* path : {"/etc/passwd", "../../../etc/passwd", "behavior/../config/field.cfg",
                           "config/field.cfg", "/etc/passwd.xabsl", ""}) {
    const RequestAnswer answer = answerTo(BehaviorRequest{path, {}});
    EXPECT_EQ(answer.outcome, RequestOutcome::refused) << path;
    EXPECT_THAT(answer.what, HasSubstr("is none of the robot's behaviors (")) << path;
    EXPECT_THAT(answer.what, Not(HasSubstr("root"))) << path;
  }
  const RequestAnswer including = answerTo(
      BehaviorRequest{"a.xabsl", {{"a.xabsl", "include \"/etc/passwd\"; agent a(\"\", b);"}}});
  EXPECT_EQ(including.outcome, RequestOutcome::refused);
  EXPECT_THAT(including.what, HasSubstr("there is no such file"));
}

/// The shared configuration is replaced for this robot, at once.
TEST_P(RobotForms, ItsConfigurationIsReplacedWhileItRuns) {
  // The head is held still, and so is the camera.
  ASSERT_EQ(answerTo(SolutionRequest{"HeadControl", "disabled"}).outcome, RequestOutcome::done);
  ASSERT_EQ(answerTo(WatchRequest{"CameraMatrix", ""}).outcome, RequestOutcome::done);
  const auto rotation = [&]() -> Matrix3d {
    messages.clear();
    EXPECT_TRUE(arrives<CameraMatrix>());
    return heard<CameraMatrix>().back().pose.rotation;
  };
  Matrix3d before = rotation();
  ASSERT_TRUE(robot->runUntil([&] {
    robot->runFor(200);
    const Matrix3d last = std::exchange(before, rotation());
    return before.isApprox(last, 1e-6);
  }));
  robot->ask(RobotCalibration{0.2, 0});
  EXPECT_TRUE(robot->runUntil([&] {
    const double turned = std::acos(((rotation() * before.transpose()).trace() - 1) / 2);
    return std::abs(turned - 0.2) < 0.02;
  })) << "the camera leans";
  robot->ask(WatchRequest{"CameraMatrix", "", DebugKeyMode::disabled});

  const auto table = [&] {
    messages.clear();
    robot->ask(WatchRequest{"ColorTable64", "", DebugKeyMode::times, 1});
    EXPECT_TRUE(arrives<ColorTable64>());
    return heard<ColorTable64>().back();
  };
  ColorTable64 colors;
  colors.classes.fill(ColorClass::pink);
  EXPECT_NE(table().classes, colors.classes);
  robot->ask(colors);
  EXPECT_TRUE(robot->runUntil([&] { return table().classes == colors.classes; }));
  EXPECT_NE((*loadConfiguration({}))->get<ColorTable64>().classes, colors.classes);

  HsiColors hsi;
  hsi.ranges[ColorClass::green] = {{0, 359}, {0, 100}, {0, 100}};
  robot->ask(hsi);
  EXPECT_TRUE(robot->runUntil([&] { return table().classes == hsi.table().classes; }));

  TslColors tsl;
  tsl.classes[ColorClass::orange].saturation = {10, 20};
  robot->ask(tsl);
  EXPECT_TRUE(robot->runUntil([&] {
    messages.clear();
    robot->ask(WatchRequest{"TslColors", "", DebugKeyMode::times, 1});
    return arrives<TslColors>() && heard<TslColors>().back() == tsl;
  }));
}

TEST_P(RobotForms, CameraSettingsReachTheBody) {
  EXPECT_TRUE(robot->runUntil([&] { return robot->output.camera.has_value(); }));
  const CameraSettings dark{WhiteBalance::wb_fl_mode, Gain::gain_low, ShutterSpeed::shutter_fast};
  EXPECT_NE(*robot->output.camera, dark);
  robot->ask(dark);
  EXPECT_TRUE(robot->runUntil([&] { return *robot->output.camera == dark; }));
}

INSTANTIATE_TEST_SUITE_P(All, RobotForms, ::testing::Values(Form::inOneProgram, Form::asPrograms),
                         [](const auto& form) {
                           return form.param == Form::inOneProgram ? "InOneProgram" : "AsPrograms";
                         });

}  // namespace
}  // namespace gt
