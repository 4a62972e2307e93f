#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"
#include "representations/infrastructure/CameraInfo.h"
#include "representations/infrastructure/Player.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/scene/FilePlace.h"
#include "streams/Reflection.h"

namespace gt {

/// How truly the bodies move. Kinematic: robots move by their own motion model. Dynamic: motors,
/// contacts and friction move everything.
enum class Fidelity { kinematic, dynamic };

/// How much chance there is in the sensors and motions of all robots. Element `noise`.
struct NoiseParameters {
  double joints = 0.2;
  double acceleration = 200;
  double psd = 10;
  double slip = 0.06;
  double motion = 1;
  double psdReflections = 0;

  static constexpr auto fields() {
    return Fields{
        field("joints", &NoiseParameters::joints, "deg", "standard deviation of a measured angle",
              {0, 90}),
        field("acceleration", &NoiseParameters::acceleration, "mm/s^2", "standard deviation",
              {0, 1e5}),
        field("psd", &NoiseParameters::psd, "mm", "standard deviation at 900 mm, less when nearer",
              {0, 1000}),
        field("slip", &NoiseParameters::slip, "",
              "a robot's steps are that share longer or shorter at most, each direction its own",
              {0, 0.9}),
        field("motion", &NoiseParameters::motion, "",
              "noise of steps, kept for 0.25 s; 1: 20 mm and 1 degree over 1 m, 5 degrees over a "
              "turn",
              {0, 100}),
        field("psdReflections", &NoiseParameters::psdReflections, "",
              "share of the distance sensor's readings that are random, because of reflections",
              {0, 1})};
  }
};

/// How robots were put together, each of them differently, and how their joints and legs give.
/// What differs from robot to robot is normally distributed. Element `body`.
struct BodyParameters {
  double tilt = 0;
  double roll = 0;
  double jointOffset = 0;
  double accelerationOffset = 0;
  double cameraLight = 0;
  double cameraColor = 0;
  double backlash = 0;
  double commandDelay = 0;
  double swayTilt = 0;
  double swayRoll = 0;
  double swayHeight = 0;

  /// No command waits longer (ms).
  static constexpr double longestDelay = 120;

  static constexpr auto fields() {
    using P = BodyParameters;
    constexpr Range degrees{0, 20};
    return Fields{
        field("tilt", &P::tilt, "deg",
              "standard deviation, from robot to robot, of how much the body leans back more than "
              "joints and robot.cfg state",
              degrees),
        field("roll", &P::roll, "deg", "likewise to the right", degrees),
        field("jointOffset", &P::jointOffset, "deg",
              "standard deviation of the zero of each robot's each joint", degrees),
        field("accelerationOffset", &P::accelerationOffset, "mm/s^2",
              "standard deviation of the zero of each robot's acceleration sensors", {0, 5000}),
        field("cameraLight", &P::cameraLight, "",
              "standard deviation of how bright each robot's camera sees, as a share", {0, 0.5}),
        field("cameraColor", &P::cameraColor, "",
              "standard deviation of what each robot's camera adds to cb and to cr", {0, 60}),
        field("backlash", &P::backlash, "deg",
              "by which a joint can be turned without its sensor noticing", degrees),
        field("commandDelay", &P::commandDelay, "ms",
              "from a command until the motors act on it, beyond the next tick", {0, longestDelay}),
        field("swayTilt", &P::swayTilt, "deg",
              "standard deviation of the body's tilt, by legs that give, at 200 mm/s; kinematic "
              "fidelity only, as the other swaying",
              degrees),
        field("swayRoll", &P::swayRoll, "deg", "of its roll", degrees),
        field("swayHeight", &P::swayHeight, "mm", "of its height", {0, 50})};
  }
};

/// How the carpet shortens walked distances, where feet slip on it, and what is felt of things in
/// the way. The dynamic fidelity does not need it: friction and contacts have this effect there.
/// Element `walking`.
struct WalkingParameters {
  double shortfall = 0;
  double gaitShortfall = 0;
  double bursts = 0;
  double burstTime = 0.5;
  double burstSlip = 0.5;
  double contactTurn = 0;
  double contactLag = 0;
  double contactShaking = 0;

