#include <gtest/gtest.h>

#include <functional>

#include "base/Random.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"

namespace gt {
namespace {

constexpr std::array palette{std::pair{ColorClass::green, Pixel{90, 110, 100}},
                             std::pair{ColorClass::white, Pixel{220, 128, 128}},
                             std::pair{ColorClass::red, Pixel{80, 110, 190}},
                             std::pair{ColorClass::blue, Pixel{50, 170, 110}},
                             std::pair{ColorClass::skyblue, Pixel{150, 175, 80}},
                             std::pair{ColorClass::gray, Pixel{130, 128, 128}}};
constexpr Pixel background{40, 128, 130};

Vector3d colorOf(ColorClass c) {
  for (const auto& [name, p] : palette)
    if (name == c) return {double(p.y), double(p.cb), double(p.cr)};
  return {double(background.y), double(background.cb), double(background.cr)};
}

ColorTable64 paletteTable() {
  ColorTable64 table;
  for (int y = 2; y < 256; y += 4)
    for (int cb = 2; cb < 256; cb += 4)
      for (int cr = 2; cr < 256; cr += 4)
        for (const auto& [name, p] : palette)
          if ((Vector3d(y, cb, cr) - colorOf(name)).norm() < 30)
            table.classes[ColorTable64::index(static_cast<std::uint8_t>(y),
                                              static_cast<std::uint8_t>(cb),
                                              static_cast<std::uint8_t>(cr))] = name;
  return table;
}

/// A box that stands on the ground or above it, in the robot's system.
struct Box {
  Vector3d low, high;
  ColorClass color;

  /// How far along a ray it is met; negative if not.
  double meets(const Vector3d& from, const Vector3d& ray) const {
    double enter = 0, leave = 1e9;
    for (int k = 0; k < 3; ++k) {
      double a = (low[k] - from[k]) / ray[k], b = (high[k] - from[k]) / ray[k];
      if (a > b) std::swap(a, b);
      enter = std::max(enter, a);
      leave = std::min(leave, b);
    }
    return enter < leave ? enter : -1;
  }
};

/// Carpet with white on it, boxes on it, seen by a robot.
class FieldPercepts : public testing::Test {
 protected:
  std::function<bool(double x, double y)> isLine_ = [](double, double) { return false; };
  std::vector<Box> boxes_;
  double noise_ = 2;

  FieldDimensions field_;
  ColorTable64 colors_ = paletteTable();
  CameraMatrix matrix_;
  Image image_;
  GT2003ImageProcessor processor_;
  BallPercept ball_;
  LandmarksPercept landmarks_;
  LinesPercept lines_;
  PlayersPercept players_;
  ObstaclesPercept obstacles_;
  Debug debug_;
  Random random_{1};

  void look(double pan, double tilt, double roll = 0) {
    matrix_.pose.rotation = rotationZ(pan) * rotationY(-tilt) * rotationX(roll);
    matrix_.pose.translation = {90, 10, 190};
    matrix_.valid = true;
    matrix_.info.rowTime = 0;
    image_.info = matrix_.info;
    image_.allocate();
    const auto byte = [&](double v) {
      return static_cast<std::uint8_t>(std::clamp(v + noise_ * random_.gaussian(), 0.0, 255.0));
    };
    for (int y = 0; y < image_.info.height; ++y)
      for (int x = 0; x < image_.info.width; ++x) {
        Vector3d sum = Vector3d::Zero();
        for (const double dy : {0.25, 0.75})
          for (const double dx : {0.25, 0.75})
            sum += colorOf(classAlong(matrix_.ray(x + dx, y + dy).normalized())) / 4;
        image_.at(x, y) = {byte(sum[0]), byte(sum[1]), byte(sum[2]), 0};
      }
    processor_.update(image_, matrix_, colors_, field_, ball_, landmarks_, lines_, players_,
                      obstacles_, debug_);
  }

