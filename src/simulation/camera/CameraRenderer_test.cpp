#include "simulation/camera/CameraRenderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "simulation/camera/TestWorld.h"

namespace gt {
namespace {

const std::string floorText = R"(<geom type="plane" size="5 5 1" rgba="0.05 0.45 0.2 1"/>)";

/// How the geoms of an image are spread.
struct Blob {
  int area = 0, left = 10000, right = -1, top = 10000, bottom = -1;
  double x = 0, y = 0;
};
Blob blobOf(const ImageTruth& truth, const CameraInfo& info, int geom) {
  Blob blob;
  for (int y = 0; y < info.height; ++y)
    for (int x = 0; x < info.width; ++x)
      if (truth.geoms[static_cast<std::size_t>(y * info.width + x)] == geom) {
        ++blob.area;
        blob.left = std::min(blob.left, x);
        blob.right = std::max(blob.right, x);
        blob.top = std::min(blob.top, y);
        blob.bottom = std::max(blob.bottom, y);
        blob.x += x + 0.5;
        blob.y += y + 0.5;
      }
  blob.x /= blob.area;
  blob.y /= blob.area;
  return blob;
}

TEST(CameraRenderer, DepthsAreMeasuredAlongTheOpticalAxis) {
  TestWorld world = TestWorld::fromBodies(
      floorText +
      R"(<body pos="1 0 0.25"><geom name="wall" type="box" size="0.01 0.2 0.1"/></body>)");
  const CameraView view = viewFrom({0, 0, 250}, 0, 0, 0);
  ImageTruth truth;
  truth.withDepths = true;
  world.picture(view, CameraEffects::none(), &truth);
  ASSERT_EQ(truth.depths.size(), truth.geoms.size());
  int onWall = 0, onFloor = 0, behind = 0;
  for (int y = 0; y < view.info.height; ++y)
    for (int x = 0; x < view.info.width; ++x) {
      const auto i = static_cast<std::size_t>(y * view.info.width + x);
      const double down = (y + 0.5 - view.info.centerY) / view.info.focalY;
      if (truth.geoms[i] == world.geom("wall")) {
        ++onWall;
        EXPECT_NEAR(truth.depths[i], 990, 0.1)
            << "the same all over the wall, as it faces the camera";
      } else if (truth.geoms[i] < 0) {
        ++behind;
        EXPECT_TRUE(std::isinf(truth.depths[i]));
      } else if (down > 0.1) {
        ++onFloor;
        EXPECT_NEAR(truth.depths[i], 250 / down, 0.02 * 250 / down);
      }
    }
  EXPECT_GT(onWall, 500);
  EXPECT_GT(onFloor, 500);
  EXPECT_GT(behind, 500);
}

TEST(CameraRenderer, TheBallsOutlineIsThatOfASphere) {
  TestWorld world = TestWorld::fromBodies(
      floorText + R"(<body name="ball"><freejoint/><geom name="ball" size="0.043"/></body>)");
  const int ball = world.geom("ball");
  Random random{5};
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const double distance = 0.1 * std::pow(30.0, random.uniform());
    world.data().qpos[0] = distance;
    world.data().qpos[1] = 0.4 * distance * random.symmetric();
    world.data().qpos[2] = 0.25 + 0.3 * distance * random.symmetric();
    mj_forward(&world.model(), &world.data());
    const CameraView view = viewFrom({0, 0, 250}, 0.2 * random.symmetric(),
                                     0.1 * random.symmetric(), random.symmetric());
    ImageTruth truth;
    world.picture(view, CameraEffects::none(), &truth);

    // A ray meets the sphere if its angle to the center is small enough.
    const Vector3d center =
        view.last.inverse() * Vector3d{1000 * Eigen::Map<Vector3d>{world.data().qpos}};
    const double distance2 = center.squaredNorm();
    Blob exact;
    int different = 0;
    for (int y = 0; y < view.info.height; ++y)
      for (int x = 0; x < view.info.width; ++x) {
        const Vector3d ray = view.info.ray(x + 0.5, y + 0.5).normalized();
        const double along = ray.dot(center);
        const bool hit = along > 0 && distance2 - along * along < 43 * 43;
        const bool seen = truth.geoms[static_cast<std::size_t>(y * view.info.width + x)] == ball;
        exact.area += hit;
        different += hit != seen;
        if (hit) exact.x += x + 0.5, exact.y += y + 0.5;
      }
    const Vector3d world3 = view.last * center;
    if (exact.area < 4 || world3.z() < 43) continue;  // Partly below the floor.
    ++compared;
    const Blob blob = blobOf(truth, view.info, ball);
    const double radius = std::sqrt(exact.area / pi);
    const double tolerance = 0.25 + 0.5 / radius;  // One pixel matters to a small ball.
    EXPECT_NEAR(std::sqrt(blob.area / pi), radius, tolerance) << "at " << distance;
    EXPECT_NEAR(blob.x, exact.x / exact.area, tolerance);
    EXPECT_NEAR(blob.y, exact.y / exact.area, tolerance);
    EXPECT_LE(different, 2 + 2 * radius) << "of a circumference of " << 2 * pi * radius;
  }
  EXPECT_GT(compared, 250);
}

TEST(CameraRenderer, FlagsStandWhereTheCameraInfoSaysThatTheyAreSeen) {
  TestWorld world = TestWorld::fromFile("models/field2003.xml");
  const int flag = world.geom("pinkAboveYellowUpper");
  ASSERT_GE(flag, 0);
  const Vector3d middle{-2100, -1400, 360};
  Random random{6};
  for (int i = 0; i < 50; ++i) {
    const Vector3d from{random.uniform(-1500, 1500), random.uniform(-500, 1000),
                        random.uniform(150, 300)};
    const Vector3d to = middle - from;
    const CameraView view =
        viewFrom(from, std::atan2(to.y(), to.x()) + 0.2 * random.symmetric(), 0.02);
    ImageTruth truth;
    world.picture(view, CameraEffects::none(), &truth);
    const Blob blob = blobOf(truth, view.info, flag);
    // The outline of a cylinder: two vertical lines, where planes through the camera touch it.
    const double distance = std::hypot(to.x(), to.y()), bearing = std::atan2(to.y(), to.x());
    const double half = std::asin(50 / distance), reach = std::sqrt(distance * distance - 2500);
    const auto edge = [&](double angle) {
      return seenAt(view,
                    from + Vector3d{reach * std::cos(angle), reach * std::sin(angle), to.z()});
    };
    EXPECT_NEAR(blob.left, edge(bearing + half).x(), 1);
    EXPECT_NEAR(blob.right + 1, edge(bearing - half).x(), 1);
    const Vector2d above = seenAt(view, middle + Vector3d{0, 0, 50});
    const Vector2d below = seenAt(view, middle - Vector3d{0, 0, 50});
    EXPECT_NEAR(blob.top, above.y(), 1.5);
    EXPECT_NEAR(blob.bottom + 1, below.y(), 1.5);
  }
}

TEST(CameraRenderer, LinesLieWhereTheCameraInfoSaysThatTheyAreSeen) {
  TestWorld world = TestWorld::fromFile("models/field2003.xml");
  const int line = world.geom("lineHalfway");
  const CameraView view = viewFrom({-700, 250, 200}, -0.15, -0.25, 0.1);
  ImageTruth truth;
  world.picture(view, CameraEffects::none(), &truth);
  int rows = 0;
  for (double y = -400; y < 400; y += 10) {
    const Vector2d nearer = seenAt(view, {-12.5, y, 0}), farther = seenAt(view, {12.5, y, 0});
    if (!view.info.contains(nearer.x(), nearer.y() + 2) ||
        !view.info.contains(farther.x(), farther.y() - 2))
      continue;
    ++rows;
    const auto geomAt = [&](double x, double row) {
      return truth.geoms[static_cast<std::size_t>(static_cast<int>(row) * view.info.width +
                                                  static_cast<int>(x))];
    };
    const Vector2d middle = (nearer + farther) / 2;
    EXPECT_EQ(geomAt(middle.x(), middle.y()), line);
    EXPECT_NE(geomAt(nearer.x(), nearer.y() + 1), line);
    EXPECT_NE(geomAt(farther.x(), farther.y() - 1), line);
  }
  EXPECT_GT(rows, 20);
}

TEST(CameraRenderer, WhatIsNearerHidesWhatIsFarther) {
  TestWorld world = TestWorld::fromBodies(
      floorText + R"(<geom name="robot" type="box" size="0.02 0.1 0.02" pos="0.5 0 0.02"/>
                     <geom name="ball" size="0.043" pos="0.8 0 0.043"/>
                     <geom name="wall" type="box" size="0.05 1 0.05" pos="1.2 0 0.05"/>)");
  const CameraView view = viewFrom({0, 0, 100}, 0, -0.05);
  ImageTruth truth;
  world.picture(view, CameraEffects::none(), &truth);
  const auto geomAt = [&](const Vector3d& point) {
    const Vector2d p = seenAt(view, point);
    return truth.geoms[static_cast<std::size_t>(static_cast<int>(p.y()) * view.info.width +
                                                static_cast<int>(p.x()))];
  };
  EXPECT_EQ(geomAt({480, 0, 35}), world.geom("robot"));
  EXPECT_EQ(geomAt({800, 0, 70}), world.geom("ball"));
  EXPECT_EQ(geomAt({1150, 150, 50}), world.geom("wall"));
}

TEST(CameraRenderer, TheTruthIsWhatThePerfectImageShows) {
  TestWorld world = TestWorld::fromFile("models/field2003.xml");
  Random random{7};
  for (int i = 0; i < 20; ++i) {
    const CameraView view =
        viewFrom({random.uniform(-2000, 2000), random.uniform(-1200, 1200), 200},
                 random.uniform(-pi, pi), random.uniform(-0.5, 0.1));
    ImageTruth truth;
    const Image image = world.picture(view, CameraEffects::none(), &truth);
    for (std::size_t p = 0; p < image.pixels.size(); ++p) {
      if (truth.geoms[p] < 0) continue;
      const Pixel& pixel = image.pixels[p];
      const double y = pixel.y, cb = pixel.cb - 128.0, cr = pixel.cr - 128.0;
      const Eigen::Vector3d rgb{y + 1.402 * cr, y - 0.344136 * cb - 0.714136 * cr, y + 1.772 * cb};
      ColorClass seen = classOfRgb((rgb / 255).cast<float>());
      // White in the shade may be called gray, dark gray black.
      if (seen == ColorClass::gray && truth.classes[p] == ColorClass::white && y > 130)
        seen = ColorClass::white;
      ASSERT_EQ(seen, truth.classes[p]) << "geom " << truth.geoms[p];
      ASSERT_EQ(truth.classes[p], world.scene().classOf(truth.geoms[p]));
      ASSERT_EQ(pixel.unused, 0);
    }
  }
}

TEST(CameraRenderer, APoleIsSkewedByTheTurningRateAndTheRowTime) {
  TestWorld world = TestWorld::fromBodies(
      floorText + R"(<geom name="pole" type="box" size="0.01 0.01 2" pos="1.5 0.2 0"/>)");
  for (const double rate : {-3.0, -1.0, 0.5, 3.0}) {
    CameraView view = viewFrom({0, 0, 150}, 0.05, 0.1, 0.2);
    const double duration = (view.info.height - 1) * view.info.rowTime / 1000;
    view.first.rotation = rotationZ(-rate * duration) * view.last.rotation;
    ImageTruth truth;
    CameraEffects effects = CameraEffects::none();
    effects.rollingShutter = true;
    world.picture(view, effects, &truth);
    int rows = 0;
    for (int y = 2; y < view.info.height - 2; y += 5) {
      // The plane through the camera and the pole's axis cuts the row.
      const Pose3D pose = poseAtRow(view, y + 0.5);
      const Vector3d foot = pose.inverse() * Vector3d{1500, 200, 0};
      const Vector3d head = pose.inverse() * Vector3d{1500, 200, 500};
      const Vector3d normal = foot.cross(head);
      const Vector3d left = view.info.ray(0, y + 0.5), right = view.info.ray(1, y + 0.5);
      const double x = -normal.dot(left) / normal.dot(right - left);
      // Below the pole's foot lies the floor.
      if (x < 5 || x > view.info.width - 5 || view.info.project(foot).y() < y + 3) continue;
      ++rows;
      double sum = 0;
      int count = 0;
      for (int column = 0; column < view.info.width; ++column)
        if (truth.geoms[static_cast<std::size_t>(y * view.info.width + column)] ==
            world.geom("pole"))
          sum += column + 0.5, ++count;
      ASSERT_GT(count, 0) << "row " << y;
      EXPECT_NEAR(sum / count, x, 0.6) << "row " << y << " at " << rate << " rad/s";
    }
    EXPECT_GT(rows, 12);
  }
}

class AgreesWithMuJoCosRays : public testing::TestWithParam<LensDistortion> {
 protected:
  /// Compares what is seen in every third pixel of an image with what a ray hits.
  void compare(TestWorld& world, const CameraView& view, const ImageTruth& truth) {
    for (int y = 1; y < view.info.height - 1; y += 3) {
      const Pose3D pose = poseAtRow(view, y + 0.5);
      const Vector3d from = pose.translation / 1000;
      for (int x = 1; x < view.info.width - 1; x += 3) {
        const Vector3d ray = pose.rotation * view.info.ray(x + 0.5, y + 0.5).normalized();
        int geom = -1;
        mj_ray(&world.model(), &world.data(), from.data(), ray.data(), nullptr, 1, -1, &geom);
        // Along edges a neighbor may be meant.
        bool seen = false, same = false;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const bool here =
                truth.geoms[static_cast<std::size_t>((y + dy) * view.info.width + x + dx)] == geom;
            seen |= here;
            same |= here && dx == 0 && dy == 0;
          }
        ++pixels;
        different += !same;
        unknown += !seen;
      }
    }
  }

