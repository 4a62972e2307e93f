#include "framework/ModuleProcess.h"

#include <gtest/gtest.h>

#include <map>

#include "base/CrashNotes.h"
#include "framework/DebugProcess.h"
#include "framework/RepresentationDefinition.h"
#include "support/TestModules.h"

namespace gt {
namespace {

using testing::Command;
using testing::Estimate;
using testing::Reading;

struct FrameTime {
  Time time;
  static constexpr auto fields() { return Fields{field<&FrameTime::time>()}; }
};

/// One process with both modules, a Debug process, and the sensor that drives them.
class ModuleProcessTest : public ::testing::Test {
 protected:
  ModuleProcessTest() {
    const auto layout = parseLayout("process Main on Reading\nFilter\nController\n", "test.layout");
    plan = *makePlan(*layout, table, {&representation<Reading>()}, {&representation<FrameTime>()});
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
  template <typename... Request>
  void ask(const Request&... request) {
    (debug.fromTools().write(now, request), ...);
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
  EXPECT_EQ(process->times()[0].name, "Filter");
  EXPECT_EQ(process->times()[0].count, 2);
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
  const auto answers = taken<RequestAnswer>();
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0].outcome, RequestOutcome::done);
  EXPECT_EQ(answers[0].request, messageId<SolutionRequest>());
  EXPECT_EQ(answers[2].outcome, RequestOutcome::refused);
  EXPECT_EQ(answers[2].process, "Main");
  EXPECT_EQ(answers[2].what, "Filter: there is no solution 'Unheard'");
}

TEST_F(ModuleProcessTest, RefusesASolutionThatReadsWhatThePlatformDoesNotSend) {
  table.add<testing::Filter, testing::SecretFilter>("Secret");
  const auto layout = parseLayout("process Main on Reading\nFilter\n", "test.layout");
  const auto request = [&](auto*... sent) {
    const Plan made = *makePlan(*layout, table, {&representation<Reading>(), sent...},
                                {&representation<FrameTime>()});
    Blackboard blackboard;
    Time& time = blackboard.get<FrameTime>().time;
    ModuleProcess one{made.processes[0], std::move(blackboard), time, Random{1}};
    const auto done = one.request(SolutionRequest{"Filter", "Secret"});
    return one.activeSolution("Filter") + (done ? "" : ": " + done.error().text());
  };
  EXPECT_EQ(request(), "Smooth: Filter: 'Secret' reads Secret, which this robot does not get");
  EXPECT_EQ(request(&representation<testing::Secret>()), "Secret");
}

TEST_F(ModuleProcessTest, SetsParametersAtRunTime) {
  ask(ParameterRequest{"Filter", "Smooth", "gain", "1"});
  cycle(3);
  EXPECT_DOUBLE_EQ(command(), -3);
  ask(ParameterRequest{"Filter", "Smooth", "gain", "7"});
  cycle(5);
  EXPECT_DOUBLE_EQ(command(), -5) << "out of range: the last good value stands";
  const auto answers = taken<RequestAnswer>();
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[1].what, "gain: must be from 0 to 1 instead of 7");
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

TEST_F(ModuleProcessTest, SaysWhatDoesNotConcernIt) {
  ask(SolutionRequest{"Unheard", "Direct"}, DebugRequest{"Unheard", DebugKeyMode::always},
      WatchRequest{"Unheard", ""}, WatchRequest{"Estimate", "Elsewhere"},
      ValueRequest{"Unheard", "value", "1"}, DescriptionRequest{"Elsewhere"});
  cycle(1);
  const auto answers = taken<RequestAnswer>();
  ASSERT_EQ(answers.size(), 6u);
  for (const RequestAnswer& answer : answers)
    EXPECT_EQ(answer.outcome, RequestOutcome::notConcerned);
}

// Image comes from the process that receives it, configuration from the first one.
TEST_F(ModuleProcessTest, AnswersForWhatItReceives) {
  ask(WatchRequest{"Reading", "", DebugKeyMode::times, 1});
  cycle(3);
  const auto readings = taken<Reading>();
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].value, 3);
  ask(WatchRequest{"FrameTime", "", DebugKeyMode::times, 1});
  cycle(3);
  const auto times = taken<FrameTime>();
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times[0].time, now);
}

TEST_F(ModuleProcessTest, SendsItsModulesTimes) {
  ask(WatchRequest{"ModuleTimes", "", DebugKeyMode::everyTimes, 2});
  for (int i = 0; i < 4; ++i) cycle(1);
  const auto times = taken<ModuleTimes>();
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[1].process, "Main");
  ASSERT_EQ(times[1].modules.size(), 2u);
  EXPECT_EQ(times[1].modules[0].name, "Filter");
  EXPECT_EQ(times[1].modules[0].count - times[0].modules[0].count, 2);
  EXPECT_GE(times[1].modules[0].totalMs, times[0].modules[0].totalMs);
  EXPECT_GE(times[1].modules[0].longestMs, times[1].modules[0].lastMs);
}