 private:
  ColorClass classAlong(const Vector3d& ray) const {
    const Vector3d from = matrix_.pose.translation;
    double nearest = ray.z() < 0 ? -from.z() / ray.z() : 1e6;
    const Vector3d ground = from + nearest * ray;
    ColorClass color = nearest > 9000                    ? ColorClass::noColor
                       : isLine_(ground.x(), ground.y()) ? ColorClass::white
                                                         : ColorClass::green;
    for (const Box& box : boxes_)
      if (const double met = box.meets(from, ray); met > 0 && met < nearest) {
        nearest = met;
        color = box.color;
      }
    return color;
  }
};

TEST_F(FieldPercepts, AllPerceptsKnowTheirPicturesTime) {
  image_.time = Time{1234};
  look(0, 0);
  for (const Time time : {ball_.time, landmarks_.time, lines_.time, players_.time, obstacles_.time})
    EXPECT_EQ(time, Time{1234});
}

TEST_F(FieldPercepts, LineAndBorderAheadAreToldApart) {
  isLine_ = [](double x, double) { return x > 800 && x < 825; };
  boxes_ = {{{1600, -3000, 0}, {1700, 3000, 100}, ColorClass::white},
            {{1700, -9000, 0}, {1800, 9000, 2000}, ColorClass::noColor}};
  for (const double pan : {-0.4, 0., 0.3})
    for (const double roll : {-0.2, 0., 0.2}) {
      look(pan, -0.25, roll);
      ASSERT_GE(lines_.points[EdgeType::line].size(), 6u);
      ASSERT_GE(lines_.points[EdgeType::border].size(), 6u);
      for (const Vector2d& p : lines_.points[EdgeType::line]) EXPECT_NEAR(p.x(), 812.5, 20);
      for (const Vector2d& p : lines_.points[EdgeType::border]) EXPECT_NEAR(p.x(), 1600, 60);
    }
}

TEST_F(FieldPercepts, LinesAlongTheViewAreMetByRows) {
  isLine_ = [](double, double y) { return y > 100 && y < 125; };
  look(0, -0.4);
  ASSERT_GE(lines_.points[EdgeType::line].size(), 3u);
  for (const Vector2d& p : lines_.points[EdgeType::line]) EXPECT_NEAR(p.y(), 112.5, 15);
  EXPECT_TRUE(lines_.points[EdgeType::border].empty());
}

TEST_F(FieldPercepts, AGoalsFootIsAnEdge) {
  boxes_ = {{{1200, -300, 0}, {1210, 300, 300}, ColorClass::skyblue}};
  look(0, -0.1);
  ASSERT_GE(lines_.points[EdgeType::skyblueGoal].size(), 6u);
  for (const Vector2d& p : lines_.points[EdgeType::skyblueGoal]) {
    EXPECT_NEAR(p.x(), 1200, 45);
    EXPECT_LT(std::abs(p.y()), 320);
  }
  EXPECT_TRUE(lines_.points[EdgeType::yellowGoal].empty());
}

TEST_F(FieldPercepts, AnEmptyCarpetHasNoEdges) {
  look(0.2, -0.3);
  for (const auto& points : lines_.points) EXPECT_TRUE(points.empty());
  for (const FreeGround& line : obstacles_.lines) EXPECT_GT(line.farPoint.norm(), 1500);
}

TEST_F(FieldPercepts, FreeGroundEndsAtWhatStandsOnItButNotAtLines) {
  isLine_ = [](double x, double) { return x > 500 && x < 525; };
  boxes_ = {{{900, -80, 0}, {1000, 80, 200}, ColorClass::gray}};
  look(0, -0.4);
  ASSERT_GE(obstacles_.lines.size(), 10u);
  int blocked = 0;
  for (const FreeGround& line : obstacles_.lines) {
    const double side = std::abs(line.farPoint.y()) * 900 / line.farPoint.x();
    if (side < 65) {
      EXPECT_NEAR(line.farPoint.x(), 900, 60);
      EXPECT_FALSE(line.farOnBorder);
      ++blocked;
    } else if (side > 100) {
      EXPECT_GT(line.farPoint.x(), 1000);
    }
  }
  EXPECT_GE(blocked, 2);
}

TEST_F(FieldPercepts, GroundThatIsNotGreenIsUnknown) {
  boxes_ = {{{150, -500, 0}, {2000, 500, 5}, ColorClass::gray}};
  look(0, -0.4);
  for (const FreeGround& line : obstacles_.lines) EXPECT_EQ(line.nearPoint, line.farPoint);
}

TEST_F(FieldPercepts, RobotsAreFoundByTheirTricots) {
  const auto robot = [](double x, double y, ColorClass tricot) {
    // Legs below, tricot above.
    return std::array{Box{{x - 60, y - 120, 0}, {x + 60, y + 120, 110}, ColorClass::gray},
                      Box{{x - 40, y - 60, 110}, {x + 40, y + 60, 185}, tricot}};
  };
  for (const double distance : {500., 800., 1200., 1800.}) {
    boxes_.clear();
    for (const Box& box : robot(distance, 250, ColorClass::red)) boxes_.push_back(box);
    for (const Box& box : robot(distance, -250, ColorClass::blue)) boxes_.push_back(box);
    look(0, -0.2);
    ASSERT_EQ(players_.players[TeamColor::red].size(), 1u) << distance;
    ASSERT_EQ(players_.players[TeamColor::blue].size(), 1u) << distance;
    const Vector2d red = players_.players[TeamColor::red].front();
    const Vector2d blue = players_.players[TeamColor::blue].front();
    EXPECT_LT((red - Vector2d{distance, 250}).norm(), 0.2 * distance) << distance;
    EXPECT_LT((blue - Vector2d{distance, -250}).norm(), 0.2 * distance) << distance;
  }
}

// Green is seen between the legs, and the nearest foot stands beside the tricot.
TEST_F(FieldPercepts, ARobotIsAsFarAsItsNearestFoot) {
  boxes_ = {{{900, -60, 110}, {1000, 60, 185}, ColorClass::red},
            {{820, 60, 0}, {850, 90, 110}, ColorClass::gray},
            {{1040, -60, 0}, {1070, -30, 110}, ColorClass::gray}};
  look(0, -0.25);
  ASSERT_EQ(players_.players[TeamColor::red].size(), 1u);
  EXPECT_NEAR(players_.players[TeamColor::red].front().x(), 890, 60);
  EXPECT_TRUE(players_.players[TeamColor::blue].empty());
}

TEST_F(FieldPercepts, ARobotSoCloseThatItsFeetAreNotSeenIsJudgedBySize) {
  boxes_ = {{{330, -150, 60}, {400, 150, 110}, ColorClass::gray},
            {{330, -62, 110}, {400, 62, 162}, ColorClass::blue},
            {{330, -150, 0}, {400, 150, 60}, ColorClass::gray}};
  look(0, 0.1);
  ASSERT_EQ(players_.players[TeamColor::blue].size(), 1u);
  EXPECT_NEAR(players_.players[TeamColor::blue].front().x(), 390, 120);
}

TEST_F(FieldPercepts, ARobotHidesTheFootOfAGoalButNotTheGoal) {
  boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
            {{600, -200, 0}, {700, 150, 170}, ColorClass::gray}};
  look(0, 0.05);
  ASSERT_EQ(landmarks_.numberOfGoals, 1);
  const ConditionalBoundary& b = landmarks_.goals[0].boundary;
  EXPECT_NEAR(toDegrees(b.left), toDegrees(std::atan2(290, 1410)), 1);
  EXPECT_NEAR(toDegrees(b.right), toDegrees(std::atan2(-310, 1410)), 1);
}

}  // namespace
}  // namespace gt
