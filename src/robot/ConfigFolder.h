#pragma once
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "streams/Config.h"

namespace gt {

/// The folder of configuration files with its location (report B.4.1): a file of the location's
/// folder wins over the common one.
class ConfigFolder {
 public:
  /// Reads `location.cfg`, which holds the name of a folder in this one; without it, or if it is
  /// empty, there are the common files only.
  static Result<ConfigFolder> open(const std::string& folder);
  /// With a given location instead of that in location.cfg; empty for none.
  ConfigFolder(std::string folder, std::string location)
      : folder_{std::move(folder)}, location_{std::move(location)} {}

  /// Where a file is read from; it may be missing.
  std::string path(const std::string& file) const;
  /// The common file, and the location's; either may be missing.
  std::vector<std::string> paths(const std::string& file) const;
  const std::string& location() const { return location_; }

 private:
  std::string folder_, location_;
};

/// The one word of location.cfg, the name of a folder, or nothing.
Result<std::string> parseLocation(std::string_view text, const std::string& file);

/// A value that robots may have in their own way, by their hardware addresses.
template <typename T>
struct PerRobot {
  T common;
  std::map<std::string, T> own;

  const T& of(const std::string& address) const {
    const auto found = own.find(address);
    return found == own.end() ? common : found->second;
  }
};

/// Whether a text is a hardware address as robot.cfg has it: 12 digits, 00022D1F626B.
bool isHardwareAddress(std::string_view text);

/// The sections of a text in the config format; reports those that are no hardware addresses or
/// come twice.
std::vector<std::string> robotAddresses(std::string_view text, const std::string& file,
                                        Findings& findings);

/// Reads text in the config format: what stands before the first section holds for all robots, a
/// section [ADDRESS] for one (report B.4.5). Returns all errors; if there is one, the value stays
/// as it was.
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

/// The config files of a robot's own program: who it is and how it is reached.
struct NetworkSettings {
  std::string robot = "robot";
  std::string address;
  std::string tools;
  std::string keys;
  std::string connectKeys;
  std::vector<std::string> processes;

  static constexpr auto fields() {
    return Fields{
        field<&NetworkSettings::robot>("the robot's name"),
        field<&NetworkSettings::address>(
            "hardware address; empty: that of the machine's first network interface"),
        field<&NetworkSettings::tools>(
            "where tools and the router connect: tcp://127.0.0.1:15001; empty: on this machine"),
        field<&NetworkSettings::keys>("key file for listening"),
        field<&NetworkSettings::connectKeys>("key file for connecting"),
        field<&NetworkSettings::processes>(
            "where processes listen on other machines: Motion=tcp://10.0.1.100:5001")};
  }
};

}  // namespace gt
