#pragma once
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "base/DataRoot.h"
#include "colors/ColorTableFile.h"
#include "framework/Blackboard.h"
#include "framework/SolutionTable.h"
#include "representations/infrastructure/CameraSettings.h"
#include "representations/infrastructure/Player.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "robot/ConfigFolder.h"

namespace gt {

struct Behavior;
struct BehaviorRequest;
struct ConfigurationPart;
struct MotionNet;
struct RobotModules;

/// The folders and files that a configuration is read from.
struct ConfigurationPaths {
  std::string config = "config";                   ///< Folder.
  std::string motions = "motions";                 ///< Folder of `.mof` files.
  std::string behavior = "behavior/GT2003.xabsl";  ///< The agents file.
  std::string colorTable{};  ///< Instead of the folder's coltable.c64, if not empty.
  ColorClassOrder colorOrder = gt2003ColorOrder;  ///< Of the color table's classes.
  std::string location{};  ///< Instead of that in location.cfg, if not empty.

  /// Those of a root; the defaults are those of the working directory.
  static ConfigurationPaths in(const DataRoot& root) {
    return {root.path("config"), root.path("motions"), root.path("behavior/GT2003.xabsl")};
  }
};

/// Where the files of a configuration are.
struct ConfigurationFiles {
  ConfigurationPaths paths;
  ConfigFolder folder{"", ""};
};

/// What a robot reads from files when it starts (report B.4), loaded once and shared by all robots
/// that have the same. In the configuration folder:
///
///     location.cfg               the folder in this one whose files win (report B.4.1)
///     field.cfg                  FieldDimensions
///     dimensions.cfg             RobotDimensions
///     robot.cfg                  RobotCalibration of each robot by hardware address (B.4.5)
///     camera.cfg                 CameraSettings, for each robot if wanted (B.4.3)
///     coltable.c64               ColorTable64 (report B.4.2)
///     coltable.hsi               HsiColors, of which the color table is made instead (J.6.2)
///     coltable.tsl               TslColors (report J.6.3)
///     potentialfields.cfg        PotentialFields (report 3.8.3)
///     targets.cfg                TargetPoints (report 4.2)
///     values.cfg                 PlayValues
///     modules.cfg                the solution of each task
///     modules/TASK.SOLUTION.cfg  the parameters of that solution
///     log.cfg                    what is recorded
///
/// Every file but one of coltable.c64 and coltable.hsi may be missing: then the defaults hold. What
/// none of a program's modules reads is not loaded, and null (ConfigurationPart). Who the robot is
/// and how it is reached are its program's matter: `loadPlayer`, `loadNetwork`.
struct Configuration {
  /// A line of modules.cfg.
  struct SolutionChoice {
    std::string task, solution, file;
    int line;
  };
  /// log.cfg: what a robot's log holds.
  struct LogSettings {
    std::vector<std::string> representations;
    std::string file;                  ///< For messages.
    std::map<std::string, int> lines;  ///< In which each representation stands.
    std::int64_t imagePeriod = 0;      ///< ms; 0 for no images

    /// The error of a representation that the robot does not have.
    Error missing(const std::string& representation) const;
  };
  /// A file of the folder modules/.
  struct ParameterFile {
    std::string task, solution, path, text;
  };

  std::vector<SolutionChoice> solutions;
  std::vector<ParameterFile> parameters;
  LogSettings log;
  std::vector<const ConfigurationPart*> parts;  ///< That were read.
  ConfigurationFiles files;

  /// A part that is the same for all robots; null if it was not read.
  template <typename T>
  const T* find() const {
    const auto found = values_.find(&representation<T>());
    return found == values_.end() ? nullptr : static_cast<const T*>(found->second.get());
  }
  /// One that was read.
  template <typename T>
  const T& get() const {
    const T* const value = find<T>();
    if (!value) violate(std::string{typeName<T>()} + " was not read from the configuration");
    return *value;
  }
  template <typename T>
  void set(T value) {
    values_[&representation<T>()] = std::make_shared<T>(std::move(value));
  }
  /// A part of which each robot may have its own.
  template <typename T>
  PerRobot<T>& perRobot() {
    return std::get<PerRobot<T>>(perRobot_);
  }
  /// That of the robot with a hardware address.
  template <typename T>
  const T& of(const std::string& address) const {
    return std::get<PerRobot<T>>(perRobot_).of(address);
  }
  /// Lays the shared values on a blackboard, and those of the robot with a hardware address.
  void share(Blackboard& blackboard, const std::string& address) const;
  /// Lays one of them there.
  void share(const ConfigurationPart& part, Blackboard& blackboard,
             const std::string& address) const;

 private:
  std::map<const RepresentationType*, std::shared_ptr<void>> values_;
  std::tuple<PerRobot<RobotCalibration>, PerRobot<CameraSettings>> perRobot_;
};

/// Compiles a behavior and links it with what this robot offers; the first error states file, line
/// and column. Without texts it is read from the file.
Result<Behavior> loadBehavior(const BehaviorRequest& request, const MotionNet& motions);
/// A request with the texts of a behavior: those of its file and of all that this includes.
Result<BehaviorRequest> readBehaviorTexts(const std::string& file);

/// Reads all parts that are in `wanted`, or all that the modules know; the first error states file,
/// line and field. Names of solutions are checked where there are solutions of the task.
Result<std::shared_ptr<const Configuration>> loadConfiguration(
    const ConfigurationPaths& paths, const RobotModules& modules,
    const std::vector<const RepresentationType*>* wanted = nullptr);
/// For programs that hold all solutions.
Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths);

/// The same, but reads on after an error and returns all; warnings are about what is not used. What
/// could be read is stored in `configuration`, if that is given.
Findings checkConfiguration(const ConfigurationPaths& paths, const RobotModules& modules,
                            std::shared_ptr<const Configuration>* configuration = nullptr);

/// player.cfg and network.cfg of a robot's own program; each may be missing.
Result<Player> loadPlayer(const std::string& configFolder);
Result<NetworkSettings> loadNetwork(const std::string& configFolder);

}  // namespace gt