  static constexpr auto fields() {
    using P = WalkingParameters;
    return Fields{
        field("shortfall", &P::shortfall, "",
              "share by which all walked distances are shorter on this carpet", {-0.5, 0.9}),
        field("gaitShortfall", &P::gaitShortfall, "",
              "share that is added to it at 200 mm/s, in proportion to the speed", {-0.5, 0.9}),
        field("bursts", &P::bursts, "1/min", "how often a robot that walks begins to slip",
              {0, 1000}),
        field("burstTime", &P::burstTime, "s", "mean time for which it slips", {0.01, 60}),
        field("burstSlip", &P::burstSlip, "", "share of the distance that is lost meanwhile",
              {0, 1}),
        field("contactTurn", &P::contactTurn, "deg/s",
              "at most, by which a robot is turned that walks against a wall or a robot", {0, 360}),
        field("contactLag", &P::contactLag, "",
              "share by which its legs move less than free ones would in the same time", {0, 0.9}),
        field("contactShaking", &P::contactShaking, "mm/s^2",
              "standard deviation of what its acceleration sensors feel of that", {0, 20000})};
  }
};

/// How the bodies of the dynamic fidelity differ from their models: factors. Element `dynamics`.
struct DynamicsParameters {
  double friction = 1;
  double mass = 1;
  double strength = 1;

  bool operator==(const DynamicsParameters&) const = default;
  static constexpr auto fields() {
    using P = DynamicsParameters;
    constexpr Range factor{0.1, 10};
    return Fields{
        field("friction", &P::friction, "", "factor on the sliding friction of robots", factor),
        field("mass", &P::mass, "", "factor on the masses of all parts of robots", factor),
        field("strength", &P::strength, "", "factor on the servos' torques and their P gains",
              factor)};
  }
};

/// How balls roll and bounce. Element `physics`.
struct BallParameters {
  double deceleration = 250;
  double bounceWall = 0.5;
  double bounceRobot = 0.3;
  double friction = 0.1;
  double maxSpeed = 3000;
  double dents = 0;
  double dentSize = 150;

  static constexpr auto fields() {
    return Fields{
        field("deceleration", &BallParameters::deceleration, "mm/s^2", "rolling on the carpet",
              {0, 1e5}),
        field("bounceWall", &BallParameters::bounceWall, "", "coefficient of restitution", {0, 1}),
        field("bounceRobot", &BallParameters::bounceRobot, "", "coefficient of restitution",
              {0, 1}),
        field("friction", &BallParameters::friction, "",
              "share of the sliding speed that a touch takes", {0, 1}),
        field("maxSpeed", &BallParameters::maxSpeed, "mm/s", "", {1, 4000}),
        field("dents", &BallParameters::dents, "mm/s^2",
              "at most, by which the carpet's unevenness pulls a rolling ball in each direction",
              {0, 1e4}),
        field("dentSize", &BallParameters::dentSize, "mm", "from one dent to the next",
              {10, 5000})};
  }
};

/// The wireless network between the robots of a team. Element `radio`.
struct RadioParameters {
  double delayMin = 40;
  double delayMax = 120;
  double loss = 0.05;
  bool out = false;
  double bursts = 0;
  double burstTime = 2;
  double burstLoss = 1;

