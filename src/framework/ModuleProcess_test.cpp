#include "framework/ModuleProcess.h"

#include <gtest/gtest.h>

#include "framework/DebugProcess.h"
#include "framework/TestModules.h"

namespace gt {
namespace {

using testing::Command;
using testing::Estimate;
using testing::Reading;

struct FrameTime {
  Time time;
  static constexpr auto fields() { return Fields{field("time", &FrameTime::time)}; }
};

/// One process with both modules, a Debug process, and the sensor that drives them.
class ModuleProcessTest : public ::testing::Test {
 protected:
  ModuleProcessTest() {
    const auto layout = parseLayout("process Main on Reading\nFilter\nController\n", "test.layout");
    plan = *makePlan(*layout, table, {&representation<Reading>()}, {});
    Blackboard blackboard;
    Time& time = blackboard.get<FrameTime>().time;
    process =
        std::make_unique<ModuleProcess>(plan.processes[0], std::move(blackboard), time, Random{1});
    sensor.connect(process->receiver(representation<Reading>(), true));
    debug.connect(process->debugSender(), process->debugReceiver());
  }
  void cycle(double value) {
    reading.value = value;
    sensor.send();
    now = now + 8;
    EXPECT_TRUE(process->step(now));
    debug.step(now);
  }
  template <typename Request>
  void ask(const Request& request) {
    debug.fromTools().write(now, request);
    now = now + 8;
    debug.step(now);
  }
  template <typename T>
  std::vector<T> taken() {
    std::vector<T> list;
    debug.toTools().handleAllMessages([&](const Message& message) {
      if (T value; message.is<T>() && message.read(value)) list.push_back(value);
    });
    debug.toTools().clear();
    return list;
  }
  double command() { return process->blackboard().get<Command>().value; }

  SolutionTable table = testing::table();
  Plan plan;
  std::unique_ptr<ModuleProcess> process;
  DebugProcess debug{"Debug"};
  Reading reading;
  PackageSender sensor{representation<Reading>(), &reading};
  Time now;
};

TEST_F(ModuleProcessTest, RunsItsModulesInOrder) {
  cycle(1);
  EXPECT_DOUBLE_EQ(command(), -0.5);
  cycle(1);
  EXPECT_DOUBLE_EQ(command(), -0.75);
  EXPECT_EQ(process->blackboard().get<FrameTime>().time, now);
  EXPECT_FALSE(process->step(now + 8)) << "without a new reading";
  EXPECT_EQ(process->times()[0].name(), "Filter");
  EXPECT_EQ(process->times()[0].count(), 2);
}

TEST_F(ModuleProcessTest, SwitchesSolutionsAtRunTime) {
  ask(SolutionRequest{"Filter", "Direct"});
  cycle(4);
  EXPECT_DOUBLE_EQ(command(), -4);
  ask(SolutionRequest{"Filter", "disabled"});
  cycle(8);
  EXPECT_DOUBLE_EQ(command(), -4) << "disabled: the estimate stays as it was";
  ask(SolutionRequest{"Filter", "Unheard"});
  cycle(8);
  const auto texts = taken<Text>();
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts[0].text, "Main: Filter: there is no solution 'Unheard'");
}

TEST_F(ModuleProcessTest, SetsParametersAtRunTime) {
  ask(ParameterRequest{"Filter", "Smooth", "gain", "1"});
  cycle(3);
  EXPECT_DOUBLE_EQ(command(), -3);
  ask(ParameterRequest{"Filter", "Smooth", "gain", "7"});
  cycle(5);
  EXPECT_DOUBLE_EQ(command(), -5) << "out of range: the last good value stands";
  EXPECT_EQ(taken<Text>().size(), 1u);
  EXPECT_TRUE(process->configure("Filter", "Smooth", "gain 0\n", "Filter.cfg"));
  cycle(100);
  EXPECT_DOUBLE_EQ(command(), -5);
  EXPECT_FALSE(process->configure("Filter", "Smooth", "gian 0\n", "Filter.cfg"));
}

TEST_F(ModuleProcessTest, SendsWhatIsWatchedAndDrawn) {
  cycle(1);
  EXPECT_TRUE(debug.toTools().empty());
  ask(WatchRequest{"Estimate", "Main"});
  ask(DebugRequest{"Controller/command", DebugKeyMode::times, 1});
  cycle(2);
  cycle(2);
  int estimates = 0, drawings = 0;
  debug.toTools().handleAllMessages([&](const Message& message) {
    estimates += message.is<Estimate>();
    drawings += message.is<Drawing>();
  });
  EXPECT_EQ(estimates, 2);
  EXPECT_EQ(drawings, 1);
}

}  // namespace
}  // namespace gt
