#include "robot/platform/Platform.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/platform/Body.h"

namespace gt {
namespace {

std::vector<std::string> namesOf(const std::vector<const RepresentationType*>& types) {
  std::vector<std::string> names;
  for (const RepresentationType* type : types) names.emplace_back(type->name);
  return names;
}

/// No body senses the truth.
TEST(Platform, ListsWhatABodyGivesAndTakes) {
  EXPECT_THAT(
      namesOf(platformRepresentations()),
      ::testing::ElementsAre("SensorDataBuffer", "GameControlData", "TeamMessages", "Image"));
  EXPECT_EQ(namesOf(representationsWithTruth()).back(), "OracledWorldState");
  EXPECT_THAT(namesOf(commandRepresentations()),
              ::testing::ElementsAre("JointData", "OdometryData", "LedValue", "JointGains",
                                     "Speaker", "TeamMessage", "CameraSettings"));
}

TEST(Platform, AnImageComesLastAndWithAllThatBelongsToIt) {
  RobotInput input;
  const Image image;
  std::vector<std::string> sent;
  const auto send = [&](const auto& package) {
    sent.emplace_back(typeName<std::remove_cvref_t<decltype(package)>>());
  };
  input.forEach(send);
  EXPECT_THAT(sent, ::testing::ElementsAre("SensorDataBuffer"));
  sent.clear();
  input.image = &image;
  input.forEach(send);
  EXPECT_EQ(sent, namesOf(platformRepresentations()));
}

TEST(Platform, ACommandComesFromWhoProvidesItOrReadsImages) {
  const Task odometry{"Walk", {&representation<OdometryData>()}, {}};
  Plan plan;
  plan.processes.resize(2);
  plan.processes[0].layout.name = "See";
  plan.processes[1].layout.name = "Walk";
  plan.processes[1].order = {{&odometry, nullptr}};
  plan.connections = {{&representation<SensorDataBuffer>(), "", "Walk", true},
                      {&representation<Image>(), "", "See", true}};
  EXPECT_EQ(senderOf(plan, representation<OdometryData>()), "Walk");
  EXPECT_EQ(senderOf(plan, representation<CameraSettings>()), "See");
  EXPECT_EQ(senderOf(plan, representation<JointData>()), "");
  EXPECT_EQ(senderOf(plan, representation<Image>()), "");
}

}  // namespace
}  // namespace gt
