#include "modules/perception/processors/GT2003ImageProcessor.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "base/Random.h"

namespace gt {
namespace {

constexpr std::array palette{std::pair{ColorClass::orange, Pixel{130, 80, 185}},
                             std::pair{ColorClass::yellow, Pixel{190, 40, 145}},
                             std::pair{ColorClass::skyblue, Pixel{150, 175, 80}},
                             std::pair{ColorClass::pink, Pixel{140, 135, 195}},
                             std::pair{ColorClass::green, Pixel{90, 110, 100}},
                             std::pair{ColorClass::white, Pixel{220, 128, 128}},
                             std::pair{ColorClass::red, Pixel{80, 110, 190}},
                             std::pair{ColorClass::blue, Pixel{50, 170, 110}}};

Vector3d colorOf(ColorClass c) {
  for (const auto& [name, p] : palette)
    if (name == c) return {double(p.y), double(p.cb), double(p.cr)};
  return {110, 128, 130};  // What surrounds the field.
}

/// Colours near one of the palette belong to it.
ColorTable64 paletteTable() {
  ColorTable64 table;
  for (int y = 2; y < 256; y += 4)
    for (int cb = 2; cb < 256; cb += 4)
      for (int cr = 2; cr < 256; cr += 4)
        for (const auto& [name, p] : palette)
          if ((Vector3d(y, cb, cr) - colorOf(name)).norm() < 28)
            table.classes[ColorTable64::index(static_cast<std::uint8_t>(y),
                                              static_cast<std::uint8_t>(cb),
                                              static_cast<std::uint8_t>(cr))] = name;
  return table;
}

/// A world in the robot's system made of one ball, one flag and one goal wall, drawn by casting
/// rays, and what vision makes of it.
class GT2003ImageProcessorTest : public testing::Test {
 protected:
  std::optional<Vector3d> ball_;
  std::optional<Vector2d> flag_;
  FlagType flagType_ = FlagType::pinkAboveYellow;
  std::optional<double> goal_;  ///< Its distance ahead.
  double noise_ = 2;

  FieldDimensions field_;
  ColorTable64 colors_ = paletteTable();
  CameraMatrix matrix_;
  Image image_;
  GT2003ImageProcessor processor_;
  BallPercept percept_;
  LandmarksPercept landmarks_;
  LinesPercept lines_;
  PlayersPercept players_;
  ObstaclesPercept obstacles_;
  Debug debug_;

  void look(double pan, double tilt, double roll, Random& random) {
    matrix_.pose.rotation = rotationZ(pan) * rotationY(-tilt) * rotationX(roll);
    matrix_.pose.translation = {90, 10, 175};
    matrix_.valid = true;
    matrix_.info.rowTime = 0;
    image_.info = matrix_.info;
    image_.allocate();
    const auto byte = [&](double v) {
      return static_cast<std::uint8_t>(std::clamp(v + noise_ * random.gaussian(), 0.0, 255.0));
    };
    for (int y = 0; y < image_.info.height; ++y)
      for (int x = 0; x < image_.info.width; ++x) {
        Vector3d sum = Vector3d::Zero();
        for (const double dy : {1 / 6.0, 0.5, 5 / 6.0})
          for (const double dx : {1 / 6.0, 0.5, 5 / 6.0})
            sum += colorOf(classAlong(matrix_.ray(x + dx, y + dy).normalized())) / 9;
        image_.at(x, y) = {byte(sum[0]), byte(sum[1]), byte(sum[2]), 0};
      }
    processor_.update(image_, matrix_, colors_, field_, percept_, landmarks_, lines_, players_,
                      obstacles_, debug_);
  }

  Vector3d camera() const { return matrix_.pose.translation; }

