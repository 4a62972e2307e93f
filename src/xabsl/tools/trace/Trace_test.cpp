#include "xabsl/tools/trace/Trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/TestAllocations.h"
#include "xabsl/tests/TestEngine.h"
#include "xabsl/tools/trace/Coverage.h"
#include "xabsl/tools/trace/Moment.h"
#include "xabsl/tools/trace/Question.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

namespace xabsl {
namespace {

using testing::HasSubstr;

const std::string searching = R"(
  option main {
    common decision { if (seen && x < 0) goto home; }
    initial state search {
      decision { else if (seen && y > 2) goto approach; else stay; }
      action { stop(); } }
    state approach {
      decision { else if (action_done) goto search; else stay; }
      action { result = weighted(a = x, b = 1); sub(speed = x * 2, how = slow); } }
    state home { decision { else goto search; } action { } } }
  option sub {
    float @speed; enum mode @how;
    initial state go { decision { if (@speed >= 10) goto done; else stay; }
                       action { walk(speed = @speed, style = @how); } }
    target state done { action { stop(); } } })";

class TraceTest : public test::EngineTest {
 protected:
  TraceTest() {
    load(searching);
    engine->record(&recorder);
  }

  /// Four cycles: searches, approaches, approaches, reaches.
  void play() {
    engine->execute(100);
    world.seen = true;
    world.y = 2.123456789;
    world.x = 3;
    engine->execute(140);
    engine->execute(180);
    world.x = 5;
    engine->execute(220);
  }
  Trace recorded() const { return {TraceSubject::of(*engine), recorder.events()}; }

