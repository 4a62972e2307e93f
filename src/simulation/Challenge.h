#pragma once
#include <string>
#include <vector>

#include "base/Random.h"
#include "simulation/Simulation.h"
#include "simulation/parameters/ChallengeParameters.h"

namespace gt {

/// Leads and scores a technical challenge of 2003 (report, chapter 4; facts 2.3): puts robots and
/// balls at random places if the scene asks for that, presses the robot's back switch at the start,
/// and watches until the task is done or the scene's time is over. It is about the first robot.
class Challenge final : public SceneController {
 public:
  /// What happened: one line for people.
  struct Note {
    Time time;
    std::string text;
  };
  /// A place to be visited.
  struct Target {
    Vector2d place;
    double distance = -1;  ///< mm, at which the robot wagged its tail; negative: it did not.
    int points = 0;
  };

  /// The targets are those of the localization challenge.
  Challenge(const ChallengeParameters& parameters, const std::vector<Vector2d>& targets,
            const Random& random);

  void control(Simulation& simulation) override;

  const ChallengeParameters& parameters() const { return parameters_; }
  bool finished() const { return finished_; }
  /// Whether the task was done: the ball is in the goal, all places were visited, the other goal
  /// was reached.
  bool succeeded() const { return succeeded_; }
  /// From the start until the task was done, or until now.
  double seconds() const { return static_cast<double>(ended_ - started_) / 1000; }
  /// How often the robot touched another one.
  int contacts() const { return contacts_; }
  const std::vector<Target>& targets() const { return targets_; }
  int points() const;
  const std::vector<Note>& notes() const { return notes_; }

 private:
  void prepare(Simulation& simulation);
  void prepareCourse(World& world);
  void watchBall(Simulation& simulation);
  void watchTour(Simulation& simulation);
  void watchCourse(Simulation& simulation);
  bool touchesOther(const World& world) const;
  void note(Time now, std::string text) { notes_.push_back({now, std::move(text)}); }
  void finish(Time now, const std::string& text);

  ChallengeParameters parameters_;
  std::vector<Target> targets_;
  Random random_;
  FieldDimensions field_;
  std::vector<Note> notes_;
  bool prepared_ = false, finished_ = false, succeeded_ = false;
  Time started_, ended_;
  // Contacts.
  std::vector<Pose2D> stood_;  ///< Where the obstacles stood.
  Time touchedAt_ = never();
  int contacts_ = 0;
  // The tour.
  double tail_ = 0, swung_ = 0;  ///< rad
  Pose2D restsAt_;
  Time restsSince_ = never();
  bool scored_ = false;
};

/// Random places on the field, each reachable for a robot: five targets of the localization
/// challenge.
std::vector<Vector2d> randomTargets(const FieldDimensions& field, Random random);

}  // namespace gt
