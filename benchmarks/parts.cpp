// How long small pieces of the system take that run often.
#include "Parts.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "framework/Module.h"
#include "modules/behavior/control/GT2003BehaviorControl.h"
#include "modules/behavior/testing/ImaginedWorld.h"
#include "representations/modeling/BallModel.h"
#include "representations/perception/BallPercept.h"
#include "robot/Configuration.h"
#include "simulation/world/World.h"

namespace gt {
namespace {

DataRoot rootOfParts;  // they are registered before main() begins

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
  const auto configuration = loadConfiguration(ConfigurationPaths::in(dataRoot()));
  if (!configuration) throw std::runtime_error(configuration.error().text());
  GT2003BehaviorControl control;
  ImaginedWorld world;
  world.field = (*configuration)->get<FieldDimensions>();
  world.motions = (*configuration)->get<MotionNet>();
  world.game.state = GameState::playing;
  world.ball.position = {1000, 0};
  MotionRequest motion;
  HeadControlMode head;
  LedRequest leds;
  SoundRequest sound;
  BehaviorTeamMessage message;
  Debug debug;
  for ([[maybe_unused]] auto _ : state) {
    world.ball.lastSeen = world.frame.time = world.frame.time + 40;
    control.update(world.state(), (*configuration)->get<Behavior>(), {}, motion, head, leds, sound,
                   message, debug);
  }
}

/// Eight robots that walk, each with all joints in motion, and a ball among them.
void kinematicWorld(benchmark::State& state) {
  auto scene = loadScene(dataRoot().path("scenes/match.scene"));
  if (!scene) throw std::runtime_error(scene.error().text());
  scene->balls.resize(static_cast<std::size_t>(state.range(0)));
  auto world = makeWorld(*scene, Random{1});
  if (!world) throw std::runtime_error(world.error().text());
  std::vector<RobotCommand> commands(scene->robots.size());
  double phase = 0;
  for ([[maybe_unused]] auto _ : state) {
    phase += 0.1;
    for (RobotCommand& command : commands) {
      for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
        command.joints[legJoint(leg, 1)] = -0.4 + 0.2 * std::sin(phase);
        command.joints[legJoint(leg, 2)] = 0.14;
        command.joints[legJoint(leg, 3)] = 1.3 + 0.2 * std::cos(phase);
      }
      command.step = {0.01, 1, 0};  // in circles of 100 mm radius
    }
    (*world)->step(commands);
  }
}

BENCHMARK(kinematicWorld)->Name("speed.world.kinematic")->Arg(0)->Apply(inMicroseconds);
BENCHMARK(kinematicWorld)->Name("speed.world.kinematicBall")->Arg(1)->Apply(inMicroseconds);
BENCHMARK(xabslCycle)->Name("speed.xabsl.cycle")->Apply(inMicroseconds);
BENCHMARK(inactiveDebugKey)->Name("speed.debug.inactiveKey")->Apply(inNanoseconds);
BENCHMARK(moduleCall)->Name("speed.framework.call")->Apply(inNanoseconds);

}  // namespace

const DataRoot& dataRoot() {
  return rootOfParts;
}

std::size_t measureParts(Figures& figures, const std::string& only, const DataRoot& root) {
  rootOfParts = root;
  FigureReporter reporter{figures};
  const std::size_t count = benchmark::RunSpecifiedBenchmarks(&reporter, only);
  // Each with the bare means of those that do the same (processes.cpp).
  const std::string process = "speed.process.";
  for (const auto& [figure, bare, aim] : {std::tuple{"cycle", "zeromq.bare", 1.2},
                                          {"zeromq.wire", "zeromq.bareLooking", 1.2},
                                          {"ipc.wire", "ipc.bareUnixSocket", 1.0}})
    figures.addRatio(process + figure + ".ratio", process + figure, process + bare,
                     Aim::atMost(aim));
  // The grid is there so that not all pixels have to be looked at.
  figures.addRatio("speed.vision.classifyAll.ratio", "speed.vision.gt2003",
                   "speed.vision.classifyAll", Aim::atMost(1));
  figures.addRatio("speed.vision.opencv.ratio", "speed.vision.opencv", "speed.vision.gt2003",
                   Aim::atLeast(30));
  figures.addRatio("speed.vision.blackWhiteBall.ofOpenCv", "speed.vision.blackWhiteBall",
                   "speed.vision.blackWhiteBall.opencv", Aim::atMost(0.1));
  return count;
}

}  // namespace gt
