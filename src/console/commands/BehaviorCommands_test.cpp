#include "console/TestSession.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/HeadControlMode.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using BehaviorCommands = SessionTest;

TEST_F(BehaviorCommands, ShowsAndChangesWhatTheBehaviorDoes) {
  expectFine("xlb gt03");
  EXPECT_THAT(answers("xlb ?"), Contains("GT2003"));
  expectFine("dk sendXabsl2DebugMessages on");
  expectFine("xis ball.seen.distance on");
  expectFine("xis ball.time-since-last-seen on");
  expectFine("xos head-control-mode on");
  expectFine("xos head-control-mode head-control-mode.search-for-ball");
  expectFine("xbb go-to-point 1600 0 0");
  expectFine("run 1");
  BehaviorState state;
  const auto look = [&] { state = *session->robots()[0]->observed().newest<BehaviorState>(); };
  look();
  ASSERT_EQ(state.activations.size(), 1u);
  EXPECT_EQ(state.activations[0].name, "go_to_point");
  EXPECT_EQ(state.activations[0].parameters[0].value, "1600");
  ASSERT_EQ(state.inputs.size(), 2u);
  EXPECT_EQ(state.inputs[0].unit, "mm");
  ASSERT_EQ(state.outputs.size(), 1u);
  EXPECT_EQ(state.outputs[0].value, "search_for_ball");
  EXPECT_EQ(robot(0).provided<HeadControlMode>()->mode, HeadMode::searchForBall);
  expectFine("xos head-control-mode unchanged");
  expectFine("xis ball.seen.distance off");
  expectFine("xo go-to-kickoff-position 2000 0");  // as report I.5.3 prints it
  expectFine("run 200 ms");
  look();
  EXPECT_EQ(state.activations[0].name, "go_to_kickoff_position");
  EXPECT_EQ(state.activations[0].parameters[0].value, "2000");
  EXPECT_EQ(state.activations[1].name, "go_to_point");
  EXPECT_EQ(state.activations[1].parameters[0].value, "2000");
  EXPECT_EQ(state.inputs.size(), 1u);
  EXPECT_EQ(state.outputs.size(), 1u);
  expectFine("xbb perform-special-action sit");
  expectFine("run 200 ms");
  look();
  EXPECT_EQ(state.activations[0].parameters[0].value, "sit");
  expectError("xbb perform-special-action sat", "sat", "did you mean 'sit'?");
  expectFine("xo unchanged");
  expectFine("run 200 ms");
  look();
  EXPECT_EQ(state.activations[0].name, "play_soccer");
  EXPECT_THAT(answers("xos ?"), Contains("head_control_mode"));
  EXPECT_THAT(answers("xos head-control-mode ?"), Contains("look_left"));
  EXPECT_THAT(answers("xis ?"), Contains("ball.seen.angle"));
  EXPECT_THAT(answers("xo ?"), Contains("play_soccer"));
  EXPECT_THAT(answers("xbb ?"), Contains(HasSubstr("go_to_point x")));
  expectError("xbb fly", "fly", "none of this name");
  expectError("xbb go-to-point 1 2 3 4 5 6", "go_to_point", "parameters");
  expectError("xos head-control-mode nod", "nod", "is no value");
  expectError("xos nothing on", "nothing", "no such output symbol");
  expectError("xis nothing on", "nothing", "no such input symbol");
  EXPECT_FALSE(console->execute("xlb nothing"));
}

}  // namespace
}  // namespace gt