  TraceRecorder recorder{10'000};
};

std::string printed(const Trace& trace, bool all = false) {
  std::string text;
  const TraceEvent* before = nullptr;
  forEachCycle(trace.events, [&](const TraceEvent* first, const TraceEvent* last) {
    if (all || isEventful(first, last, before)) text += printCycle(trace.subject, first, last, all);
    before = first;
  });
  return text;
}

TEST_F(TraceTest, TellsWhyATransitionWasMade) {
  play();
  EXPECT_EQ(printed(recorded()),
            "100 ms\n"
            "  main(): search for 0 ms\n"
            "    stop()\n"
            "140 ms\n"
            "  main(): search -> approach\n"
            "      no:  seen && x < 0  (main.xabsl:25)\n"
            "           seen = true, x = 3\n"
            "      yes: seen && y > 2  (main.xabsl:27)\n"
            "           seen = true, y = 2.12346\n"
            "    sub(speed = 6, how = slow): go for 0 ms\n"
            "      walk(speed = 6, careful = false, style = slow)\n"
            "220 ms\n"
            "  main(): approach for 80 ms\n"
            "    sub(speed = 10, how = slow): go -> done (target)\n"
            "        yes: @speed >= 10  (main.xabsl:35)\n"
            "             @speed = 10\n"
            "      stop()\n");
  EXPECT_THAT(printed(recorded(), true), HasSubstr("result = 31\n"));
}

TEST_F(TraceTest, IsTheSameAfterWritingAndReading) {
  play();
  const Trace trace = recorded();
  const std::string text = toText(trace.subject) + toText(trace.events);
  const TraceReading reading = readTraces("a.trace", text + text + "c 3");
  ASSERT_EQ(test::errors(reading.diagnostics), "");
  ASSERT_EQ(reading.traces.size(), 2u);
  for (const Trace& read : reading.traces) {
    EXPECT_EQ(read.events, trace.events);  // the last line has no end: it was cut off
    EXPECT_EQ(printed(read, true), printed(trace, true));
    EXPECT_EQ(toText(read.subject), toText(trace.subject));
  }
}

TEST_F(TraceTest, IsReadAsOtherMachinesWriteIt) {
  play();
  const Trace trace = recorded();
  std::string other = "\xEF\xBB\xBF";
  for (const char c : toText(trace.subject) + toText(trace.events))
    other += c == '\n' ? "\r\n" : std::string(1, c);
  const TraceReading reading = readTraces("a.trace", other);
  ASSERT_EQ(test::errors(reading.diagnostics), "");
  EXPECT_EQ(reading.traces.at(0).events, trace.events);
}

TEST_F(TraceTest, IsReadInParts) {
  play();
  const Trace trace = recorded();
  const std::string events = toText(trace.events);
  const std::size_t half = events.find("\nc 180") + 1;
  Trace read = readTraces("a.trace", toText(trace.subject) + events.substr(0, half)).traces.at(0);
  EXPECT_LT(read.events.size(), trace.events.size());
  EXPECT_FALSE(readMore(read, "a.trace", events.substr(half)));
  EXPECT_EQ(read.events, trace.events);
  const auto wrong = readMore(read, "a.trace", "c 260\no 7 1\n");
  ASSERT_TRUE(wrong);
  EXPECT_THAT(wrong->message, HasSubstr("there is no option 7"));
  EXPECT_TRUE(readMore(read, "a.trace", toText(trace.subject)));
}

TEST_F(TraceTest, TellsWhatIsWrongInAFile) {
  const std::string text = toText(recorded().subject);
  const auto error = [](const std::string& wrong) {
    return test::errors(readTraces("a.trace", wrong).diagnostics);
  };
  const auto lines = std::to_string(std::count(text.begin(), text.end(), '\n') + 1);
  EXPECT_EQ(error(""), "a.trace: expected 'xabsl trace 1'\n");
  EXPECT_EQ(error("hello\n"), "a.trace:1:1: expected 'xabsl trace 1'\n");
  EXPECT_EQ(error("xabsl trace 1\n"), "a.trace:1:1: the trace ends before its cycles\n");
  EXPECT_EQ(error("xabsl trace 1\nstate 0 1 normal s3 a\n"),
            "a.trace:2:1: a state without an option\n");
  EXPECT_EQ(error("xabsl trace 1\nfile a\noption 0 1 d0 a\ncycles\n"),
            "a.trace:4:1: a decision tree leads to a decision that is not there: 0\n");
  EXPECT_EQ(error(text + "c x\n"), "a.trace:" + lines + ":1: 'x' is not a number\n");
  EXPECT_EQ(error(text + "o 0 1\n"), "a.trace:" + lines + ":1: expected a cycle\n");
  EXPECT_THAT(error(text + "c 1\no 2 1\n"), HasSubstr("there is no option 2"));
  EXPECT_THAT(error(text + "c 1\ng 0 nan\n"), HasSubstr("there is no such state"));
  EXPECT_THAT(error(text + "c 1\nz 0 1\n"), HasSubstr("'z' is no event"));
}

TEST_F(TraceTest, RemembersTheLastCyclesThatFit) {
  TraceRecorder small(56);
  engine->record(&small);
  play();
  const std::vector<TraceEvent> events = small.events();
  ASSERT_FALSE(events.empty());
  EXPECT_LE(events.size(), 56u);
  EXPECT_EQ(events.front(), (TraceEvent{TraceEvent::Kind::cycle, 0, 180}));
}

TEST_F(TraceTest, AllocatesNothingToRecord) {
  world.symbols.behavior("stop", [] {});
  world.symbols.output("result", &world.result);
  load(searching);
  engine->record(&recorder);
  world.seen = true;
  const long before = gt::allocations();
  for (int i = 0; i < 1000; ++i) engine->execute(i);
  EXPECT_EQ(gt::allocations(), before);
}

/// What a question about each cycle answers: `1`, `0`, or `-` where a value is unknown.
std::string answers(const Trace& trace, const std::string& expression) {
  Moment moment(trace.subject);
  Question::Making making =
      Question::make(moment, expression, {ValueKind::boolean, -1}, "question", {0, 1, 1});
  if (!making.question) return test::errors(making.diagnostics);
  std::string text;
  forEachCycle(trace.events, [&](const TraceEvent* first, const TraceEvent* last) {
    moment.take(first, last);
    const std::optional<double> answer = making.question->answer();
    text += answer ? (*answer != 0 ? "1" : "0") : "-";
  });
  return text;
}

TEST_F(TraceTest, AnswersQuestionsInXabsl) {
  play();
  const Trace trace = recorded();
  EXPECT_EQ(answers(trace, "main == approach"), "0111");
  EXPECT_EQ(answers(trace, "main == approach && main.previous == search"), "0100");
  EXPECT_EQ(answers(trace, "sub.active"), "0111");
  EXPECT_EQ(answers(trace, "sub == go && sub.speed > 5"), "0110");
  EXPECT_EQ(answers(trace, "sub.how == slow && sub.time >= 40"), "0011");
  EXPECT_EQ(answers(trace, "walk || stop"), "1111");
  EXPECT_EQ(answers(trace, "walk.speed == 6 && walk"), "0110");
  EXPECT_EQ(answers(trace, "seen"), "0111");
  EXPECT_EQ(answers(trace, "y > 2"), "-111");
  EXPECT_EQ(answers(trace, "result == 31"), "-110");
  EXPECT_EQ(answers(trace, "time > 150"), "0011");
  EXPECT_THAT(answers(trace, "main == aproach"), HasSubstr("did you mean 'approach'"));
  EXPECT_THAT(answers(trace, "y"), HasSubstr("question:1:1: value"));
  EXPECT_THAT(answers(trace, "y > 1; }"), HasSubstr("is no part of an expression"));
}

TEST_F(TraceTest, TellsWhatWasNeverCovered) {
  play();
  const Trace trace = recorded();
  Coverage coverage(trace.subject);
  coverage.add(trace.events);
  EXPECT_EQ(coverage.report(),
            "main.xabsl:30: never main: approach -> search if action_done\n"
            "main.xabsl:32: state main/home was never active\n"
            "main.xabsl:24: never main: any -> home if seen && x < 0\n"
            "4 of 5 states, 2 of 5 transitions\n");
  world.x = -1;
  recorder.clear();
  engine->execute(260);
  engine->execute(300);
  world.x = 1;
  engine->execute(340);
  coverage.add(recorder.events());
  EXPECT_EQ(coverage.report(),
            "main.xabsl:30: never main: approach -> search if action_done\n"
            "5 of 5 states, 4 of 5 transitions\n");
}

}  // namespace
}  // namespace xabsl