TEST_F(ModuleProcessTest, SetsAndHoldsValues) {
  ask(ValueRequest{"Reading", "value", "8", ValueMode::hold}, SolutionRequest{"Filter", "Direct"});
  cycle(4);
  EXPECT_EQ(command(), -8) << "before its readers run";
  ask(ValueRequest{"Estimate", "value", "2", ValueMode::hold});
  cycle(4);
  EXPECT_EQ(command(), -2) << "after its provider ran";
  ask(ValueRequest{"Estimate", "", "", ValueMode::release},
      ValueRequest{"Reading", "value", "", ValueMode::release});
  cycle(4);
  EXPECT_EQ(command(), -4);
  ask(SolutionRequest{"Filter", "disabled"}, ValueRequest{"Estimate", "value", "5"});
  cycle(4);
  cycle(4);
  EXPECT_EQ(command(), -5) << "nobody provides it anew";
  taken<RequestAnswer>();
  ask(ValueRequest{"Estimate", "valeu", "5"});
  cycle(4);
  const auto answers = taken<RequestAnswer>();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].what, "Estimate.valeu: unknown name; Estimate has value");
}

// Numbers by a name become the parameters of a solution (report E.2).
TEST_F(ModuleProcessTest, TakesGenericDebugData) {
  ask(GenericDebugData{"Filter", {1}});
  cycle(3);
  EXPECT_EQ(command(), -3);
  ask(GenericDebugData{"Filter.Smooth", {0.5}});
  cycle(5);
  EXPECT_EQ(command(), -4);
  ask(GenericDebugData{"Filter.Smooth", {0.5, 1}}, GenericDebugData{"Filter.Direct", {0.5}},
      GenericDebugData{"Filter", {7}});
  cycle(4);
  const auto answers = taken<RequestAnswer>();
  ASSERT_EQ(answers.size(), 5u);
  for (std::size_t i = 2; i < 5; ++i) EXPECT_EQ(answers[i].outcome, RequestOutcome::refused);
  EXPECT_EQ(answers[2].what, "Filter.Smooth: these are more numbers than it has parameters");
}

TEST_F(ModuleProcessTest, DescribesItself) {
  ask(DescriptionRequest{}, DescriptionRequest{"Filter"});
  cycle(1);
  const auto descriptions = taken<ProcessDescription>();
  ASSERT_EQ(descriptions.size(), 2u);
  EXPECT_EQ(descriptions[0].tasks.size(), 2u);
  std::map<std::string, RepresentationOrigin> origins;
  for (const auto& r : descriptions[0].representations) origins[r.name] = r.origin;
  EXPECT_EQ(origins.at("Reading"), RepresentationOrigin::platform);
  EXPECT_EQ(origins.at("Command"), RepresentationOrigin::provided);
  EXPECT_EQ(origins.at("FrameTime"), RepresentationOrigin::configuration);
  ASSERT_EQ(descriptions[1].tasks.size(), 1u);
  EXPECT_EQ(descriptions[1].tasks[0].solutions[0].parameters[0].value, "0.5");
}

// A value that several robots share is changed in the one that was asked, and acts at once.
TEST(SharedConfiguration, IsCopiedWhenItIsChanged) {
  SolutionTable table;
  table.add<testing::Filter, testing::DirectFilter>("Direct");
  const auto layout = parseLayout("process Main on FrameTime\nFilter\n", "test.layout");
  const Plan plan =
      *makePlan(*layout, table, {&representation<FrameTime>()}, {&representation<Reading>()});
  const auto shared = std::make_shared<Reading>(Reading{{}, 3});
  FrameTime time;
  PackageSender clock{representation<FrameTime>(), &time};
  std::vector<std::unique_ptr<ModuleProcess>> processes;
  for (int i = 0; i < 2; ++i) {
    Blackboard blackboard;
    blackboard.share(representation<Reading>(), shared);
    Time& now = blackboard.get<FrameTime>().time;
    processes.push_back(
        std::make_unique<ModuleProcess>(plan.processes[0], std::move(blackboard), now, Random{1}));
    clock.connect(processes.back()->receiver(representation<FrameTime>(), true));
  }
  const auto estimate = [&](int i) { return processes[i]->blackboard().get<Estimate>().value; };
  EXPECT_TRUE(processes[0]->request(ValueRequest{"Reading", "value", "7"}));
  clock.send();
  for (const auto& process : processes) process->step({8});
  EXPECT_EQ(estimate(0), 7);
  EXPECT_EQ(estimate(1), 3);
  EXPECT_EQ(shared->value, 3);
}

