#pragma once
#include <memory>
#include <string>

#include "match/MatchRobot.h"
#include "network/RobotAddresses.h"
#include "network/Wire.h"
#include "robot/Robot.h"

namespace gt {

/// Counts how well a remote robot keeps up with the simulation.
struct RemoteStatistics {
  std::int64_t frames = 0;          ///< Frames of 8 ms since it first gave commands.
  std::int64_t missedFrames = 0;    ///< Frames without new commands.
  std::int64_t pictures = 0;        ///< Images since its first message to its team.
  std::int64_t missedPictures = 0;  ///< Images without a new message to the team.
};

/// The hardware of a robot whose processes are programs of their own (report 2.2.3.1: no difference
/// between communication among processes and with the operating system): sends them the simulated
/// measurements and takes their commands. It never waits: a robot that does not answer keeps its
/// joints where they are.
class RemoteRobot : public MatchRobot {
 public:
  /// Listens for the robot's processes, which its layout names; beyond this machine with keys.
  static Result<std::unique_ptr<RemoteRobot>> make(const RobotAddresses& addresses,
                                                   const Plan& plan,
                                                   const std::optional<Keys>& keys);

  void cycle(const RobotInput& input, RobotOutput& output) override;
  Image* nextImage() override { return &std::get<SentPackage<Image>>(inputs_).value; }
  const Image* lastImage() const override { return &std::get<SentPackage<Image>>(inputs_).value; }

  /// Whether it has given commands in the last two seconds.
  bool isOn() const override;
  const std::string& name() const { return name_; }
  const RemoteStatistics& statistics() const { return statistics_; }

 private:
  RemoteRobot();
  /// Receives a package from the process that sends it. Returns false if no process does.
  template <typename T>
  bool receive(ReceivedPackage<T>& in, const Plan& plan);
  template <typename T>
  ReceivedPackage<T>& received() {
    return std::get<ReceivedPackage<T>>(commands_);
  }
  void send(const RobotInput& input);
  void takeCommands(const RobotInput& input, RobotOutput& output);
  // Take a received command, if there is one, and pass it to the body if it is valid.
  template <typename T>
  void take(T& command, const RobotInput& input);
  void take(JointData& joints, const RobotInput& input);
  void take(OdometryData& odometry, const RobotInput& input);
  void take(std::optional<TeamMessage>& message, const RobotInput& input);
  void take(std::optional<CameraSettings>& settings, const RobotInput& input);

  std::string name_;
  Network network_;
  Wire wire_;
  InputSlots<SentPackage> inputs_;
  CommandSlots<ReceivedPackage> commands_;
  std::optional<CameraSettings> camera_;  ///< The settings that the robot sent last.
  BeliefSlots<ReceivedPackage> believed_;
  Pose2D walked_;  ///< By the robot's odometry, in its last message.
  Time walkedAt_ = never();
  Time now_, commandedAt_ = never();
  std::int64_t images_ = 0;
  bool newMessage_ = false;
  RemoteStatistics statistics_;
};

}  // namespace gt
