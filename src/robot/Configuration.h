#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "colors/ColorTableFile.h"
#include "colors/TslColors.h"
#include "framework/Blackboard.h"
#include "framework/SolutionTable.h"
#include "modules/behavior/control/Behavior.h"
#include "modules/behavior/control/BehaviorRequest.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "representations/infrastructure/CameraSettings.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "representations/perception/ColorTable64.h"
#include "robot/ConfigFolder.h"

namespace gt {

/// What a robot reads from files when it starts (report B.4), loaded once and shared by all robots
/// that have the same. In the configuration folder:
///
///     location.cfg               the folder in this one whose files win (report B.4.1)
///     field.cfg                  FieldDimensions
///     dimensions.cfg             RobotDimensions
///     robot.cfg                  RobotCalibration of each robot by hardware address (B.4.5)
///     camera.cfg                 CameraSettings, for each robot if wanted (B.4.3)
///     coltable.c64               ColorTable64 (report B.4.2)
///     coltable.tsl               TslColors (report J.6.3)
///     modules.cfg                the solution of each task
///     modules/TASK.SOLUTION.cfg  the parameters of that solution
///     log.cfg                    what is recorded
///
/// Every file but coltable.c64 may be missing: then the defaults hold. Who the robot is and how it
/// is reached are its program's matter: `loadPlayer`, `loadNetwork`.
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
    std::int64_t picturePeriod = 0;    ///< ms; 0 for no pictures

    /// The error of a representation that the robot does not have.
    Error missing(const std::string& representation) const;
  };
  /// A file of the folder modules/.
  struct ParameterFile {
    std::string task, solution, path, text;
  };

  std::shared_ptr<FieldDimensions> field;
  std::shared_ptr<RobotDimensions> robot;
  PerRobot<RobotCalibration> calibration;
  PerRobot<CameraSettings> camera;
  std::shared_ptr<ColorTable64> colorTable;
  std::shared_ptr<TslColors> tslColors;
  std::shared_ptr<MotionNet> motions;
  Behavior behavior;  ///< Each robot has its own: it may be edited while it runs.
  std::vector<SolutionChoice> solutions;
  std::vector<ParameterFile> parameters;
  LogSettings log;

  /// Lays the shared values on a blackboard, and those of the robot with a hardware address.
  void share(Blackboard& blackboard, const std::string& address) const;
  static std::vector<const RepresentationType*> representations();
};

/// Compiles a behavior and links it with what this robot offers; the first error tells file, line
/// and column.
Result<Behavior> loadBehavior(const BehaviorRequest& request, const MotionNet& motions);

/// The folders and files that a configuration is read from.
struct ConfigurationPaths {
  std::string config = "config";                   ///< Folder.
  std::string motions = "motions";                 ///< Folder of `.mof` files.
  std::string behavior = "behavior/GT2003.xabsl";  ///< The agents file.
  std::string colorTable{};  ///< Instead of the folder's coltable.c64, if not empty.
  ColorClassOrder colorOrder = gt2003ColorOrder;  ///< Of the colour table's classes.
  std::string location{};  ///< Instead of what location.cfg says, if not empty.

  /// Those of a root; the defaults are those of the working directory.
  static ConfigurationPaths in(const DataRoot& root) {
    return {root.path("config"), root.path("motions"), root.path("behavior/GT2003.xabsl")};
  }
};

/// Reads everything; the first error tells file, line and field. Names of solutions are checked
/// where the table holds solutions of the task.
Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths,
                                                               const SolutionTable& table);
/// For programs that hold all solutions.
Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths);

/// The same, but reads on after an error and returns all; warnings are about what is not used. What
/// could be read is stored in `configuration`, if that is given.
Findings checkConfiguration(const ConfigurationPaths& paths, const SolutionTable& table,
                            std::shared_ptr<const Configuration>* configuration = nullptr);

/// player.cfg and network.cfg of a robot's own program; each may be missing.
Result<Player> loadPlayer(const std::string& configFolder);
Result<NetworkSettings> loadNetwork(const std::string& configFolder);

}  // namespace gt