 private:
  ColorClass classAlong(const Vector3d& ray) const {
    const Vector3d from = camera();
    if (ball_) {
      const Vector3d to = *ball_ - from;
      const double along = to.dot(ray);
      if (along > 0 && (to - ray * along).norm() < field_.ballRadius) return ColorClass::orange;
    }
    if (flag_) {
      // Where the ray meets the cylinder.
      const Vector2d to = *flag_ - from.head<2>();
      const Vector2d way = ray.head<2>();
      const double a = way.squaredNorm(), b = to.dot(way);
      const double c = to.squaredNorm() - field_.flagRadius * field_.flagRadius;
      if (b > 0 && b * b > a * c) {
        const double z = from.z() + ray.z() * (b - std::sqrt(b * b - a * c)) / a;
        const double middle = (field_.flagBottom + field_.flagTop) / 2;
        if (z > middle && z < field_.flagTop) return partOf(true);
        if (z > field_.flagBottom && z <= middle) return partOf(false);
        if (z > 0 && z <= field_.flagBottom) return ColorClass::white;
      }
    }
    if (goal_ && ray.x() > 0) {
      const Vector3d hit = from + ray * ((*goal_ - from.x()) / ray.x());
      if (std::abs(hit.y()) < field_.yGoal && hit.z() > 0 && hit.z() < field_.goalHeight)
        return ColorClass::yellow;
    }
    return ray.z() < 0 && from.z() / -ray.z() < 3500 ? ColorClass::green : ColorClass::noColor;
  }
  ColorClass partOf(bool upper) const {
    constexpr std::array colors{std::pair{ColorClass::pink, ColorClass::yellow},
                                std::pair{ColorClass::pink, ColorClass::green},
                                std::pair{ColorClass::pink, ColorClass::skyblue},
                                std::pair{ColorClass::yellow, ColorClass::pink},
                                std::pair{ColorClass::green, ColorClass::pink},
                                std::pair{ColorClass::skyblue, ColorClass::pink}};
    const auto& [above, below] = colors[static_cast<std::size_t>(flagType_)];
    return upper ? above : below;
  }
};

TEST_F(GT2003ImageProcessorTest, FindsTheBall) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random{seed};
    for (int i = 0; i < 15; ++i) {
      ball_ = Vector3d{random.uniform(250, 1500), random.uniform(-100, 100), field_.ballRadius};
      const Vector3d to = *ball_ - Vector3d{90, 10, 175};
      look(azimuth(to) + random.uniform(-0.25, 0.25), elevation(to) + random.uniform(-0.15, 0.15),
           random.uniform(-0.3, 0.3), random);
      ASSERT_TRUE(percept_.seen) << "seed " << seed << " ball " << ball_->transpose();
      EXPECT_NEAR(percept_.angle.x(), azimuth(to), fromDegrees(0.3));
      EXPECT_NEAR(percept_.angle.y(), elevation(to), fromDegrees(0.3));
      EXPECT_NEAR(percept_.distanceByProjection / to.norm(), 1, 0.03);
      EXPECT_NEAR(percept_.distanceBySize / to.norm(), 1, 0.08);
      EXPECT_NEAR((percept_.offset - ball_->head<2>()).norm() / to.norm(), 0, 0.03);
    }
  }
}

TEST_F(GT2003ImageProcessorTest, FindsABallCutByTheBorder) {
  Random random{4};
  ball_ = Vector3d{500, 0, field_.ballRadius};
  const Vector3d to = *ball_ - Vector3d{90, 10, 175};
  look(azimuth(to) + image_.info.openingAngleX() / 2, elevation(to), 0, random);
  ASSERT_TRUE(percept_.seen);
  EXPECT_NEAR(percept_.angle.x(), azimuth(to), fromDegrees(1.5));
  EXPECT_NEAR(percept_.distanceByProjection / to.norm(), 1, 0.05);
}

TEST_F(GT2003ImageProcessorTest, FindsABallThatFillsThePicture) {
  Random random{5};
  ball_ = Vector3d{150, 10, field_.ballRadius};
  field_.ballRadius = 130;  // So near that nothing else is seen.
  ball_->z() = 100;
  const Vector3d to = *ball_ - Vector3d{90, 10, 175};
  look(azimuth(to), elevation(to), 0, random);
  ASSERT_TRUE(percept_.seen);
  EXPECT_EQ(percept_.distanceBySize, 0);
}

TEST_F(GT2003ImageProcessorTest, UsesTheSizeWhereTheCameraCannotBeTrusted) {
  Random random{6};
  ball_ = Vector3d{700, 0, field_.ballRadius};
  look(0, -0.15, 0, random);
  CameraMatrix tilted = matrix_;
  tilted.valid = false;
  tilted.pose.rotation = matrix_.pose.rotation * rotationY(-0.1);
  processor_.update(image_, tilted, colors_, field_, percept_, landmarks_, lines_, players_,
                    obstacles_, debug_);
  ASSERT_TRUE(percept_.seen);
  EXPECT_NEAR(percept_.offset.x(), 700, 60);
}

TEST_F(GT2003ImageProcessorTest, SeesNothingWhereNothingIs) {
  Random random{7};
  for (const double tilt : {-0.8, -0.3, 0.0, 0.3}) {
    look(0.2, tilt, 0.1, random);
    EXPECT_FALSE(percept_.seen);
    EXPECT_EQ(landmarks_.numberOfFlags, 0);
    EXPECT_EQ(landmarks_.numberOfGoals, 0);
  }
}