  static constexpr auto fields() {
    return Fields{
        field("delayMin", &RadioParameters::delayMin, "ms", "", {0, 10'000}),
        field("delayMax", &RadioParameters::delayMax, "ms", "", {0, 10'000}),
        field("loss", &RadioParameters::loss, "", "share of messages that never arrive", {0, 1}),
        field("out", &RadioParameters::out, "", "nothing gets through"),
        field("bursts", &RadioParameters::bursts, "1/min", "how often the network breaks down",
              {0, 1000}),
        field("burstTime", &RadioParameters::burstTime, "s", "mean time until it works again",
              {0.01, 600}),
        field("burstLoss", &RadioParameters::burstLoss, "",
              "share of messages that are lost meanwhile", {0, 1})};
  }
};

/// A camera at the ceiling that measures where robots and ball are (report 6.2.2). Element
/// `ceilingCamera`; a scene without it has none.
struct CeilingCameraParameters {
  double positionNoise = 6;
  double rotationNoise = 0.02;
  double scaleError = 0.002;
  double offsetError = 8;
  double overlooked = 0.02;
  double lowX = -1e4, highX = 1e4;
  int period = 40;
  bool oracle = false;

  static constexpr auto fields() {
    using P = CeilingCameraParameters;
    return Fields{field("positionNoise", &P::positionNoise, "mm",
                        "standard deviation of each coordinate in each image", {0, 1000}),
                  field("rotationNoise", &P::rotationNoise, "rad", "standard deviation", {0, 3}),
                  field("scaleError", &P::scaleError, "",
                        "of the calibration: at most, in each direction", {0, 0.5}),
                  field("offsetError", &P::offsetError, "mm", "likewise", {0, 1000}),
                  field("overlooked", &P::overlooked, "",
                        "share of images in which a thing is missed", {0, 1}),
                  field("lowX", &P::lowX, "mm",
                        "where its view begins, such as the middle of the field", {-1e4, 1e4}),
                  field("highX", &P::highX, "mm", "where it ends", {-1e4, 1e4}),
                  field("period", &P::period, "ms", "from image to image", {8, 10'000}),
                  field("oracle", &P::oracle, "",
                        "the oracle reports what this camera saw instead of the truth")};
  }
};

/// When there is a penalty shoot-out.
enum class ShootOutMode { none, afterDraw, only };

/// The game that the referee leads. Element `game`.
struct GameParameters {
  bool referee = true;
  double minutes = 10;
  TeamColor kickOff = TeamColor::red;
  double readyTime = 20;
  double setTime = 3;
  double stuckTime = 20;
  bool penalties = false;
  ShootOutMode shootOut = ShootOutMode::none;
  double leaveTime = 0;

  static constexpr auto fields() {
    return Fields{
        field("referee", &GameParameters::referee, "", "false: all robots play, nobody counts"),
        field("minutes", &GameParameters::minutes, "min", "both halves together", {0.01, 1e4}),
        field("kickOff", &GameParameters::kickOff, "", "the team that begins"),
        field("readyTime", &GameParameters::readyTime, "s",
              "at most, for walking to the kick-off positions", {0, 600}),
        field("setTime", &GameParameters::setTime, "s", "standing before the whistle", {0, 600}),
        field("stuckTime", &GameParameters::stuckTime, "s",
              "after which a ball that does not move is put elsewhere", {1, 600}),
        field("penalties", &GameParameters::penalties, "",
              "whether the referee penalizes robots, by the element rules"),
        field("shootOut", &GameParameters::shootOut, "",
              "a penalty shoot-out: none, after a draw, or as the whole game"),
        field("leaveTime", &GameParameters::leaveTime, "s",
              "that robots have to leave the field after the game, before all stands still",
              {0, 600})};
  }
};

/// The technical challenges of 2003 (report, chapter 4).
enum class ChallengeKind { ball, localization, obstacles };

/// Which challenge the scene is: it starts and scores itself (simulation/Challenge.h). Element
/// `challenge`.
struct ChallengeParameters {
  ChallengeKind kind = ChallengeKind::obstacles;
  bool random = false;
  double start = 1;
  double precise = 50;
  double near = 100;

  static constexpr auto fields() {
    using P = ChallengeParameters;
    return Fields{field("kind", &P::kind),
                  field("random", &P::random, "",
                        "whether the seed decides where all stand, or which places are visited"),
                  field("start", &P::start, "s", "when the back switch is pressed", {0, 600}),
                  field("precise", &P::precise, "mm",
                        "from a place to be visited, so near a stop gets all points", {1, 1000}),
                  field("near", &P::near, "mm", "so near it gets one", {1, 1000})};
  }
};

/// What the referee penalizes, after how many seconds of it; 0: never (facts, 2.2). How long robots
/// are removed, and the penalty shoot-out. Element `rules`.
struct RuleParameters {
  double ballHolding = 3;
  double keeperBallHolding = 5;
  double keeperCharge = 3;
  double fieldPlayerCharge = 3;
  double illegalDefender = 3;
  double illegalDefense = 3;
  double obstruction = 3;
  double requestForPickup = 15;
  double removal = 30;
  double obstructionRemoval = 0;
  int shots = 5;
  double shotTime = 60;

  static constexpr auto fields() {
    constexpr Range seconds{0, 600};
    return Fields{
        field("ballHolding", &RuleParameters::ballHolding, "s",
              "a field player's, or the keeper's outside of its penalty area", seconds),
        field("keeperBallHolding", &RuleParameters::keeperBallHolding, "s",
              "the keeper's in its penalty area", seconds),
        field("keeperCharge", &RuleParameters::keeperCharge, "s",
              "walking into the other keeper in its penalty area", seconds),
        field("fieldPlayerCharge", &RuleParameters::fieldPlayerCharge, "s",
              "walking into any other robot of the other team", seconds),
        field("illegalDefender", &RuleParameters::illegalDefender, "s",
              "a field player in the own penalty area", seconds),
        field("illegalDefense", &RuleParameters::illegalDefense, "s",
              "in the center circle at the other team's kick-off", seconds),
        field("obstruction", &RuleParameters::obstruction, "s",
              "standing in an opponent's path, far from the ball", seconds),
        field("requestForPickup", &RuleParameters::requestForPickup, "s",
              "lying on the side without getting up", seconds),
        field("removal", &RuleParameters::removal, "s", "for all penalties but obstruction",
              seconds),
        field("obstructionRemoval", &RuleParameters::obstructionRemoval, "s", "", seconds),
        field("shots", &RuleParameters::shots, "", "of each team in a shoot-out", {1, 100}),
        field("shotTime", &RuleParameters::shotTime, "s", "for one shot", {1, 600})};
  }
};

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
        field("name", &SceneRobot::name, "", "unique; by default team and number: red1"),
        field("team", &SceneRobot::team),
        field("role", &SceneRobot::role),
        field("x", &SceneRobot::x, "mm", "in the field's coordinates", {-1e4, 1e4}),
        field("y", &SceneRobot::y, "mm", "", {-1e4, 1e4}),
        field("rotation", &SceneRobot::rotation, "deg", "", {-360, 360}),
        field("model", &SceneRobot::model, "", "MJCF file, from the scene's folder"),
        field("layout", &SceneRobot::layout, "", "process layout, from the scene's folder"),
        field("address", &SceneRobot::address, "", "hardware address, for robot.cfg"),
        field("bodyTilt", &SceneRobot::bodyTilt, "deg",
              "the body leans back so much more than its joints state (report B.4.5)", {-20, 20}),
        field("bodyRoll", &SceneRobot::bodyRoll, "deg", "likewise to the right", {-20, 20})};
  }
};

/// A ball. Element `ball`.
struct SceneBall {
  double x = 0, y = 0;
  std::string model = "../models/ball.xml";
  FilePlace place;

  Vector2d position() const { return {x, y}; }

  static constexpr auto fields() {
    return Fields{field("x", &SceneBall::x, "mm", "in the field's coordinates", {-1e4, 1e4}),
                  field("y", &SceneBall::y, "mm", "", {-1e4, 1e4}),
                  field("model", &SceneBall::model, "", "MJCF file, from the scene's folder")};
  }
};

/// How far the world and the robots' hardware are from perfect: sets all numbers of the elements
/// `noise`, `body`, `walking`, `camera`, `physics`, `radio` and the audience; what the scene
/// states of one of them takes precedence (docs/realism.md). Perfect: no errors. Benign: noise
/// only. Padova: as on the real robots of 2003, the default of scene files. Rough: twice as bad.
enum class Profile { perfect, benign, padova, rough };

/// A simulation scene: which robots and balls stand where, and how the world is (report I.4). Read
/// from a `.scene` file. Its coordinates are the field's: origin at the center, x to the sky-blue
/// goal, as the red team sees it.
struct SceneDescription {
  std::string file;
  FilePlace fieldPlace, configPlace, scriptPlace;  ///< Of these attributes, or of the scene.
  std::string field = "../models/field2003.xml";
  std::string config = "../config";
  std::string script;
  std::string red, blue;
  Profile profile = Profile::benign;  ///< Whose numbers the elements have if nobody sets them.
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
  /// A path of the scene as a path from where the program runs.
  std::string resolve(const std::string& path) const;
  /// The error about a file, or the folder of the configuration, that an attribute names.
  Error missing(const std::string& named, const FilePlace& place,
                const std::string& attribute) const;
  /// The script to begin with, as a path from where the program runs: the scene's, with .con if it
  /// has no extension, or console.con beside the scene if there is one (report I.4); empty if there
  /// is none.
  std::string startScript() const;

  static constexpr auto fields() {
    return Fields{
        gt::field("field", &SceneDescription::field, "", "MJCF file, from the scene's folder"),
        gt::field("config", &SceneDescription::config, "", "folder of the configuration files"),
        gt::field("script", &SceneDescription::script, "",
                  "console script to begin with, from the scene's folder"),
        gt::field("red", &SceneDescription::red, "",
                  "team that plays red: a folder with files of its own, from the scene's folder"),
        gt::field("blue", &SceneDescription::blue, "", "team that plays blue"),
        gt::field(
            "profile", &SceneDescription::profile, "",
            "how far all is from perfect, where the scene does not state it; by default padova"),
        gt::field("fidelity", &SceneDescription::fidelity),
        gt::field("flags", &SceneDescription::flags, "",
                  "whether the field has its flags: what is of the model's class flag"),
        gt::field("audience", &SceneDescription::audience, "",
                  "people in strong colors behind the outer wall", {0, 200}),
        gt::field("referees", &SceneDescription::referees, "",
                  "whose legs stand on the field, beside the walls", {0, 200})};
  }
};

/// Most robots of a scene, active and passive together.
constexpr std::size_t maxSceneRobots = 22;
constexpr std::size_t maxSceneBalls = 100;
/// Most pixels of an image in each direction: each robot has such images.
constexpr int maxImageSize = 1280;

/// Reads a scene file; the schema is scenes/scene.xsd. Errors name file, line and element or
/// attribute. The models that the scene names are read by `composeModel`.
Result<SceneDescription> loadScene(const std::string& path);
/// The same, but adds all errors to a list and returns what was right.
SceneDescription loadScene(const std::string& path, std::vector<Error>& errors);

/// Looks for the files and folders that a scene names beside its models: configuration, script,
/// layouts. Errors name the scene and the line.
Result<void> findSceneFiles(const SceneDescription& scene);
/// The same, but adds all errors to a list.
void findSceneFiles(const SceneDescription& scene, std::vector<Error>& errors);

}  // namespace gt
