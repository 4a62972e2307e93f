#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/File.h"
#include "robot/Configuration.h"
#include "streams/Config.h"

namespace gt {

class ModuleProcess;

/// A part of the configuration: a representation that modules read, and the way it gets on their
/// blackboards. Each area of modules adds its own parts, so that a program links and reads only
/// those that its modules need.
struct ConfigurationPart {
  const RepresentationType* type;
  /// File in the configuration folder; empty if there is none.
  const char* file = "";
  /// Reads the part from files and adds errors to the findings.
  void (*read)(const ConfigurationPart& part, Configuration& configuration, Findings& findings);
  /// Puts the part on the blackboard of the robot with a hardware address; null: all robots share
  /// one value.
  void (*share)(const Configuration& configuration, const std::string& address,
                Blackboard& blackboard) = nullptr;
  /// Executes a message of the tools that replaces the part while the robot is running. Returns
  /// false if the message belongs to another part. Not required for the representation itself.
  bool (*handle)(const Message& message, ModuleProcess& process,
                 const ConfigurationFiles& files) = nullptr;
  /// Called after a tool has replaced the part or a field of it.
  void (*changed)(Blackboard& blackboard) = nullptr;
  /// The content of the file for a value; empty if the value needs no file. Null if tools do not
  /// write the file (RunningConfiguration.h).
  std::string (*text)(const void* value) = nullptr;
};

/// Reads a part from its file in the config format; the file may be missing.
template <typename T>
void readPart(const ConfigurationPart& part, Configuration& configuration, Findings& findings) {
  T value;
  const std::string file = configuration.files.folder.path(part.file);
  if (std::filesystem::exists(file)) {
    if (const auto text = readFile(file))
      findings.add(collectConfig(*text, file, value));
    else
      findings.add(text.error());
  }
  configuration.set(std::move(value));
}

/// The parts that all processes may read: the dimensions of field and robot, the robot's
/// calibration, the settings of the camera.
const std::vector<ConfigurationPart>& commonParts();

}  // namespace gt