TEST_F(GT2003ImageProcessorTest, MeasuresEachFlag) {
  Random random{8};
  for (int i = 0; i < 30; ++i) {
    flagType_ = static_cast<FlagType>(i % 6);
    flag_ = direction(random.uniform(-0.3, 0.3)) * random.uniform(800, 3200);
    look(random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1), random.uniform(-0.2, 0.2), random);
    const Vector2d to = *flag_ - camera().head<2>();
    const double half = std::asin(field_.flagRadius / to.norm());
    ASSERT_EQ(landmarks_.numberOfFlags, 1) << enumName(flagType_) << " " << flag_->transpose();
    const FlagPercept& seen = landmarks_.flags[0];
    EXPECT_EQ(seen.type, flagType_);
    if (!seen.boundary.leftOnBorder) {
      EXPECT_NEAR(seen.boundary.left, angleOf(to) + half, fromDegrees(0.3));
    }
    if (!seen.boundary.rightOnBorder) {
      EXPECT_NEAR(seen.boundary.right, angleOf(to) - half, fromDegrees(0.3));
    }
    EXPECT_NEAR(seen.distance / flag_->norm(), 1, 0.06);
    EXPECT_NEAR(seen.angle, angleOf(*flag_), fromDegrees(0.5));
  }
}

TEST_F(GT2003ImageProcessorTest, TellsAFlagsEdgeThatIsNotInThePicture) {
  Random random{9};
  flag_ = Vector2d{1200, 0};
  look(image_.info.openingAngleX() / 2 - 0.01, 0.05, 0, random);
  ASSERT_EQ(landmarks_.numberOfFlags, 1);
  const ConditionalBoundary& b = landmarks_.flags[0].boundary;
  EXPECT_TRUE(b.rightOnBorder);
  EXPECT_FALSE(b.leftOnBorder || b.topOnBorder || b.bottomOnBorder);
  EXPECT_NEAR(landmarks_.flags[0].angle, 0, fromDegrees(0.5));
}

TEST_F(GT2003ImageProcessorTest, MeasuresTheGoal) {
  Random random{10};
  for (int i = 0; i < 20; ++i) {
    goal_ = random.uniform(1000, 3000);
    look(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.02), random.uniform(-0.15, 0.15),
         random);
    ASSERT_EQ(landmarks_.numberOfGoals, 1) << *goal_;
    const GoalPercept& seen = landmarks_.goals[0];
    EXPECT_EQ(seen.color, GoalColor::yellow);
    const auto bearing = [&](double y) {
      return angleOf(Vector2d{*goal_, y} - camera().head<2>());
    };
    if (!seen.boundary.leftOnBorder) {
      EXPECT_NEAR(seen.boundary.left, bearing(field_.yGoal), fromDegrees(0.4));
    }
    if (!seen.boundary.rightOnBorder) {
      EXPECT_NEAR(seen.boundary.right, bearing(-field_.yGoal), fromDegrees(0.4));
    }
  }
}

TEST_F(GT2003ImageProcessorTest, LeavesTheEndOfAGoalOutsideThePictureOpen) {
  Random random{11};
  goal_ = 800;
  look(0.5, 0, 0, random);
  ASSERT_EQ(landmarks_.numberOfGoals, 1);
  EXPECT_TRUE(landmarks_.goals[0].boundary.rightOnBorder);
  EXPECT_FALSE(landmarks_.goals[0].boundary.leftOnBorder);
}

// Any picture and any rotation of the camera, however absurd, is only looked at.
TEST_F(GT2003ImageProcessorTest, SurvivesNoise) {
  Random random{12};
  for (int i = 0; i < 100; ++i) {
    matrix_.info.width = 1 + static_cast<int>(random.index(200));
    matrix_.info.height = 1 + static_cast<int>(random.index(150));
    image_.info = matrix_.info;
    image_.allocate();
    const bool coarse = random.chance(0.5);
    Pixel pixel;
    for (Pixel& p : image_.pixels) {
      if (!coarse || random.chance(0.05))
        pixel = random.chance(0.5) ? palette[random.index(palette.size())].second
                                   : Pixel{static_cast<std::uint8_t>(random()),
                                           static_cast<std::uint8_t>(random()),
                                           static_cast<std::uint8_t>(random()), 0};
      p = pixel;
    }
    matrix_.pose.rotation = rotationZ(random.uniform(-pi, pi)) *
                            rotationY(random.uniform(-pi, pi)) * rotationX(random.uniform(-pi, pi));
    matrix_.pose.translation.z() = random.uniform(-50, 300);
    matrix_.valid = random.chance(0.8);
    processor_.update(image_, matrix_, colors_, field_, percept_, landmarks_, lines_, players_,
                      obstacles_, debug_);
    EXPECT_LE(landmarks_.numberOfFlags, 6);
    EXPECT_TRUE(percept_.offset.allFinite());
  }
}

}  // namespace
}  // namespace gt
