#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>

#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/LandmarksPercept.h"
#include "simulation/scene/SceneModel.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// The foot ball's center in the body's system by the lengths of RobotDimensions.
Vector3d footByHand(Leg leg, const JointAngles& q, const RobotDimensions& d) {
  const double x = isFore(leg) ? 1 : -1, y = isLeft(leg) ? 1 : -1;
  const Vector3d& lower = isFore(leg) ? d.lowerLegFore : d.lowerLegHind;
  Pose3D pose;
  pose.translate(x * d.shoulderX, y * d.shoulderY, 0)
      .rotate(rotationY(-x * q[legJoint(leg, 1)]))
      .rotate(rotationX(y * q[legJoint(leg, 2)]))
      .translate(x * d.upperLeg.x(), y * d.upperLeg.y(), d.upperLeg.z())
      .rotate(rotationY(-x * q[legJoint(leg, 3)]))
      .translate(x * lower.x(), y * lower.y(), lower.z());
  return pose.translation;
}

/// The camera in the body's system by report 3.1.
Pose3D cameraByHand(const JointAngles& q, const RobotDimensions& d) {
  Pose3D pose;
  pose.translate(d.neckX, 0, d.neckZ)
      .rotate(rotationY(-q[Joint::headTilt]))
      .translate(0, 0, d.neckToPan)
      .rotate(rotationZ(q[Joint::headPan]))
      .rotate(rotationX(q[Joint::headRoll]))
      .translate(d.panToCamera, 0, 0);
  return pose;
}

class RobotModel : public testing::Test {
 protected:
  void SetUp() override {
    auto model = composeModel(duelScene({}, {500, 0}));
    ASSERT_TRUE(model) << model.error().text();
    model_ = std::move(*model);
    data_ = makeData(*model_);
    auto parts = findRobotParts(*model_, "red1", "");
    ASSERT_TRUE(parts);
    parts_ = *parts;
  }
  void pose(const JointAngles& angles) {
    mjtNum* root = data_->qpos + parts_.poseAddress;
    std::fill_n(root, 7, 0);
    root[3] = 1;
    for (std::size_t j = 0; j < enumCount<Joint>; ++j)
      data_->qpos[parts_.jointAddress.values[j]] = angles.values[j];
    mj_kinematics(model_.get(), data_.get());
  }

  Model model_;
  ModelData data_;
  RobotParts parts_;
  RobotDimensions dimensions_;
};

TEST_F(RobotModel, FeetAreWhereTheLengthsPutThem) {
  Random random{5};
  for (int i = 0; i < 200; ++i) {
    const JointAngles angles = randomAngles(random);
    pose(angles);
    for (int leg = 0; leg < 4; ++leg) {
      const int site = parts_.footSites[static_cast<std::size_t>(leg)];
      const Vector3d foot = fromMuJoCo(data_->site_xpos + 3 * site);
      EXPECT_LT((foot - footByHand(static_cast<Leg>(leg), angles, dimensions_)).norm(), 1e-6);
      EXPECT_NEAR(1000 * model_->site_size[3 * site], dimensions_.footRadius, 1e-9);
    }
  }
}

TEST_F(RobotModel, CameraIsWhereTheReportPutsIt) {
  Random random{6};
  for (int i = 0; i < 200; ++i) {
    const JointAngles angles = randomAngles(random);
    pose(angles);
    const Pose3D camera = sitePose(*data_, parts_.cameraSite);
    const Pose3D expected = cameraByHand(angles, dimensions_);
    EXPECT_LT((camera.translation - expected.translation).norm(), 1e-6);
    EXPECT_LT((camera.rotation - expected.rotation).norm(), 1e-9);
    // MuJoCo's own camera sees the same: it looks along its negative z axis, y up.
    const int id = mj_name2id(model_.get(), mjOBJ_CAMERA, "red1/camera");
    ASSERT_GE(id, 0);
    mj_camlight(model_.get(), data_.get());
    const Matrix3d seen = rotationFromMuJoCo(data_->cam_xmat + 9 * id);
    EXPECT_LT((seen.col(2) + expected.rotation.col(0)).norm(), 1e-9);
    EXPECT_LT((seen.col(1) - expected.rotation.col(2)).norm(), 1e-9);
  }
}

