#include "framework/Layout.h"

#include <gtest/gtest.h>

#include "framework/LayoutCheck.h"
#include "framework/RepresentationDefinition.h"
#include "support/TestModules.h"

namespace gt {
namespace {

using testing::Command;
using testing::Estimate;
using testing::Reading;

Result<Plan> plan(const std::string& text) {
  const auto layout = parseLayout(text, "test.layout");
  if (!layout) return layout.error();
  static const SolutionTable table = testing::table();
  return makePlan(*layout, table, {&representation<Reading>()}, {});
}

std::string errorOf(const std::string& text) {
  const auto result = plan(text);
  return result ? "no error" : result.error().text();
}

TEST(Layout, OrdersModulesByTheirSignatures) {
  const auto result = plan("process Main on Reading // all in one\n  Controller\n  Filter\n");
  ASSERT_TRUE(result) << result.error().text();
  ASSERT_EQ(result->processes.size(), 1u);
  EXPECT_EQ(result->processes[0].order[0].task->name, "Filter");
  EXPECT_EQ(result->processes[0].order[1].task->name, "Controller");
  ASSERT_EQ(result->connections.size(), 1u);
  EXPECT_EQ(result->connections[0].type->name, "Reading");
  EXPECT_TRUE(result->connections[0].blocking);
}

TEST(Layout, FindsWhatCrosses) {
  const auto result = plan(
      "process A on Reading\nFilter\nprocess B on Reading\nController\nprocess Debug on "
      "messages\n");
  ASSERT_TRUE(result) << result.error().text();
  ASSERT_EQ(result->connections.size(), 3u);
  EXPECT_EQ(result->connections[2].type->name, "Estimate");
  EXPECT_EQ(result->connections[2].from, "A");
  EXPECT_EQ(result->connections[2].to, "B");
}

TEST(Layout, AProcessMayBeTriggeredByAnother) {
  const auto result = plan("process A on Reading\nFilter\nprocess B on Estimate\nController\n");
  ASSERT_TRUE(result) << result.error().text();
  ASSERT_EQ(result->connections.size(), 2u);
  EXPECT_EQ(result->connections[1].type->name, "Estimate");
  EXPECT_EQ(result->connections[1].from, "A");
  EXPECT_TRUE(result->connections[1].blocking);
  EXPECT_EQ(errorOf("process A on Estimate\nFilter\nController\n"),
            "test.layout:1: A: 'Estimate' is sent neither by the platform nor by another process");
}

TEST(Layout, GroupsRunInTheOrderOfTheFile) {
  const auto result =
      plan("process A on Reading\n  on cycle\n  Controller\n  on Reading\n  Filter\n");
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(result->processes[0].order[0].task->name, "Controller") << "reads the last Estimate";
  EXPECT_EQ(result->processes[0].order[0].trigger, nullptr);
  EXPECT_EQ(result->processes[0].order[1].task->name, "Filter");
  EXPECT_EQ(result->processes[0].order[1].trigger, &representation<Reading>());
  EXPECT_EQ(result->connections.size(), 1u);
  EXPECT_EQ(errorOf("process A on Reading\n\n  on Nothing\n  Filter\n"),
            "test.layout:3: A: 'Nothing' is sent neither by the platform nor by another process");
  EXPECT_EQ(errorOf("on Reading\n"), "test.layout:1: on: stands before the first process");
}

TEST(Layout, TellsWhatIsWrong) {
  EXPECT_EQ(errorOf(""), "test.layout: process: there is none");
  EXPECT_EQ(errorOf("process A\n"),
            "test.layout:1: process: expected: process NAME on REPRESENTATION, or: process NAME on "
            "messages");
  EXPECT_EQ(errorOf("Filter\n"), "test.layout:1: Filter: stands before the first process");
  EXPECT_EQ(errorOf("process A on Reading\nFilter Controller\n"),
            "test.layout:2: Filter: expected one task in a line");
  EXPECT_EQ(errorOf("process A on Reading\nprocess A on Reading\n"),
            "test.layout:2: A: there are two processes of this name");
  EXPECT_EQ(errorOf("process A on Nothing\nFilter\n"),
            "test.layout:1: A: 'Nothing' is sent neither by the platform nor by another process");
  EXPECT_EQ(errorOf("process A on Reading\nFiltre\n"),
            "test.layout:2: Filtre: there is no such task; did you mean 'Filter'?");
  EXPECT_EQ(errorOf("process A on Reading\nFilter\nFilter\n"),
            "test.layout:3: Filter: is listed twice");
  EXPECT_EQ(errorOf("process A on Reading\nController\n"),
            "test.layout:2: Controller: nobody provides its Estimate");
  EXPECT_EQ(errorOf("process D on messages\nController\n"),
            "test.layout:2: Controller: a process that collects messages runs no modules");
  EXPECT_FALSE(loadLayout("no/such/file.layout"));
}

struct Left {
  using Outputs = std::tuple<Estimate>;
};
struct Right {
  using Outputs = std::tuple<Command>;
};
class LeftModule {
 public:
  void update(const Command&, Estimate&) {}
};
class RightModule {
 public:
  void update(const Estimate&, Command&) {}
};

TEST(Layout, RejectsCirclesAndTwoProviders) {
  SolutionTable table;
  table.add<Left, LeftModule>("A");
  table.add<Right, RightModule>("A");
  const auto layout = parseLayout("process P on Reading\nLeft\nRight\n", "test.layout");
  ASSERT_TRUE(layout);
  const auto circle = makePlan(*layout, table, {&representation<Reading>()}, {});
  ASSERT_FALSE(circle);
  EXPECT_EQ(circle.error().what,
            "a circle of tasks that wait for each other: Left reads Command of Right, Right reads "
            "Estimate of Left; Previous<> breaks it");

  SolutionTable two = testing::table();
  two.add<Left, LeftModule>("A");
  const auto both = parseLayout("process P on Reading\nLeft\nFilter\n", "test.layout");
  const auto providers = makePlan(*both, two, {&representation<Reading>()}, {});
  ASSERT_FALSE(providers);
  EXPECT_EQ(providers.error().what, "Estimate is already provided by Left");
}

TEST(Layout, AllErrorsAreTold) {
  const SolutionTable table = testing::table();
  const std::string text =
      "Filter\nprocess A on Nothing\nFilter Filter\nNonsense\nprocess A on Reading\n"
      "process B on Estimate\nController\n";
  std::string reported;
  const Findings findings =
      checkLayoutText(text, "test.layout", table, {&representation<Reading>()}, {});
  for (const Error& error : findings.list())
    reported += std::to_string(error.line) + " " + error.field + "; ";
  EXPECT_EQ(reported, "1 Filter; 3 Filter; 5 A; 4 Nonsense; 2 A; 6 B; 7 Controller; ");
  EXPECT_TRUE(checkLayoutText("process A on Reading\nFilter\nController\n", "test.layout", table,
                              {&representation<Reading>()}, {})
                  .empty());
}

struct Unstreamed {
  int value = 0;
};
struct Sense {
  using Outputs = std::tuple<Unstreamed>;
};
class SenseModule {
 public:
  void update(const Reading&, Unstreamed&) const {}
};
struct Act {
  using Outputs = std::tuple<Command>;
};
class ActModule {
 public:
  void update(const Unstreamed&, Command&) {}
};

// Without fields() it would work in one program and never arrive in another one.
TEST(Layout, LetsCrossOnlyWhatCanBeStreamed) {
  SolutionTable table;
  table.add<Sense, SenseModule>("A");
  table.add<Act, ActModule>("A");
  const auto plan = [&](const char* text) {
    return makePlan(*parseLayout(text, "test.layout"), table, {&representation<Reading>()}, {});
  };
  EXPECT_TRUE(plan("process P on Reading\nSense\nAct\n"));
  const auto crossing = plan("process P on Reading\nSense\nprocess Q on Unstreamed\nAct\n");
  ASSERT_FALSE(crossing);
  EXPECT_EQ(crossing.error().text(),
            "test.layout:3: Q: Unstreamed comes from process P, but cannot be sent: it has no "
            "fields()");
}

namespace other {
struct Reading {
  int value = 0;
  static constexpr auto fields() { return Fields{field<&Reading::value>()}; }
};
}  // namespace other
class OtherSense {
 public:
  void update(const other::Reading&, Unstreamed&) {}
};

TEST(Layout, RefusesTwoRepresentationsOfOneName) {
  SolutionTable table;
  table.add<Sense, SenseModule>("A");
  table.add<Sense, OtherSense>("B");
  const auto plan = makePlan(*parseLayout("process P on Reading\nSense\n", "test.layout"), table,
                             {&representation<Reading>()}, {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().what.find("cannot be distinguished"), std::string::npos);
  EXPECT_NE(plan.error().what.find("other::Reading"), std::string::npos);
  Blackboard blackboard;
  blackboard.get<Reading>();
  EXPECT_DEATH(blackboard.get<other::Reading>(), "cannot be distinguished");
}

/// A solution that need not be chosen may want another platform; a default may not.
TEST(Layout, LeavesOutWhatOnlyAnotherPlatformWouldSend) {
  const Layout layout = *parseLayout("process A on Reading\nFilter\n", "test.layout");
  const auto planFor = [&](const SolutionTable& table, auto*... sent) {
    return makePlan(layout, table, {&representation<Reading>(), sent...}, {});
  };
  SolutionTable table = testing::table();
  table.add<testing::Filter, testing::SecretFilter>("Secret");
  const auto without = planFor(table);
  ASSERT_TRUE(without) << without.error().text();
  EXPECT_EQ(without->processes[0].missing, std::vector{&representation<testing::Secret>()});
  EXPECT_EQ(without->connections.size(), 1u);
  const auto with = planFor(table, &representation<testing::Secret>());
  ASSERT_TRUE(with) << with.error().text();
  EXPECT_TRUE(with->processes[0].missing.empty());
  EXPECT_EQ(with->connections.size(), 2u);
  SolutionTable always;
  always.add<testing::Filter, testing::SecretFilter>("Secret");
  const auto refused = planFor(always);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), "test.layout:2: Filter: nobody provides its Secret");
}

TEST(Layout, HasOneProcessThatCollectsMessages) {
  const auto layout = parseLayout("process A on messages\nprocess B on messages\n", "test.layout");
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().text(), "test.layout:2: B: process A collects messages already");
}

}  // namespace
}  // namespace gt