  int pixels = 0, different = 0, unknown = 0;
};

TEST_P(AgreesWithMuJoCosRays, ForEveryPixel) {
  // Every form, some of them in a robot whose arm reaches far, seen while the camera moves.
  TestWorld world = TestWorld::fromBodies(R"(
      <geom type="plane" size="4 4 1" rgba="0.1 0.4 0.2 1"/>
      <geom type="box" group="1" size="0.4 0.0125 0.0001" pos="0.6 0.1 0.0001"/>
      <geom type="cylinder" group="1" size="0.16 0.0001" pos="0.9 -0.3 0.0001"/>
      <geom type="box" size="0.05 1 0.05" pos="2 0 0.05"/>
      <geom type="cylinder" size="0.05 0.2" pos="1.6 0.5 0.2"/>
      <geom type="cylinder" size="0.04 0.08" pos="0.7 0.3 0.1" euler="20 70 0"/>
      <geom type="ellipsoid" size="0.08 0.04 0.06" pos="0.6 -0.1 0.06" euler="10 20 30"/>
      <geom type="sphere" size="0.043" pos="0.45 0.05 0.043"/>
      <body pos="1 -0.1 0.2"><freejoint/>
        <geom type="box" size="0.08 0.04 0.03" euler="0 10 20"/>
        <geom type="capsule" size="0.015 0.05" pos="0.06 0.05 -0.05" euler="10 30 0"/>
        <geom type="mesh" mesh="wedge" pos="0 0 0.05"/>
        <body pos="0.1 0 0"><joint axis="0 1 0"/>
          <geom type="capsule" fromto="0 0 0 0.3 0 0.1" size="0.02"/>
          <body pos="0.3 0 0.1"><joint axis="0 0 1"/><geom size="0.04" pos="0.05 0 0.04"/></body>
        </body>
      </body>)",
                                          R"(<mesh name="wedge"
      vertex="0 0 0  0.1 0 0  0 0.1 0  0 0 0.1"/>)");
  Random random{8};
  const bool even = GetParam().none();
  for (int i = 0; i < (even ? 60 : 20); ++i) {
    CameraView view =
        viewFrom({random.uniform(-300, 300), random.uniform(-300, 300), random.uniform(80, 300)},
                 0.3 * random.symmetric(), random.uniform(-0.4, 0.05), 0.3 * random.symmetric());
    view.info.distortion2 = GetParam().k2;
    view.info.distortion4 = GetParam().k4;
    if (i % 2) {
      view.first.rotation =
          Eigen::AngleAxisd{
              0.09,
              Vector3d{random.symmetric(), random.symmetric(), random.symmetric()}.normalized()} *
          view.last.rotation;
      view.first.translation += 10 * Vector3d{random.symmetric(), random.symmetric(), 0};
    }
    for (int q = 7; q < world.model().nq; ++q) world.data().qpos[q] = random.uniform(-pi, pi);
    mj_forward(&world.model(), &world.data());
    CameraEffects effects = CameraEffects::none();
    effects.rollingShutter = true;
    ImageTruth truth;
    world.picture(view, effects, &truth);
    compare(world, view, truth);
  }
  EXPECT_LT(different, pixels / 100);
  // Where round forms nearly touch each other, the flat depth of their outlines may mistake them.
  EXPECT_LE(unknown, even ? pixels / 50'000 : pixels / 1'000);
}

