// The image processors beside GT2003, on pictures drawn by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/Random.h"
#include "modules/kinematics/BodyPosture.h"
#include "modules/kinematics/HeadKinematics.h"
#include "modules/perception/calibration/CameraCalibrator.h"
#include "modules/perception/calibration/CheckerboardDetector.h"
#include "modules/perception/colors/ColorAdaptation.h"
#include "modules/perception/processors/GridImageProcessorTSL.h"
#include "modules/perception/processors/LinesImageProcessor.h"
#include "modules/perception/specialists/BlackWhiteBallSpecialist.h"

namespace gt {
namespace {

const Vector3d green{77, 113, 82}, white{230, 128, 128}, black{16, 128, 128}, orange{129, 59, 214},
    yellow{195, 26, 158}, skyblue{132, 186, 63}, pink{139, 139, 203}, red{65, 106, 212},
    blue{36, 177, 115}, gray{120, 130, 128};

/// A colour in other light.
Vector3d lit(const Vector3d& color, double light) {
  return Vector3d{0, 128, 128} + light * (color - Vector3d{0, 128, 128});
}

Pixel pixelOf(const Vector3d& color, double noise, Random& random) {
  const auto byte = [&](double v) {
    return static_cast<std::uint8_t>(std::clamp(v + noise * random.gaussian() + 0.5, 0.0, 255.0));
  };
  return {byte(color[0]), byte(color[1]), byte(color[2]), 0};
}

/// A picture from 170 mm above the ground; colorAt tells what a direction shows. Nine rays a pixel.
struct Scene {
  CameraMatrix matrix;
  Image image;

  explicit Scene(double tilt = -0.3, double roll = 0) {
    matrix.pose.rotation = rotationY(-tilt) * rotationX(roll);
    matrix.pose.translation = {0, 0, 170};
    matrix.valid = true;
    matrix.info.rowTime = 0;
    image.info = matrix.info;
    image.allocate();
  }
  void draw(const std::function<Vector3d(const Vector3d&)>& colorAt, double light, double noise,
            Random& random) {
    for (int y = 0; y < image.info.height; ++y)
      for (int x = 0; x < image.info.width; ++x) {
        Vector3d sum = Vector3d::Zero();
        for (const double dy : {1 / 6.0, 0.5, 5 / 6.0})
          for (const double dx : {1 / 6.0, 0.5, 5 / 6.0})
            sum += colorAt(matrix.ray(x + dx, y + dy).normalized()) / 9;
        image.at(x, y) = pixelOf(lit(sum, light), noise, random);
      }
  }
};

/// Green ground with a white wall behind, and lines.
Vector3d fieldAt(const Vector3d& ray) {
  if (ray.z() >= -0.02) return ray.z() < 0.05 ? white : black;
  const double x = 170 * ray.x() / -ray.z();
  return std::fmod(x, 700) < 40 ? white : green;
}

class ColorAdaptationTest : public testing::Test {
 protected:
  ColorAdaptation colors_;
  Random random_{1};
  Scene scene_;

