#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/ChildProgram.h"
#include "base/TemporaryFolder.h"
#include "network/Keys.h"
#include "support/OtherMachine.h"

namespace gt::testing {

/// A robot that consists of programs on another machine (OtherMachine), where a simulator is its
/// body. Only its port for tools can be reached from here, with a key.
class RobotElsewhere {
 public:
  /// `programs` is the folder of simgt and gtrobot-*, the working directory that of the data.
  explicit RobotElsewhere(const std::string& programs, const std::string& robot = "red3",
                          const std::string& scene = "scenes/match.scene")
      : made_{static_cast<bool>(makeKeys(folder()))} {
    simulator_ =
        start({programs + "/simgt", "play", scene, "--remote", robot, "--sockets",
               folder() + "/sockets", "--minutes", "60", "--no-logs", "--out", folder() + "/out"});
    for (const char* process : {"cognition", "motion", "debug"}) {
      std::vector<std::string> words{programs + "/gtrobot-" + process,
                                     "--robot=" + robot,
                                     "--team=red",
                                     "--role=striker1",
                                     "--sockets=" + folder() + "/sockets",
                                     "--crashes=" + folder()};
      if (std::string{process} == "debug")
        words.insert(words.end(), {"--tools=" + endpoint(), "--keys=" + folder() + "/robot.key"});
      processes_.push_back(start(words));
    }
  }

  /// False if no keys could be made: nothing runs then that could be reached.
  bool made() const { return made_; }
  const OtherMachine& machine() const { return machine_; }
  /// The machine's address, as the console's `sc` and the router take it.
  const std::string& address() const { return machine_.there(); }
  /// Where tools connect, and the file of the key that they need.
  std::string endpoint() const { return "tcp://" + address() + ":15000"; }
  std::string key() const { return folder() + "/tool.key"; }
  /// Cognition, Motion and Debug.
  const std::vector<std::unique_ptr<ChildProgram>>& processes() const { return processes_; }
  ChildProgram& simulator() { return *simulator_; }

 private:
  std::unique_ptr<ChildProgram> start(const std::vector<std::string>& words) {
    return std::make_unique<ChildProgram>(machine_.command(words));
  }
  std::string folder() const { return folder_.path().string(); }

  const TemporaryFolder folder_;
  const OtherMachine machine_;
  bool made_;
  std::unique_ptr<ChildProgram> simulator_;
  std::vector<std::unique_ptr<ChildProgram>> processes_;
};

}  // namespace gt::testing
