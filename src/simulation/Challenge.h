#pragma once
#include <string>
#include <vector>

#include "base/Random.h"
#include "simulation/Simulation.h"
#include "simulation/parameters/ChallengeParameters.h"

namespace gt {

/// Leads and scores a technical challenge of 2003 (report, chapter 4; facts 2.3). Puts robots and
/// balls at random places if the scene asks for that, presses the robot's back switch at the start,
/// and watches until the task is done or the scene's time is over. Only the first robot is scored.
class Challenge final : public SceneController {
 public:
  /// An event of the challenge, described in one line.
  struct Note {
    Time time;
    std::string text;
  };
  /// A place to be visited.
  struct Target {
    Vector2d place;  ///< mm, on the field.
    /// From the place to where the robot wagged its tail (mm); negative if it did not.
    double distance = -1;
    int points = 0;
  };

  /// `targets` are the places (mm, on the field) of the localization challenge.
  Challenge(const ChallengeParameters& parameters, const std::vector<Vector2d>& targets,
            const Random& random);

  void control(Simulation& simulation) override;

  const ChallengeParameters& parameters() const { return parameters_; }
  bool finished() const { return finished_; }
  /// Whether the task was done: the ball is in the goal, all places were visited, the other goal
  /// was reached.
  bool succeeded() const { return succeeded_; }
  /// Time from the start until the task was done, or until now (s).
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
  std::vector<Pose2D> stood_;  ///< Poses of all robots at the start, or at the last contact.
  Time touchedAt_ = never();
  int contacts_ = 0;
  // The tour.
  double tail_ = 0, swung_ = 0;  ///< rad
  Pose2D restsAt_;
  Time restsSince_ = never();
  bool scored_ = false;
};

/// Five random targets of the localization challenge (mm, on the field), each reachable for a
/// robot.
std::vector<Vector2d> randomTargets(const FieldDimensions& field, Random random);

}  // namespace gt