  void watch(double light, int pictures) {
    const Horizon horizon = horizonOf(scene_.matrix);
    for (int i = 0; i < pictures; ++i) {
      if (i % 10 == 0) scene_.draw(fieldAt, light, 3, random_);
      colors_.observe(scene_.image, horizon);
      colors_.refresh();
    }
  }
  double rightShare(const Vector3d& color, double light, ColorClass expected) {
    int right = 0;
    for (int i = 0; i < 500; ++i)
      right += colors_.table()[pixelOf(lit(color, light), 2, random_)] == expected ? 1 : 0;
    return right / 500.0;
  }
};

TEST_F(ColorAdaptationTest, KnowsNothingUntilItHasSeenTheField) {
  EXPECT_EQ(rightShare(green, 1, ColorClass::noColor), 1);
  Scene sky{0.6};
  sky.draw([](const Vector3d&) { return skyblue; }, 1, 3, random_);
  for (int i = 0; i < 100; ++i) {
    colors_.observe(sky.image, horizonOf(sky.matrix));
    colors_.refresh();
  }
  EXPECT_FALSE(colors_.isGreenKnown());
  EXPECT_EQ(rightShare(green, 1, ColorClass::noColor), 1);
}

TEST_F(ColorAdaptationTest, TellsAllColoursInAnyLightFromTheGreenOfTheGround) {
  for (const double light : {1.0, 0.5, 1.25, 0.7}) {
    watch(light, 60);
    ASSERT_TRUE(colors_.isGreenKnown());
    EXPECT_NEAR(colors_.greenY(), green[0] * light, 4);
    for (const auto& [color, expected] : {std::pair{green, ColorClass::green},
                                          {orange, ColorClass::orange},
                                          {yellow, ColorClass::yellow},
                                          {skyblue, ColorClass::skyblue},
                                          {pink, ColorClass::pink},
                                          {red, ColorClass::red},
                                          {blue, ColorClass::blue},
                                          {white, ColorClass::white},
                                          {black, ColorClass::black},
                                          {gray, ColorClass::gray}})
      EXPECT_GT(rightShare(color, light, expected), 0.9)
          << enumName(expected) << " in light " << light;
  }
}

TEST_F(ColorAdaptationTest, MovesAColourToWhereRecognizedObjectsHaveIt) {
  watch(1, 40);
  const Vector3d other{135, 66, 224};  // Redder.
  const double hue = std::atan2(224 - 128, 66 - 128);
  const double before = std::abs(normalize(colors_.tone(ColorClass::orange).hue - hue));
  for (int i = 0; i < 400; ++i) colors_.learn(ColorClass::orange, pixelOf(other, 2, random_));
  EXPECT_LT(std::abs(normalize(colors_.tone(ColorClass::orange).hue - hue)), before / 2);
  const Tone orangeTone = colors_.tone(ColorClass::orange);
  for (int i = 0; i < 400; ++i) colors_.learn(ColorClass::orange, pixelOf(skyblue, 2, random_));
  EXPECT_EQ(colors_.tone(ColorClass::orange).hue, orangeTone.hue) << "sky-blue is no orange";
}

ColorTable64 blackWhiteTable() {
  ColorTable64 table;
  for (int y = 2; y < 256; y += 4)
    for (int cb = 2; cb < 256; cb += 4)
      for (int cr = 2; cr < 256; cr += 4) {
        const bool isGreen = cr < 112;
        table.classes[ColorTable64::index(
            static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(cb),
            static_cast<std::uint8_t>(cr))] = isGreen   ? ColorClass::green
                                              : y > 150 ? ColorClass::white
                                              : y < 60  ? ColorClass::black
                                                        : ColorClass::gray;
      }
  return table;
}

class BlackWhiteBallTest : public testing::Test {
 protected:
  static constexpr double radius = 43;
  ColorTable64 table_ = blackWhiteTable();
  Random random_{3};
  BlackWhiteBallSpecialist specialist_;
  BallPercept percept_;

  void look(const Scene& scene) {
    const Horizon horizon = horizonOf(scene.matrix);
    specialist_.find({scene.image, table_, scene.matrix, horizon}, radius, random_, percept_);
  }
  /// A ball of which what lies in some directions from its middle is black.
  static Vector3d ballAt(const Vector3d& center, const Vector3d& from, const Vector3d& ray) {
    const Vector3d to = center - from;
    const double along = to.dot(ray);
    const double off = (to - ray * along).squaredNorm();
    if (along < 0 || off > radius * radius) return fieldAt(ray);
    const Vector3d normal =
        (from + ray * (along - std::sqrt(radius * radius - off)) - center).normalized();
    for (const Vector3d& patch : {Vector3d{-0.8, 0.5, 0.3},
                                  {-0.8, -0.6, 0.1},
                                  {-0.3, 0.1, 0.95},
                                  {-0.7, 0.1, -0.7},
                                  {0, 0.95, -0.3},
                                  {0, -0.9, 0.4}})
      if (normal.dot(patch.normalized()) > 0.88) return black;
    return white;
  }
};

TEST_F(BlackWhiteBallTest, IsFoundWhereItIs) {
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const Vector3d ball{random_.uniform(250, 900), random_.uniform(-80, 80), radius};
    Scene scene{-0.25};
    scene.draw([&](const Vector3d& ray) { return ballAt(ball, {0, 0, 170}, ray); }, 1, 2, random_);
    look(scene);
    const Vector3d to = ball - scene.matrix.pose.translation;
    if (!percept_.seen) continue;
    ++found;
    EXPECT_NEAR(percept_.angle.x(), azimuth(to), fromDegrees(1.2));
    EXPECT_NEAR(percept_.angle.y(), elevation(to), fromDegrees(1.2));
    EXPECT_NEAR(percept_.distanceByProjection / to.norm(), 1, 0.12);
  }
  EXPECT_GE(found, 26);
}

TEST_F(BlackWhiteBallTest, IsNotSeenOnAFieldWithoutOne) {
  for (int i = 0; i < 10; ++i) {
    Scene scene{-0.1 * i, 0.05 * i};
    scene.draw(fieldAt, 1, 3, random_);
    look(scene);
    EXPECT_FALSE(percept_.seen) << i;
  }
}

class CheckerboardTest : public testing::Test {
 protected:
  Checkerboard board_;
  Random random_{4};
  CheckerboardFinder finder_;
  std::vector<Vector2d> corners_;

