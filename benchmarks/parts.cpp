// How long small pieces of the system take that run often.
#include "Parts.h"

#include <stdexcept>
#include <vector>

#include "framework/Module.h"
#include "modules/behavior/GT2003BehaviorControl.h"
#include "representations/modeling/BallModel.h"
#include "representations/perception/BallPercept.h"
#include "robot/Configuration.h"

namespace gt {
namespace {

/// Takes each part's repetitions over as a figure.
class FigureReporter : public benchmark::BenchmarkReporter {
 public:
  explicit FigureReporter(Figures& figures) : figures_{figures} {}

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    const Run& first = runs.front();
    const bool real = first.run_name.time_type == "real_time";
    std::vector<double> times;
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        times.push_back(real ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime());
    const auto aim = first.counters.find("aim");
    figures_.add(first.run_name.function_name, benchmark::GetTimeUnitString(first.time_unit), times,
                 aim == first.counters.end() ? Aim{} : Aim::atMost(aim->second));
  }

 private:
  Figures& figures_;
};

const DebugKey unused{"Benchmark/unused"};

void inactiveDebugKey(benchmark::State& state) {
  Debug debug;
  for ([[maybe_unused]] auto _ : state) {
    if (auto canvas = debug.onField(unused)) canvas.point({0, 0});
    benchmark::ClobberMemory();
  }
}

/// Does nothing, so that only the framework's work is left.
class IdleBallLocator {
 public:
  void update(const BallPercept&, Previous<BallModel>, BallModel& ball, Random&, Debug&) {
    benchmark::DoNotOptimize(&ball);
  }
};

void moduleCall(benchmark::State& state) {
  Blackboard blackboard;
  Debug debug;
  ModuleAdapter<IdleBallLocator> adapter{{blackboard, debug, Random{1}}};
  AnyModule* module = &adapter;
  benchmark::DoNotOptimize(module);
  for ([[maybe_unused]] auto _ : state) module->run();
}

/// The robots' whole behavior, in play, going to a ball ahead.
void xabslCycle(benchmark::State& state) {
  const auto configuration = loadConfiguration({});
  if (!configuration) throw std::runtime_error(configuration.error().text());
  GT2003BehaviorControl control;
  FrameInfo frame;
  GameControlData game;
  game.state = GameState::playing;
  BallModel ball;
  ball.position = {1000, 0};
  MotionRequest motion;
  HeadControlMode head;
  LedRequest leds;
  BehaviorTeamMessage message;
  Debug debug;
  for ([[maybe_unused]] auto _ : state) {
    ball.lastSeen = frame.time = frame.time + 40;
    control.update(frame, (*configuration)->behavior, {}, {}, *(*configuration)->field, game, {},
                   ball, {}, {}, {}, {}, motion, head, leds, message, debug);
  }
}

BENCHMARK(xabslCycle)->Name("speed.xabsl.cycle")->Apply(inMicroseconds);
BENCHMARK(inactiveDebugKey)->Name("speed.debug.inactiveKey")->Apply(inNanoseconds);
BENCHMARK(moduleCall)->Name("speed.framework.call")->Apply(inNanoseconds);

}  // namespace

void measureParts(Figures& figures) {
  FigureReporter reporter{figures};
  benchmark::RunSpecifiedBenchmarks(&reporter);
}

}  // namespace gt
