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
  std::string colorTable{};  ///< Used instead of the folder's coltable.c64, if not empty.
  ColorClassOrder colorOrder = gt2003ColorOrder;  ///< Order of the class numbers in the color
                                                  ///< table.
  std::string location{};  ///< Used instead of that in location.cfg, if not empty.

  /// The paths in a root; the default paths are in the working directory.
  static ConfigurationPaths in(const DataRoot& root) {
    return {root.path("config"), root.path("motions"), root.path("behavior/GT2003.xabsl")};
  }
};

/// The paths of a configuration's files.
struct ConfigurationFiles {
  ConfigurationPaths paths;
  ConfigFolder folder{"", ""};
};

/// The data that a robot reads from files when it starts (report B.4), loaded once and shared by
/// all robots with the same configuration. Files in the configuration folder:
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
/// Every file may be missing, except one of coltable.c64 and coltable.hsi; then the defaults are
/// used. Parts that none of a program's modules reads are not loaded, and null (ConfigurationPart).
/// The robot's identity and endpoints are read by its program: `loadPlayer`, `loadNetwork`.
struct Configuration {
  /// A line of modules.cfg.
  struct SolutionChoice {
    std::string task, solution, file;
    int line;
  };
  /// log.cfg: the content of a robot's log.
  struct LogSettings {
    std::vector<std::string> representations;
    std::string file;                  ///< For messages.
    std::map<std::string, int> lines;  ///< Line number of each representation.
    std::int64_t imagePeriod = 0;      ///< Time between images, in ms; 0 for no images.

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
  std::vector<const ConfigurationPart*> parts;  ///< The parts that were read.
  ConfigurationFiles files;

  /// Returns a part that is the same for all robots; null if it was not read.
  template <typename T>
  const T* find() const {
    const auto found = values_.find(&representation<T>());
    return found == values_.end() ? nullptr : static_cast<const T*>(found->second.get());
  }
  /// Returns a part that was read.
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
  /// Returns a part that may be different for each robot.
  template <typename T>
  PerRobot<T>& perRobot() {
    return std::get<PerRobot<T>>(perRobot_);
  }
  /// Returns a part's value for the robot with a hardware address.
  template <typename T>
  const T& of(const std::string& address) const {
    return std::get<PerRobot<T>>(perRobot_).of(address);
  }
  /// Puts the shared values on a blackboard, and the values for the robot with a hardware address.
  void share(Blackboard& blackboard, const std::string& address) const;
  /// Puts one part on a blackboard.
  void share(const ConfigurationPart& part, Blackboard& blackboard,
             const std::string& address) const;

 private:
  std::map<const RepresentationType*, std::shared_ptr<void>> values_;
  std::tuple<PerRobot<RobotCalibration>, PerRobot<CameraSettings>> perRobot_;
};

/// Compiles a behavior and links it with the symbols and skills of this robot. The first error
/// states file, line and column. A request without texts is read from the file.
Result<Behavior> loadBehavior(const BehaviorRequest& request, const MotionNet& motions);
/// Makes a request with the texts of a behavior: its file and all included files.
Result<BehaviorRequest> readBehaviorTexts(const std::string& file);

/// Reads all parts in `wanted`, or all parts that the modules know. The first error states file,
/// line and field. Names of solutions are checked for tasks that have solutions.
Result<std::shared_ptr<const Configuration>> loadConfiguration(
    const ConfigurationPaths& paths, const RobotModules& modules,
    const std::vector<const RepresentationType*>* wanted = nullptr);
/// Like the function above, for programs that contain all solutions.
Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths);

/// Like loadConfiguration, but continues after errors and returns all of them. Unused entries are
/// warnings. The data that could be read is stored in `configuration`, if given.
Findings checkConfiguration(const ConfigurationPaths& paths, const RobotModules& modules,
                            std::shared_ptr<const Configuration>* configuration = nullptr);

/// Read player.cfg and network.cfg of a robot's own program; each may be missing.
Result<Player> loadPlayer(const std::string& configFolder);
Result<NetworkSettings> loadNetwork(const std::string& configFolder);

}  // namespace gt