  /// The board stands at x = distance.
  Vector3d colorAt(const Vector3d& ray, double distance) const {
    if (ray.x() <= 0) return green;
    const double y = ray.y() / ray.x() * distance, z = 170 + ray.z() / ray.x() * distance;
    const double u = (board_.columns + 1) / 2.0 - y / board_.square;
    const double v = 1 + (z - board_.height) / board_.square;
    if (u < -0.5 || v < -0.5 || u > board_.columns + 1.5 || v > board_.rows + 1.5) return green;
    if (u < 0 || v < 0 || u > board_.columns + 1 || v > board_.rows + 1) return white;
    return (static_cast<int>(u) + static_cast<int>(v)) % 2 == 0 ? black : white;
  }
  Vector3d cornerAt(int column, int row, double distance) const {
    return {distance, ((board_.columns - 1) / 2.0 - column) * board_.square,
            board_.height + (board_.rows - 1 - row) * board_.square};
  }
};

TEST_F(CheckerboardTest, CornersAreFoundToAFractionOfAPixel) {
  for (int i = 0; i < 12; ++i) {
    const double distance = random_.uniform(450, 700);
    Scene scene{random_.uniform(-0.1, 0.05), random_.uniform(-0.15, 0.15)};
    scene.draw([&](const Vector3d& ray) { return colorAt(ray, distance); }, 1, 2, random_);
    ASSERT_TRUE(finder_.find(scene.image, horizonOf(scene.matrix), board_, corners_)) << distance;
    ASSERT_EQ(corners_.size(), 24u);
    for (int row = 0; row < board_.rows; ++row)
      for (int column = 0; column < board_.columns; ++column) {
        const Vector2d truth =
            pointIn(scene.matrix, cornerAt(column, row, distance) - scene.matrix.pose.translation);
        const Vector2d& seen = corners_[static_cast<std::size_t>(row * board_.columns + column)];
        EXPECT_LT((truth - seen).norm(), 0.35) << row << " " << column;
      }
  }
}

TEST_F(CheckerboardTest, IsNotFoundWhereItIsNotOrNotWhole) {
  Scene scene{0};
  scene.draw(fieldAt, 1, 10, random_);
  EXPECT_FALSE(finder_.find(scene.image, horizonOf(scene.matrix), board_, corners_));
  scene.matrix.pose.rotation = rotationZ(0.45);
  scene.draw([&](const Vector3d& ray) { return colorAt(ray, 500); }, 1, 2, random_);
  EXPECT_FALSE(finder_.find(scene.image, horizonOf(scene.matrix), board_, corners_));
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 100}, {100, 3}}) {
    Image tiny;
    tiny.info.width = width;
    tiny.info.height = height;
    tiny.allocate();
    EXPECT_FALSE(finder_.find(tiny, Horizon{}, board_, corners_));
  }
}

// Corners as a robot sees them that leans otherwise than it believes, with another lens.
TEST_F(CheckerboardTest, CalibratesOpeningAnglesAndBody) {
  const RobotDimensions robot;
  const RobotCalibration truth{fromDegrees(3), fromDegrees(-2)};
  CameraInfo camera;
  camera.focalX = 150;
  camera.focalY = 171;
  CameraCalibrator calibrator{board_};
  CameraCalibration found;
  EXPECT_FALSE(calibrator.calibrate(CameraInfo{}, robot, {}, found)) << "without any picture";
  for (int i = 0; i < 15; ++i) {
    JointAngles joints;
    joints[Joint::headTilt] = random_.uniform(-0.2, 0.15);
    joints[Joint::headPan] = random_.uniform(-0.35, 0.35);
    const Pose3D pose =
        cameraPose(robot, bodyPose(bodyPosture(robot, truth, joints)),
                   {joints[Joint::headTilt], joints[Joint::headPan], joints[Joint::headRoll]});
    corners_.clear();
    for (int k = 0; k < board_.rows * board_.columns; ++k)
      corners_.push_back(
          camera.project(pose.inverse() * cornerAt(k % board_.columns, k / board_.columns, 600)));
    calibrator.add(corners_, joints);
  }
  ASSERT_TRUE(calibrator.calibrate(CameraInfo{}, robot, {}, found));
  EXPECT_NEAR(found.focalX, camera.focalX, 0.01);
  EXPECT_NEAR(found.focalY, camera.focalY, 0.01);
  EXPECT_NEAR(found.body.bodyTiltOffset, truth.bodyTiltOffset, 1e-4);
  EXPECT_NEAR(found.body.bodyRollOffset, truth.bodyRollOffset, 1e-4);
  EXPECT_NEAR(found.boardPosition.x(), 600, 0.1);
  EXPECT_LT(found.error, 1e-3);
}