TEST_F(RobotModel, SignsAreThoseOfJoint) {
  const auto site = [&](int id) { return fromMuJoCo(data_->site_xpos + 3 * id); };
  const auto moved = [&](Joint joint, int id) {
    pose({});
    const Vector3d before = site(id);
    JointAngles angles;
    angles[joint] = 0.2;
    pose(angles);
    return Vector3d{site(id) - before};
  };
  EXPECT_GT(moved(Joint::headTilt, parts_.cameraSite).z(), 1);
  EXPECT_GT(moved(Joint::headPan, parts_.cameraSite).y(), 1);
  EXPECT_GT(moved(Joint::legFR1, parts_.footSites[0]).x(), 1);
  EXPECT_LT(moved(Joint::legHL1, parts_.footSites[3]).x(), -1);
  EXPECT_LT(moved(Joint::legFR2, parts_.footSites[0]).y(), -1);
  EXPECT_GT(moved(Joint::legHL2, parts_.footSites[3]).y(), 1);
}

TEST_F(RobotModel, LimitsHoldThoseOfTheJoints) {
  for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
    const std::string name = "red1/" + std::string{enumNames<Joint>[j]};
    const int id = mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
    ASSERT_GE(id, 0) << name;
    const JointLimits limits = limitsOf(static_cast<Joint>(j));
    EXPECT_LE(model_->jnt_range[2 * id], limits.low + 1e-3) << name;
    EXPECT_GE(model_->jnt_range[2 * id + 1], limits.high - 1e-3) << name;
    EXPECT_LT(model_->jnt_range[2 * id + 1] - limits.high, fromDegrees(4)) << name;
  }
  EXPECT_LE(parts_.lastGeom - parts_.firstGeom, 40);
}

std::string colorOf(const mjModel& model, int geom) {
  const int material = model.geom_matid[geom];
  if (material < 0) return "";
  std::string name = mj_id2name(&model, mjOBJ_MATERIAL, material);
  name = name.substr(name.rfind('/') + 1);
  return name.substr(0, name.find('.'));
}

TEST(FieldModel, FlagsStandWhereThePerceptsExpectThem) {
  const auto model = composeModel(matchScene());
  ASSERT_TRUE(model);
  const ModelData data = makeData(**model);
  mj_kinematics(model->get(), data.get());
  const FieldDimensions field;
  for (std::size_t i = 0; i < enumCount<FlagType>; ++i) {
    const std::string name{enumNames<FlagType>[i]};
    const Vector2d expected = positionOf(static_cast<FlagType>(i), TeamColor::red, field);
    const auto upperEnd = name.find("Above");
    std::string lower = name.substr(upperEnd + 5);
    lower[0] = static_cast<char>(std::tolower(lower[0]));
    for (const auto& [part, color, bottom] :
         {std::tuple{"Upper", name.substr(0, upperEnd), (field.flagBottom + field.flagTop) / 2},
          std::tuple{"Lower", lower, field.flagBottom}}) {
      const int geom = mj_name2id(model->get(), mjOBJ_GEOM, (name + part).c_str());
      ASSERT_GE(geom, 0) << name << part;
      const Vector3d p = fromMuJoCo(data->geom_xpos + 3 * geom);
      EXPECT_LT((p.head<2>() - expected).norm(), 1e-6) << name;
      EXPECT_EQ(colorOf(**model, geom), color);
      const double half = 1000 * (*model)->geom_size[3 * geom + 1];
      EXPECT_NEAR(p.z() - half, bottom, 1e-6);
      EXPECT_NEAR(2 * half, (field.flagTop - field.flagBottom) / 2, 1e-6);
      EXPECT_NEAR(1000 * (*model)->geom_size[3 * geom], field.flagRadius, 1e-6);
    }
  }
}

/// How far it is from a point above the field's center line to what stands in a direction (mm).
double reach(const mjModel& model, const mjData& data, const Vector3d& from, const Vector3d& along,
             std::string& color) {
  const Vector3d start = from / 1000;
  const mjtByte groups[6] = {0, 0, 1, 0, 0, 0};
  int geom = -1;
  const mjtNum distance = mj_ray(&model, &data, start.data(), along.data(), groups, 1, -1, &geom);
  color = geom < 0 ? "" : colorOf(model, geom);
  return 1000 * distance;
}

