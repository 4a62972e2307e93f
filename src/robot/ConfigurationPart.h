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

/// A part of the configuration: a representation that modules read, and how it gets on their
/// blackboards. Each area of modules brings its own, so that a program neither links nor reads what
/// none of its modules needs.
struct ConfigurationPart {
  const RepresentationType* type;
  /// Its file in the configuration's folder; empty if it has none.
  const char* file = "";
  /// Reads it from files; adds what is wrong with them.
  void (*read)(const ConfigurationPart& part, Configuration& configuration, Findings& findings);
  /// Lays it on the blackboard of a robot with a hardware address; null: all share one value.
  void (*share)(const Configuration& configuration, const std::string& address,
                Blackboard& blackboard) = nullptr;
  /// Carries out a message of the tools that replaces it while the robot runs; false if the message
  /// is another one's. The representation itself needs no such function.
  bool (*handle)(const Message& message, ModuleProcess& process,
                 const ConfigurationFiles& files) = nullptr;
  /// Called when a tool has replaced it or a field of it.
  void (*changed)(Blackboard& blackboard) = nullptr;
  /// What the file contains for a value; empty if the value needs none. Null if tools do not write
  /// it (RunningConfiguration.h).
  std::string (*text)(const void* value) = nullptr;
};

/// Reads a part from its file in the config format, which may be missing.
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

/// What all processes may read: the dimensions of field and robot, its calibration, how its camera
/// is set.
const std::vector<ConfigurationPart>& commonParts();

}  // namespace gt
