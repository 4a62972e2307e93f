#include "representations/modeling/BallModel.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LinesPercept.h"
#include "representations/perception/ObstaclesPercept.h"
#include "representations/perception/PlayersPercept.h"
#include "workbench/space/SpaceDialog.h"

namespace gt {
namespace {

constexpr double imageDistance = 250;  // mm, of the image's plane from the camera
constexpr int pixelStep = 4;           // pixels of the image that are drawn as one
constexpr double ballRadius = 43, flagHeight = 600, flagRadius = 50, goalHeight = 300;  // mm

Vector3d onGround(const Vector2d& point, double height = 0) {
  return {point.x(), point.y(), height};
}
Vector3d around(double angle, double distance, double height) {
  return {distance * std::cos(angle), distance * std::sin(angle), height};
}

/// The camera's image as a plane before the camera.
void addCameraImage(const Image& image, const CameraMatrix& camera, GlScene& scene) {
  const RgbImage rgb = rgbOf(image);
  const double half = pixelStep * imageDistance / (2 * camera.info.focalX);
  for (int row = 0; row + pixelStep <= image.info.height; row += pixelStep)
    for (int column = 0; column + pixelStep <= image.info.width; column += pixelStep) {
      const auto first = static_cast<std::size_t>(3 * (row * image.info.width + column));
      const Vector3d ray = camera.ray(column + pixelStep / 2.0, row + pixelStep / 2.0);
      const double ahead = ray.dot(camera.pose.rotation.col(0));
      scene.add(
          mjGEOM_BOX, {0.5, half, half}, camera.pose.translation + imageDistance / ahead * ray,
          {rgb.pixels[first], rgb.pixels[first + 1], rgb.pixels[first + 2]}, camera.pose.rotation);
    }
}

void addLandmarks(const LandmarksPercept& landmarks, GlScene& scene) {
  for (int i = 0; i < landmarks.numberOfFlags; ++i) {
    const FlagPercept& flag = landmarks.flags[static_cast<std::size_t>(i)];
    if (flag.distance > 0)
      scene.add(mjGEOM_CYLINDER, {flagRadius, flagRadius, flagHeight / 2},
                around(flag.angle, flag.distance, flagHeight / 2), colors::pink);
  }
  for (int i = 0; i < landmarks.numberOfGoals; ++i) {
    const GoalPercept& goal = landmarks.goals[static_cast<std::size_t>(i)];
    if (goal.distance <= 0) continue;
    const Color& color = goal.color == GoalColor::yellow ? colors::yellow : colors::skyblue;
    const Vector3d up{0, 0, goalHeight};
    const Vector3d left = around(goal.boundary.left, goal.distance, 0);
    const Vector3d right = around(goal.boundary.right, goal.distance, 0);
    scene.addLine(left, left + up, 20, color);
    scene.addLine(right, right + up, 20, color);
    scene.addLine(left + up, right + up, 20, color);
  }
}

template <typename Percept, typename Add>
void addIfKnown(ObservedRobot& robot, Add add) {
  if (const auto percept = robot.value<Percept>()) add(**percept);
}

void addPercepts(ObservedRobot& robot, GlScene& scene) {
  addIfKnown<LandmarksPercept>(robot, [&](const auto& seen) { addLandmarks(seen, scene); });
  addIfKnown<LinesPercept>(robot, [&](const LinesPercept& seen) {
    for (const EdgeType type :
         {EdgeType::line, EdgeType::border, EdgeType::yellowGoal, EdgeType::skyblueGoal})
      for (const Vector2d& point : seen.points[type])
        scene.add(mjGEOM_SPHERE, Vector3d::Constant(12), onGround(point),
                  type == EdgeType::line         ? colors::white
                  : type == EdgeType::border     ? Color{60, 200, 90}
                  : type == EdgeType::yellowGoal ? colors::yellow
                                                 : colors::skyblue);
  });
  addIfKnown<ObstaclesPercept>(robot, [&](const ObstaclesPercept& seen) {
    for (const FreeGround& free : seen.lines)
      scene.addLine(onGround(free.nearPoint, 3), onGround(free.farPoint, 3), 6,
                    {120, 160, 120, 120});
  });
  addIfKnown<PlayersPercept>(robot, [&](const PlayersPercept& seen) {
    for (const TeamColor team : {TeamColor::red, TeamColor::blue})
      for (const Vector2d& player : seen.players[team])
        scene.add(mjGEOM_CYLINDER, {80, 80, 75}, onGround(player, 75),
                  team == TeamColor::red ? colors::red : colors::blue);
  });
  addIfKnown<BallModel>(robot, [&](const BallModel& ball) {
    scene.add(mjGEOM_SPHERE, Vector3d::Constant(ballRadius), onGround(ball.position, ballRadius),
              {colors::orange.r, colors::orange.g, colors::orange.b, 110});
  });
}

/// The ball as it was seen: from the camera along the angles, as far as its size says.
void addBall(const BallPercept& ball, const CameraMatrix& camera, GlScene& scene) {
  if (!ball.seen || ball.distanceBySize <= 0) return;
  const Vector3d ray = camera.ray(ball.centerInImage.x(), ball.centerInImage.y()).normalized();
  const Vector3d at = camera.pose.translation + ball.distanceBySize * ray;
  scene.addLine(camera.pose.translation, at, 4, colors::orange);
  scene.add(mjGEOM_SPHERE, Vector3d::Constant(ballRadius), at, colors::orange);
}

/// Report J.3.3: percepts in space around the robot, which looks along the red axis, with the
/// camera's image before the camera.
class Radar3D : public SpaceDialog {
 public:
  explicit Radar3D(SessionThread& session) : SpaceDialog{session} {
    view().camera() = {.at = {500, 0, 0}, .azimuth = 160, .elevation = 30, .distance = 2600};
  }

 protected:
  Draw drawing() const override {
    return [](const Canvas& canvas) -> std::string {
      GlScene& scene = canvas.scene;
      scene.clear();
      if (!canvas.robot) return "No robot is connected.";
      ObservedRobot& robot = canvas.robot->observed();
      scene.add(mjGEOM_BOX, {3000, 3000, 1}, {0, 0, -2}, {20, 60, 35});
      scene.add(mjGEOM_BOX, {90, 45, 35}, {0, 0, 110}, {150, 150, 155});
      scene.addLine({0, 0, 2}, {300, 0, 2}, 8, colors::red);
      scene.addLine({0, 0, 2}, {0, 300, 2}, 8, {60, 200, 90});
      addPercepts(robot, scene);
      const auto camera = robot.value<CameraMatrix>();
      if (!camera) return robot.name() + ": " + camera.error().text();
      if (!(*camera)->valid) return robot.name() + ": the camera matrix is not valid";
      scene.addLine({60, 0, 120}, (*camera)->pose.translation, 30, {150, 150, 155});
      const auto image = robot.value<Image>();
      if (image && !(*image)->pixels.empty()) addCameraImage(**image, **camera, scene);
      addIfKnown<BallPercept>(robot,
                              [&](const BallPercept& ball) { addBall(ball, **camera, scene); });
      return robot.name();
    };
  }
};

const RegisterDialog<Radar3D> registeredRadar3D{
    {.id = "radar3D",
     .title = "Radar 3D",
     .group = "Viewers",
     .help = "Percepts in space around the robot, with the camera's image before the camera",
     .report = "J.3.3",
     .several = true,
     .make = makeInSpace<Radar3D>}};

}  // namespace
}  // namespace gt