TEST(FieldModel, WallsAndGoalsHaveTheFieldsDimensions) {
  const auto model = composeModel(matchScene());
  ASSERT_TRUE(model);
  const ModelData data = makeData(**model);
  mj_kinematics(model->get(), data.get());
  const FieldDimensions f;
  std::string color;
  const auto measured = [&](const Vector3d& from, const Vector3d& along) {
    return reach(**model, *data, from, along, color);
  };
  for (const double y : {-700., 700.}) {
    EXPECT_NEAR(measured({0, y, 50}, {1, 0, 0}), f.xGroundline, 1e-6);
    EXPECT_NEAR(measured({0, y, 50}, {-1, 0, 0}), f.xGroundline, 1e-6);
  }
  EXPECT_NEAR(measured({300, 0, 50}, {0, 1, 0}), f.ySideline, 1e-6);
  EXPECT_NEAR(measured({300, 0, f.wallHeight - 1}, {0, -1, 0}), f.ySideline, 1e-6);
  EXPECT_GT(measured({300, 0, f.wallHeight + 1}, {0, -1, 0}), f.ySideline + 100);
  for (const double y : {-f.yGoal + 1, 0., f.yGoal - 1}) {
    EXPECT_NEAR(measured({0, y, 50}, {1, 0, 0}), f.xGoalBack, 1e-6);
    EXPECT_EQ(color, "skyblue");
    EXPECT_NEAR(measured({0, y, f.goalHeight - 1}, {-1, 0, 0}), f.xGoalBack, 1e-6);
    EXPECT_EQ(color, "yellow");
  }
  EXPECT_NEAR(measured({f.xGroundline + 100, 0, 50}, {0, 1, 0}), f.yGoal, 1e-6);
  EXPECT_EQ(color, "skyblue");
  // The corner's slope: from where it leaves the side wall to where it meets the ground line.
  const double middle = (f.xSideCorner + f.xGroundline) / 2;
  EXPECT_NEAR(measured({middle, 0, 50}, {0, 1, 0}), (f.ySideCorner + f.ySideline) / 2, 0.02);
  EXPECT_NEAR(measured({-f.xSideCorner - 20, 0, 50}, {0, -1, 0}), f.ySideline - 20, 0.02);
  EXPECT_NEAR(measured({f.xSideCorner - 20, 0, 50}, {0, -1, 0}), f.ySideline, 0.02);
}

TEST(SceneModel, TeamsWearTheirColors) {
  const auto model = composeModel(matchScene());
  ASSERT_TRUE(model);
  std::set<std::string> known{"red",     "blue", "green", "white", "yellow",
                              "skyblue", "pink", "gray",  "black", "orange"};
  for (int geom = 0; geom < (*model)->ngeom; ++geom) {
    EXPECT_EQ(known.count(colorOf(**model, geom)), 1u) << geom << colorOf(**model, geom);
    const char* name = mj_id2name(model->get(), mjOBJ_GEOM, geom);
    if (!std::strstr(name, "/tricot")) continue;
    EXPECT_EQ(colorOf(**model, geom), std::string{name}.substr(0, 3) == "red" ? "red" : "blue");
  }
}

/// Bends a robot's joints, and nothing else.
void pose(const mjModel& model, mjData& data, const RobotParts& parts, const JointAngles& angles) {
  for (std::size_t j = 0; j < enumCount<Joint>; ++j)
    data.qpos[parts.jointAddress.values[j]] = angles.values[j];
  mj_kinematics(&model, &data);
}

TEST(RobotParts, ALegAloneIsWhereMuJoCoHasIt) {
  const auto world = worldOf(duelScene({0.7, 300, -200}, {1000, 0}));
  const mjModel& model = world->model();
  const RobotParts& parts = world->parts(0);
  const ModelData data = makeData(model);
  Random random{3};
  for (int i = 0; i < 100; ++i) {
    const JointAngles angles = randomAngles(random);
    pose(model, *data, parts, angles);
    const Vector3d origin = fromMuJoCo(data->xpos + 3 * parts.body);
    const Matrix3d toBody = rotationFromMuJoCo(data->xmat + 9 * parts.body).transpose();
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const LegPose alone = legPose(model, parts, angles, leg);
      const Vector3d foot = fromMuJoCo(data->site_xpos + 3 * parts.footSites[leg]),
                     knee = fromMuJoCo(data->xpos + 3 * parts.kneeBodies[leg]);
      EXPECT_LT((alone.foot - toBody * (foot - origin)).norm(), 1e-9);
      EXPECT_LT((alone.knee - toBody * (knee - origin)).norm(), 1e-9);
    }
  }
}

TEST(RobotParts, NothingOfARobotGetsBeyondItsReach) {
  const auto world = worldOf(duelScene({0.7, 300, -200}, {1000, 0}));
  const mjModel& model = world->model();
  const RobotParts& parts = world->parts(0);
  const ModelData data = makeData(model);
  Random random{4};
  double furthest = 0;
  for (int i = 0; i < 1000; ++i) {
    pose(model, *data, parts, randomAngles(random));
    const Vector3d origin = fromMuJoCo(data->xpos + 3 * parts.body);
    for (int geom = parts.firstGeom; geom < parts.lastGeom; ++geom)
      furthest = std::max(furthest, (fromMuJoCo(data->geom_xpos + 3 * geom) - origin).norm() +
                                        1000 * model.geom_rbound[geom]);
  }
  EXPECT_LT(furthest, parts.reach);
  EXPECT_GT(furthest, 0.7 * parts.reach) << "it is not so far that nothing is ever out of reach";
}

}  // namespace
}  // namespace gt
