#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"
#include "representations/infrastructure/CameraInfo.h"
#include "representations/infrastructure/Player.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/parameters/BallParameters.h"
#include "simulation/parameters/BodyParameters.h"
#include "simulation/parameters/CeilingCameraParameters.h"
#include "simulation/parameters/ChallengeParameters.h"
#include "simulation/parameters/DynamicsParameters.h"
#include "simulation/parameters/GameParameters.h"
#include "simulation/parameters/NoiseParameters.h"
#include "simulation/parameters/RadioParameters.h"
#include "simulation/parameters/RuleParameters.h"
#include "simulation/parameters/WalkingParameters.h"
#include "simulation/scene/FilePlace.h"
#include "streams/Reflection.h"

namespace gt {

/// The fidelity of the bodies' motion. Kinematic: robots move by their own motion model. Dynamic:
/// motors, contacts and friction move everything.
enum class Fidelity { kinematic, dynamic };

/// A robot of the groups `robots` (active) and `extras` (passive). Element `robot`.
struct SceneRobot {
  std::string name;
  TeamColor team = TeamColor::red;
  PlayerRole role = PlayerRole::goalie;
  double x = 0, y = 0, rotation = 0;
  std::string model = "../models/ers210.xml";
  std::string layout = "../layouts/cmd.layout";
  std::string address;
  double bodyTilt = 0, bodyRoll = 0;
  FilePlace place;  ///< Of its element.

  Player player() const { return {team, role}; }
  Pose2D pose() const { return {normalize(fromDegrees(rotation)), x, y}; }

  static constexpr auto fields() {
    return Fields{
        field<&SceneRobot::name>("unique; by default team and number: red1"),
        field<&SceneRobot::team>(),
        field<&SceneRobot::role>(),
        field<&SceneRobot::x>(Unit::mm, "in the field's coordinates", {-1e4, 1e4}),
        field<&SceneRobot::y>(Unit::mm, {-1e4, 1e4}),
        field<&SceneRobot::rotation>(Unit::deg, {-360, 360}),
        field<&SceneRobot::model>("MJCF file, from the scene's folder"),
        field<&SceneRobot::layout>("process layout, from the scene's folder"),
        field<&SceneRobot::address>("hardware address, for robot.cfg"),
        field<&SceneRobot::bodyTilt>(
            Unit::deg, "the body leans back so much more than its joints state (report B.4.5)",
            {-20, 20}),
        field<&SceneRobot::bodyRoll>(
            Unit::deg, "the body leans to the right so much more than its joints state",
            {-20, 20})};
  }
};

/// A ball. Element `ball`.
struct SceneBall {
  double x = 0, y = 0;
  std::string model = "../models/ball.xml";
  FilePlace place;

  Vector2d position() const { return {x, y}; }

  static constexpr auto fields() {
    return Fields{field<&SceneBall::x>(Unit::mm, "in the field's coordinates", {-1e4, 1e4}),
                  field<&SceneBall::y>(Unit::mm, {-1e4, 1e4}),
                  field<&SceneBall::model>("MJCF file, from the scene's folder")};
  }
};

/// The degree of imperfection of the world and the robots' hardware. It sets all numbers of the
/// elements `noise`, `body`, `walking`, `camera`, `physics`, `radio` and the audience; numbers that
/// the scene itself states take precedence (docs/realism.md). Perfect: no errors. Benign: noise
/// only. Padova: as on the real robots of 2003, the default of scene files. Rough: twice as bad.
enum class Profile { perfect, benign, padova, rough };

/// A simulation scene: the robots and balls with their places, and the parameters of the world
/// (report I.4). Read from a `.scene` file. Its coordinates are the field's: origin at the center,
/// x to the sky-blue goal, as the red team sees it.
struct SceneDescription {
  std::string file;
  FilePlace fieldPlace, configPlace, scriptPlace;  ///< Of these attributes, or of the scene.
  std::string field = "../models/field2003.xml";
  std::string config = "../config";
  std::string script;
  std::string red, blue;
  Profile profile = Profile::benign;  ///< Sets the numbers that the elements do not state.
  Fidelity fidelity = Fidelity::kinematic;
  bool flags = true;
  int audience = 0;
  int referees = 0;
  NoiseParameters noise;
  BodyParameters body;
  WalkingParameters walking;
  DynamicsParameters dynamics;
  CameraEffects camera;
  CameraInfo optics;
  BallParameters physics;
  RadioParameters radio;
  GameParameters game;
  RuleParameters rules;
  std::optional<ChallengeParameters> challenge;
  std::optional<CeilingCameraParameters> ceilingCamera;
  std::vector<SceneRobot> robots;
  std::vector<SceneRobot> extras;
  std::vector<SceneBall> balls;

  /// The robots of both groups in the world's order: the active ones first.
  std::vector<const SceneRobot*> allRobots() const;
  /// A path relative to the scene's folder as a path relative to the working directory.
  std::string resolve(const std::string& path) const;
  /// The error about a file, or the folder of the configuration, that an attribute names.
  Error missing(const std::string& named, const FilePlace& place,
                const std::string& attribute) const;
  /// The script to begin with, as a path relative to the working directory: the scene's, with .con
  /// if it has no extension, or console.con beside the scene if there is one (report I.4); empty if
  /// there is none.
  std::string startScript() const;

  static constexpr auto fields() {
    return Fields{
        gt::field<&SceneDescription::field>("MJCF file, from the scene's folder"),
        gt::field<&SceneDescription::config>("folder of the configuration files"),
        gt::field<&SceneDescription::script>(
            "console script to begin with, from the scene's folder"),
        gt::field<&SceneDescription::red>(
            "team that plays red: a folder with files of its own, from the scene's folder"),
        gt::field<&SceneDescription::blue>("team that plays blue"),
        gt::field<&SceneDescription::profile>(
            "how far all is from perfect, where the scene does not state it; by default padova"),
        gt::field<&SceneDescription::fidelity>(),
        gt::field<&SceneDescription::flags>(
            "whether the field has its flags: what is of the model's class flag"),
        gt::field<&SceneDescription::audience>("people in strong colors behind the outer wall",
                                               {0, 200}),
        gt::field<&SceneDescription::referees>("whose legs stand on the field, beside the walls",
                                               {0, 200})};
  }
};

/// Greatest number of robots of a scene, active and passive together.
constexpr std::size_t maxSceneRobots = 22;
constexpr std::size_t maxSceneBalls = 100;
/// Greatest width and height of the robots' images (pixels).
constexpr int maxImageSize = 1280;

/// Reads a scene file; the schema is scenes/scene.xsd. Errors name file, line and element or
/// attribute. The models that the scene names are read by `composeModel`.
Result<SceneDescription> loadScene(const std::string& path);
/// As above, but adds all errors to a list and returns all that was read without error.
SceneDescription loadScene(const std::string& path, std::vector<Error>& errors);

/// Checks that the files and folders exist that a scene names beside its models: configuration,
/// script, layouts. Errors name the scene and the line.
Result<void> findSceneFiles(const SceneDescription& scene);
/// As above, but adds all errors to a list.
void findSceneFiles(const SceneDescription& scene, std::vector<Error>& errors);

}  // namespace gt