/// All percepts of an image processor.
struct Percepts {
  BallPercept ball;
  LandmarksPercept landmarks;
  LinesPercept lines;
  PlayersPercept players;
  ObstaclesPercept obstacles;
  Debug debug{1 << 16};
};

TEST(LinesImageProcessor, FindsTheSameEdgesAsGT2003AndNothingElse) {
  Random random{5};
  Scene scene{-0.2, 0.1};
  scene.draw(fieldAt, 1, 2, random);
  const ColorTable64 table = blackWhiteTable();
  Percepts own, all;
  own.ball.seen = true;
  own.landmarks.numberOfFlags = own.landmarks.numberOfGoals = 1;
  LinesImageProcessor lines;
  lines.update(scene.image, scene.matrix, table, {}, own.ball, own.landmarks, own.lines,
               own.players, own.obstacles, own.debug);
  GT2003ImageProcessor gt2003;
  gt2003.update(scene.image, scene.matrix, table, {}, all.ball, all.landmarks, all.lines,
                all.players, all.obstacles, all.debug);
  EXPECT_GT(own.lines.points[EdgeType::line].size(), 10u);
  for (const EdgeType type : {EdgeType::line, EdgeType::border})
    EXPECT_EQ(own.lines.points[type], all.lines.points[type]);
  EXPECT_FALSE(own.ball.seen);
  EXPECT_EQ(own.landmarks.numberOfFlags + own.landmarks.numberOfGoals, 0);
  EXPECT_TRUE(own.obstacles.lines.empty());
}

TEST(LinesImageProcessor, DrawsItsGridAndTheEdgesOnIt) {
  Random random{5};
  Scene scene{-0.2, 0.1};
  scene.draw(fieldAt, 1, 2, random);
  Percepts found;
  LinesImageProcessor lines;
  const auto drawn = [&](std::string_view key, bool on) {
    found.debug.keys().set(*DebugKey::find(key),
                           {on ? DebugKeyMode::always : DebugKeyMode::disabled});
    found.debug.out().clear();
    lines.update(scene.image, scene.matrix, blackWhiteTable(), {}, found.ball, found.landmarks,
                 found.lines, found.players, found.obstacles, found.debug);
    Drawing drawing;
    found.debug.out().handleAllMessages(
        [&](const Message& message) { EXPECT_TRUE(message.read(drawing)); });
    return drawing.elements;
  };
  const auto grid = drawn("ImageProcessor/grid", true);
  EXPECT_TRUE(drawn("ImageProcessor/grid", false).empty());
  const auto edges = drawn("ImageProcessor/edges", true);
  ASSERT_GT(grid.size(), 10u);
  for (const DrawingElement& element : grid) EXPECT_EQ(element.type, ElementType::line);
  EXPECT_GT(edges.size(), 10u);
  for (const DrawingElement& element : edges) EXPECT_EQ(element.type, ElementType::point);
}

TEST(GridImageProcessorTSL, FollowsItsThresholds) {
  Random random{6};
  Scene scene{-0.2};
  scene.draw(fieldAt, 1, 0, random);
  Percepts percepts;
  GridImageProcessorTSL processor;
  TslColors colors;
  const auto seen = [&] {
    processor.update(scene.image, scene.matrix, colors, {}, percepts.ball, percepts.landmarks,
                     percepts.lines, percepts.players, percepts.obstacles, percepts.debug);
    return percepts.lines.points[EdgeType::line].size();
  };
  EXPECT_EQ(seen(), 0u) << "without any class";
  const Tsl ground = tslOf(pixelOf(green, 0, random));
  const auto around = [](int value) {
    return ColorRange{std::max(value - 40, 0), std::min(value + 40, 255)};
  };
  colors.classes[ColorClass::green].tint = around(ground.tint);
  colors.classes[ColorClass::green].saturation = around(ground.saturation);
  colors.classes[ColorClass::green].luminance = {20, 150};
  colors.classes[ColorClass::white].priority = 1;
  colors.classes[ColorClass::white].saturation = {0, 255};
  colors.classes[ColorClass::white].luminance = {180, 255};
  EXPECT_GT(seen(), 10u);
}

}  // namespace
}  // namespace gt