INSTANTIATE_TEST_SUITE_P(CameraRenderer, AgreesWithMuJoCosRays,
                         testing::Values(LensDistortion{}, LensDistortion{-0.2, 0},
                                         LensDistortion{-0.25, 0.08}, LensDistortion{0.1, 0}));

TEST(CameraRenderer, TheSameInputGivesTheSameBytesInEveryThread) {
  TestWorld world = TestWorld::fromFile("models/ers210.xml");
  std::vector<CameraView> views;
  Random random{9};
  for (int i = 0; i < 64; ++i)
    views.push_back(
        viewFrom({-400, 100 * random.symmetric(), 200}, 0.3 * random.symmetric(), -0.1));
  const auto takeAll = [&](std::vector<std::vector<Pixel>>& pictures, bool backwards) {
    CameraRenderer renderer{world.scene()};
    Image image;
    pictures.resize(views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
      const std::size_t k = backwards ? views.size() - 1 - i : i;
      renderer.render(world.data(), views[k], {}, k, image);
      pictures[k] = image.pixels;
    }
  };
  std::vector<std::vector<Pixel>> one, two, three;
  takeAll(one, false);
  std::thread other{[&] { takeAll(two, true); }};
  takeAll(three, false);
  other.join();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::size_t bytes = one[i].size() * sizeof(Pixel);
    EXPECT_EQ(std::memcmp(one[i].data(), two[i].data(), bytes), 0);
    EXPECT_EQ(std::memcmp(one[i].data(), three[i].data(), bytes), 0);
  }
}

