#include "gtlog/SolutionErrors.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "base/Statistics.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/perception/BallPercept.h"

namespace gt {
namespace {

bool gameRuns(GameState state) {
  return state == GameState::ready || state == GameState::set || state == GameState::playing;
}

/// Adds how wrong the robot is now.
void measure(const Robot& robot, const OracledWorldState& truth, SolutionErrors& errors) {
  if (const auto* pose = robot.provided<RobotPose>()) {
    errors.position.push_back((pose->pose.translation - truth.robotPose.translation).norm());
    errors.rotation.push_back(std::abs(normalize(pose->pose.rotation - truth.robotPose.rotation)));
  }
  const auto* percept = robot.provided<BallPercept>();
  const auto* ball = robot.provided<BallModel>();
  if (ball && percept && percept->seen)
    errors.ball.push_back((ball->position - relative(truth.robotPose, truth.ballPosition)).norm());
}

Result<SolutionErrors> errorsOf(const ReplayOptions& options, const std::string& solution) {
  auto platform = ReplayPlatform::make(options);
  if (!platform) return platform.error();
  SolutionErrors errors{solution, {}, {}, {}};
  std::optional<OracledWorldState> truth;
  bool runs = true, anyTruth = false;
  platform->onInput([&](Time, const RepresentationType& type, const void* package) {
    if (&type == &representation<GameControlData>())
      runs = gameRuns(static_cast<const GameControlData*>(package)->state);
    if (&type == &representation<OracledWorldState>())
      truth = *static_cast<const OracledWorldState*>(package);
  });
  for (;;) {
    truth.reset();
    const auto more = platform->step();
    if (!more) return more.error();
    if (!*more) break;
    platform->robot().toTools().clear();
    anyTruth |= truth.has_value();
    if (truth && runs) measure(platform->robot(), *truth, errors);
  }
  if (anyTruth) return errors;
  return Error{.file = options.log,
               .field = "/" + std::string{representation<OracledWorldState>().name},
               .what = "the log does not hold the truth, which a simulator records"};
}

std::string meanAndMedian(const std::vector<double>& errors, double unit) {
  if (errors.empty()) return "-";
  return fmt::format("{:.1f} / {:.1f}", mean(errors) / unit, quantile(errors, 0.5) / unit);
}

}  // namespace

Result<std::vector<SolutionErrors>> compareSolutions(const ReplayOptions& options,
                                                     const std::string& task,
                                                     const std::vector<std::string>& solutions) {
  std::vector<SolutionErrors> all;
  for (const std::string& solution : solutions) {
    ReplayOptions chosen = options;
    chosen.solutions.push_back({task, solution, "", 0});
    auto errors = errorsOf(chosen, solution);
    if (!errors) return errors.error();
    all.push_back(std::move(*errors));
  }
  return all;
}

std::string tableOf(const std::string& task, const std::vector<SolutionErrors>& errors) {
  constexpr const char* line = "{:24} {:>7} {:>20} {:>18} {:>20} {:>7}\n";
  std::string text = "Mean / median distance to the truth, per image while the game runs\n\n";
  text += fmt::format(line, task, "images", "position, mm", "rotation, deg", "ball in sight, mm",
                      "images");
  for (const SolutionErrors& e : errors)
    text += fmt::format(line, e.solution, e.position.size(), meanAndMedian(e.position, 1),
                        meanAndMedian(e.rotation, fromDegrees(1)), meanAndMedian(e.ball, 1),
                        e.ball.size());
  return text;
}

}  // namespace gt
