#pragma once
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "streams/Config.h"

namespace gt {

/// The folder of configuration files with its location (report B.4.1): files in the location's
/// folder take precedence over the common ones.
class ConfigFolder {
 public:
  /// Reads `location.cfg`, which contains the name of a subfolder. Without it, or if it is empty,
  /// only the common files are used.
  static Result<ConfigFolder> open(const std::string& folder);
  /// Uses the given location instead of that in location.cfg; empty for none.
  ConfigFolder(std::string folder, std::string location)
      : folder_{std::move(folder)}, location_{std::move(location)} {}

  /// The path that a file is read from; the file may be missing.
  std::string path(const std::string& file) const;
  /// The paths of the common file and of the location's file; either may be missing.
  std::vector<std::string> paths(const std::string& file) const;
  const std::string& location() const { return location_; }

 private:
  std::string folder_, location_;
};

/// Parses the content of location.cfg: one word, the name of a folder, or nothing.
Result<std::string> parseLocation(std::string_view text, const std::string& file);

/// A value that may be different for each robot, by hardware address.
template <typename T>
struct PerRobot {
  T common;
  std::map<std::string, T> own;

  const T& of(const std::string& address) const {
    const auto found = own.find(address);
    return found == own.end() ? common : found->second;
  }
};

/// Whether a text is a hardware address in the format of robot.cfg: 12 digits, 00022D1F626B.
bool isHardwareAddress(std::string_view text);

/// Returns the sections of a text in the config format. Reports sections that are not hardware
/// addresses or occur twice.
std::vector<std::string> robotAddresses(std::string_view text, const std::string& file,
                                        Findings& findings);

/// Reads text in the config format: the lines before the first section are valid for all robots, a
/// section [ADDRESS] for one (report B.4.5). Returns all errors. After an error the value is
/// unchanged.
template <Streamable T>
Findings collectPerRobot(std::string_view text, const std::string& file, PerRobot<T>& value) {
  PerRobot<T> read{value.common, {}};
  Findings findings = collectConfig(text, file, read.common, {.common = true});
  for (const std::string& address : robotAddresses(text, file, findings)) {
    T& own = read.own[address] = read.common;
    findings.add(collectConfig(text, file, own, {.section = address}));
  }
  if (findings.empty()) value = std::move(read);
  return findings;
}

/// The network settings of a robot's program: the robot's name and its endpoints.
struct NetworkSettings {
  std::string robot = "robot";
  std::string address;
  std::string tools;
  std::string keys;
  std::string connectKeys;
  std::vector<std::string> processes;

  static constexpr auto fields() {
    return Fields{
        field<&NetworkSettings::robot>("name of the robot"),
        field<&NetworkSettings::address>(
            "hardware address of the robot; empty: that of the machine's first network interface"),
        field<&NetworkSettings::tools>("endpoint for tools and the router, such as "
                                       "tcp://127.0.0.1:15001; empty: local sockets only"),
        field<&NetworkSettings::keys>("key file for listening"),
        field<&NetworkSettings::connectKeys>("key file for connecting"),
        field<&NetworkSettings::processes>(
            "endpoints of processes on other machines, such as Motion=tcp://10.0.1.100:5001")};
  }
};

}  // namespace gt