TEST(CameraRenderer, NoPoseAndNoSizeIsTooMuch) {
  TestWorld world = TestWorld::fromFile("models/ers210.xml");
  CameraRenderer renderer{world.scene()};
  Image image;
  ImageTruth truth;
  Random random{10};
  for (int i = 0; i < 3000; ++i) {
    const double reach = i % 3 ? 150 : 1e6;  // Mostly within the robot.
    CameraView view = viewFrom(
        {reach * random.symmetric(), reach * random.symmetric(), 150 + reach * random.symmetric()},
        pi * random.symmetric(), pi * random.symmetric(), random.symmetric());
    if (i % 2) view.first = viewFrom({0, 0, 100}, pi * random.symmetric(), pi / 2).last;
    if (i % 100 == 7) view.last.translation.x() = std::numeric_limits<double>::quiet_NaN();
    if (i % 100 == 8) view.first.rotation(1, 1) = std::numeric_limits<double>::infinity();
    view.info.width = 1 + static_cast<int>(random.index(60));
    view.info.height = 1 + static_cast<int>(random.index(40));
    view.info.focalX = view.info.focalY = random.uniform(1, 300);
    renderer.render(world.data(), view, {}, static_cast<std::uint64_t>(i), image, &truth);
    ASSERT_EQ(image.pixels.size(), truth.classes.size());
    ASSERT_EQ(image.pixels.size(), static_cast<std::size_t>(view.info.width * view.info.height));
  }
}