/// Fails in its third cycle.
class FailingFilter {
 public:
  void update(const Reading&, Estimate& estimate) {
    if (++cycles_ > 2) throw ModuleFailure{"no more", "Direct"};
    estimate.value = 100;
  }

 private:
  int cycles_ = 0;
};

Solution failing(std::string name, std::vector<Port> ports) {
  return {std::move(name), std::move(ports), [](ModuleContext context) {
            return std::make_unique<ModuleAdapter<FailingFilter>>(std::move(context));
          }};
}

TEST_F(ModuleProcessTest, SwitchesToAnotherSolutionWhenOneFails) {
  table.add<testing::Filter, FailingFilter>("Failing");
  Blackboard blackboard;
  Time& time = blackboard.get<FrameTime>().time;
  ModuleProcess other{plan.processes[0], std::move(blackboard), time, Random{1}};
  PackageReceiver& receiver = other.receiver(representation<Reading>(), true);
  ASSERT_TRUE(other.request(SolutionRequest{"Filter", "Failing"}));
  reading.value = 7;
  for (const double expected : {100, 100, 7, 7}) {
    receiver.deliver(&reading);
    now = now + 8;
    ASSERT_TRUE(other.step(now));
    EXPECT_EQ(other.blackboard().get<Estimate>().value, expected);
  }
  EXPECT_EQ(other.activeSolution("Filter"), "Direct");
  std::vector<std::string> warnings;
  other.debug().out().handleAllMessages([&](const Message& message) {
    if (Text text; message.is<Text>() && message.read(text)) warnings.push_back(text.text);
  });
  EXPECT_EQ(warnings, std::vector<std::string>{"Filter: Failing failed, now Direct: no more"});
}

TEST(SolutionTable, TakesSolutionsAtRunTimeThatFit) {
  SolutionTable table = testing::table();
  const Port estimate{PortKind::output, &representation<Estimate>()};
  const auto refused = [&](const char* task, Solution solution) {
    const auto done = table.add(task, std::move(solution));
    return done ? std::string{} : done.error().text();
  };
  EXPECT_EQ(refused("Fliter", failing("New", {estimate})),
            "Fliter: there is no such task; did you mean 'Filter'?");
  EXPECT_EQ(refused("Controller", failing("New", {estimate})),
            "Controller: 'New' does not provide what the task provides");
  for (const char* taken : {"Smooth", "disabled"})
    EXPECT_EQ(refused("Filter", failing(taken, {estimate})),
              "Filter: has a solution '" + std::string{taken} + "' already; choose another name");
  EXPECT_EQ(refused("Filter", failing("New", {estimate})), "");
  EXPECT_EQ(refused("Filter", failing("New", {estimate, {PortKind::input, estimate.type}})), "");
  EXPECT_EQ(table.find("Filter")->solutions.size(), 3u);
  EXPECT_EQ(table.find("Filter")->find("New")->ports.size(), 2u);
}

/// Leaves a note for a crash report.
class NotingFilter {
 public:
  void update(const Reading& reading, Estimate&) {
    noteForCrashReport("reads " + std::to_string(static_cast<int>(reading.value)));
  }
};

std::string lastNote(std::uint64_t before) {
  const CrashNotes& notes = CrashNotes::ofProcess();
  std::string text;
  notes.forEachLetter(notes.end() - before, [&](char letter) { text += letter; });
  return text;
}

TEST_F(ModuleProcessTest, NamesWhatRunsForCrashReports) {
  SolutionTable noting;
  noting.addTask<testing::Filter>();
  noting.add<testing::Filter, NotingFilter>("Noting");
  const auto layout = parseLayout("process Main on Reading\nFilter\n", "test.layout");
  plan = *makePlan(*layout, noting, {&representation<Reading>()}, {&representation<FrameTime>()});
  Blackboard blackboard;
  Time& time = blackboard.get<FrameTime>().time;
  ModuleProcess other{plan.processes[0], std::move(blackboard), time, Random{1}};
  reading.value = 7;
  other.receiver(representation<Reading>(), true).deliver(&reading);
  ASSERT_TRUE(other.step(Time{40}));
  EXPECT_EQ(lastNote(1), "Main at 40 ms, Filter: reads 7");

  ask(SolutionRequest{"Filter", "Direct"});
  cycle(1);
  EXPECT_EQ(lastNote(1), "Main at " + std::to_string(now.ms) + " ms: SolutionRequest");
  CrashContext::forEachPart([](std::string_view part) { ADD_FAILURE() << part << " is open"; });
}

}  // namespace
}  // namespace gt
