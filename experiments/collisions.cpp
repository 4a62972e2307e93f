// Measures how soon the collision detectors find that something holds a robot up, and how often
// they are wrong (report 3.6): in robots that walk about, and in matches.
#include <algorithm>

#include "ChangedRoot.h"
#include "CollisionWatch.h"
#include "Experiments.h"
#include "Profiles.h"
#include "modules/motion/collisions/MotorModelCollisionDetector.h"
#include "modules/motion/collisions/ReportCollisionDetector.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// What happened to the robots, and what the detector said.
struct Alarms {
  int collisions = 0, found = 0, falseAlarms = 0;
  double freeMinutes = 0;
};

/// A detector of one robot.
template <typename Detector>
class Watch {
 public:
  explicit Watch(const typename Detector::Parameters& parameters) {
    detector_.parameters = parameters;
  }

  void add(const CollisionFrame& frame, HoldUp::Ended ended, bool free, Alarms& alarms) {
    detector_.update(frame.sensors, frame.commanded, frame.motion, percept_, debug_);
    debug_.out().clear();
    const bool collision = percept_.collision();
    alarms.falseAlarms += free && collision && sinceAlarm_ > 0;
    alarms.freeMinutes += free ? tickSeconds / 60 : 0;
    sinceAlarm_ = collision ? 0 : sinceAlarm_ + 1;
    alarms.collisions += ended == HoldUp::Ended::collision;
    alarms.found += ended == HoldUp::Ended::collision && sinceAlarm_ < HoldUp::window;
  }

 private:
  Detector detector_;
  CollisionPercept percept_;
  Debug debug_{1024};
  int sinceAlarm_ = HoldUp::window;
};

/// Both detectors of each robot, fed with the same.
class DetectorWatches {
 public:
  Result<void> read(const DataRoot& root) {
    if (auto done =
            readConfig(root.path("config/modules/CollisionDetector.MotorModel.cfg"), model_);
        !done)
      return done;
    return readConfig(root.path("config/modules/CollisionDetector.Report.cfg"), report_);
  }

  void add(std::size_t robot, const CollisionFrame& frame) {
    while (robots_.size() <= robot) robots_.push_back(std::make_unique<Of>(model_, report_));
    Of& of = *robots_[robot];
    const HoldUp::Ended ended = of.holdUp.add(frame);
    of.model.add(frame, ended, of.holdUp.free(), ofModel_);
    of.report.add(frame, ended, of.holdUp.free(), ofReport_);
  }

  /// The figures of what has happened; all begins anew.
  void measure(const std::string& where, Measurement& measured) {
    const std::string group = "worldmodel.collisions." + where + '.';
    measured.add(group + "n", "collisions", ofModel_.collisions);
    measured.add(group + "freeMinutes", "min", ofModel_.freeMinutes);
    tell(group + "motorModel.", ofModel_, Aim::atLeast(85), Aim::atMost(0.5), measured);
    tell(group + "report.", ofReport_, {}, {}, measured);
    robots_.clear();
    ofModel_ = ofReport_ = {};
  }

 private:
  struct Of {
    Of(const MotorModelCollisionDetector::Parameters& ofModel,
       const ReportCollisionDetector::Parameters& ofReport)
        : model{ofModel}, report{ofReport} {}
    HoldUp holdUp;
    Watch<MotorModelCollisionDetector> model;
    Watch<ReportCollisionDetector> report;
  };

  static void tell(const std::string& group, const Alarms& alarms, const Aim& found,
                   const Aim& falseAlarms, Measurement& measured) {
    if (alarms.collisions > 0)
      measured.add(group + "foundSoon", "%", 100. * alarms.found / alarms.collisions, found);
    measured.add(group + "falseAlarms", "1/min",
                 alarms.falseAlarms / std::max(alarms.freeMinutes, 1e-9), falseAlarms);
  }

  MotorModelCollisionDetector::Parameters model_;
  ReportCollisionDetector::Parameters report_;
  std::vector<std::unique_ptr<Of>> robots_;
  Alarms ofModel_, ofReport_;
};

Result<Measurement> walkAndPlay(const Job& job, const DataRoot& root) {
  DetectorWatches watches;
  if (auto done = watches.read(root); !done) return done.error();
  const double minutes = job.number("minutes");
  const auto observe = [&](std::size_t robot, const CollisionFrame& frame) {
    watches.add(robot, frame);
  };
  Measurement measured;
  if (auto done = observeWalks(job, root, minutes, observe); !done) return done.error();
  watches.measure("walk", measured);
  if (auto done = observePlay(job, root, minutes, observe); !done) return done.error();
  watches.measure("play", measured);
  return measured;
}

}  // namespace

Experiment collisionExperiment() {
  return {"worldmodel.collisions",
          "How often the collision detectors find collisions, and how often they are wrong",
          {profileParameter(),
           fidelityParameter(),
           {"minutes", "of walking, and of a match", Parameter::Kind::number, {"2"}},
           valuesParameter()},
          withValues<walkAndPlay>};
}

}  // namespace gt