TEST(CameraRenderer, TheSkyIsBackgroundAndTheFloorFillsTheImageFromAbove) {
  TestWorld world = TestWorld::fromBodies(floorText);
  ImageTruth truth;
  world.picture(viewFrom({0, 0, 200}, 0, pi / 2), CameraEffects::none(), &truth);
  EXPECT_THAT(truth.geoms, testing::Each(-1));
  world.picture(viewFrom({0, 0, 200}, 0, -pi / 2), CameraEffects::none(), &truth);
  EXPECT_THAT(truth.geoms, testing::Each(0));
}

TEST(CameraRenderer, TheBodyAroundTheCameraIsHidden) {
  TestWorld world = TestWorld::fromFile("models/ers210.xml");
  const int muzzle = world.geom("muzzle");
  CameraView view = viewFrom({400, 0, 250}, pi);
  ImageTruth truth;
  world.picture(view, CameraEffects::none(), &truth);
  EXPECT_THAT(truth.geoms, testing::Contains(muzzle));
  view.hiddenBody = world.model().geom_bodyid[muzzle];
  world.picture(view, CameraEffects::none(), &truth);
  EXPECT_THAT(truth.geoms, testing::Not(testing::Contains(muzzle)));
  EXPECT_THAT(truth.geoms, testing::Contains(world.geom("torso")));
}

}  // namespace
}  // namespace gt
