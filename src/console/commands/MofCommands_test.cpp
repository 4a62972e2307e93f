#include "console/TestSession.h"
#include "representations/motion/OdometryData.h"

namespace gt {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

using MofCommands = SessionTest;

TEST_F(MofCommands, TriesMotionsLineByLine) {
  const auto pan = [&] { return robot(0).provided<JointData>()->angles[Joint::headPan]; };
  expectFine("robot red1");
  expectError("mof stop", "mof", "sr MotionControl Debug");
  expectFine("run 1 s");
  expectFine("sr MotionControl Debug");
  expectFine("run 100 ms");
  expectFine("mof execute ~ 500 ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ 1 25");
  expectFine("run 400 ms");
  EXPECT_NEAR(pan(), 0.5, 1e-9);
  const auto read = answers("mof read");
  ASSERT_THAT(read, SizeIs(1));
  EXPECT_THAT(read[0], HasSubstr("1 25"));
  expectFine("mof execute " + read[0]);
  expectFine("run 400 ms");
  EXPECT_NEAR(pan(), 0.5, 0.05) << "what was read leads to where it was read";
  std::ofstream{file("nod.mof")} << "~ 300 ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ 0 10\n"
                                    "~ -300 ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ 0 10\n";
  expectFine("mof loop " + file("nod.mof"));
  int turns = 0;
  for (double last = pan(), i = 0; i < 10; ++i) {
    expectFine("run 80 ms");
    turns += pan() * last < 0;
    last = pan();
  }
  EXPECT_GE(turns, 8);
  expectFine("mof stop");
  expectFine("run 200 ms");
  const double stopped = pan();
  expectFine("run 500 ms");
  EXPECT_NEAR(pan(), stopped, 0.01);
  expectError("mof execute ~ 9500 ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ 1 25", "headPan", "not within");
  expectFine("sr MotionControl Default");
  expectFine("run 1 s");
  EXPECT_NE(pan(), stopped);
}

TEST_F(MofCommands, LinesAreExecutedAtTheTimeOfTheSwitchToDebug) {
  const auto pan = [&] { return robot(0).provided<JointData>()->angles[Joint::headPan]; };
  expectFine("robot red1");
  expectFine("run 1 s");
  expectFine("sr MotionControl Debug");
  expectFine("mof execute ~ -1200 ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ ~ 1 125");
  expectFine("run 1200 ms");
  EXPECT_NEAR(pan(), -1.2, 1e-9);
  // They are not executed again when Debug is switched on again.
  expectFine("sr MotionControl Default");
  expectFine("run 1 s");
  expectFine("sr MotionControl Debug");
  const double before = pan();
  ASSERT_GT(std::abs(before + 1.2), 0.1);
  expectFine("run 400 ms");
  EXPECT_GT(std::abs(pan() + 1.2), 0.1);
}

}  // namespace
}  // namespace gt
