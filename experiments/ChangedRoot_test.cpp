#include "ChangedRoot.h"

#include <gmock/gmock.h>

#include "base/File.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "robot/Configuration.h"
#include "streams/Config.h"

namespace gt {
namespace {

std::string errorOf(const std::string& values) {
  const auto made = ChangedRoot::make({}, values);
  return made ? "" : made.error().text();
}

TEST(ChangedRoot, HasOtherParametersAndSolutions) {
  const auto made = ChangedRoot::make(
      {}, "WalkingEngine.InvKin.normal.stepLen=52,SelfLocator=GT2003,SelfLocator.Kalman.slip=0.5");
  ASSERT_TRUE(made) << made.error().text();
  const DataRoot root = (*made)->root();
  WalkTypes before, after;
  ASSERT_TRUE(readConfig("config/modules/WalkingEngine.InvKin.cfg", before));
  ASSERT_TRUE(readConfig(root.path("config/modules/WalkingEngine.InvKin.cfg"), after));
  EXPECT_NE(before.normal.stepLen, 52);
  EXPECT_EQ(after.normal.stepLen, 52);
  EXPECT_EQ(after.normal.maxStepSizeX, before.normal.maxStepSizeX);
  const auto configuration = loadConfiguration(ConfigurationPaths::in(root));
  ASSERT_TRUE(configuration) << configuration.error().text();
  const auto& choices = (*configuration)->solutions;
  const auto locator =
      std::ranges::find(choices, "SelfLocator", &Configuration::SolutionChoice::task);
  ASSERT_NE(locator, choices.end());
  EXPECT_EQ(locator->solution, "GT2003");
  EXPECT_EQ(std::ranges::count(choices, "SelfLocator", &Configuration::SolutionChoice::task), 1);
}

TEST(ChangedRoot, ReadsFilesAsOtherMachinesWriteThem) {
  const auto first = ChangedRoot::make({}, "WalkingEngine.InvKin.normal.stepLen=51");
  ASSERT_TRUE(first) << first.error().text();
  const std::string file = (*first)->root().path("config/modules/WalkingEngine.InvKin.cfg");
  const auto text = readFile(file);
  ASSERT_TRUE(text) << text.error().text();
  std::string other = "\xEF\xBB\xBF";
  for (const char c : *text) other += c == '\n' ? "\r\n" : std::string(1, c);
  ASSERT_TRUE(writeFile(file, other));
  const auto second = ChangedRoot::make((*first)->root(), "WalkingEngine.InvKin.normal.stepLen=52");
  ASSERT_TRUE(second) << second.error().text();
  WalkTypes after;
  ASSERT_TRUE(readConfig((*second)->root().path("config/modules/WalkingEngine.InvKin.cfg"), after));
  EXPECT_EQ(after.normal.stepLen, 52);
}

TEST(ChangedRoot, HasMotionsWithOtherValues) {
  const auto made = ChangedRoot::make({}, "motions.pushStrong.ready-frames=71");
  ASSERT_TRUE(made) << made.error().text();
  ASSERT_EQ((*made)->files(), std::vector<std::string>{"motions/kicks/pushStrong.mof"});
  const auto slow = loadMotionNet((*made)->root().path("motions")), fast = loadMotionNet("motions");
  ASSERT_TRUE(slow && fast);
  const auto longest = [](const MotionNet& net) {
    int frames = 0;
    for (const MotionNet::Node& node : net.nodes)
      if (node.motion == net.find("pushStrong")) frames = std::max(frames, node.frames);
    return frames;
  };
  EXPECT_NE(longest(*fast), 71);
  EXPECT_EQ(longest(*slow), 71);
}

/// A team with a motion and a parameter of its own.
class TeamOfOneKick {
 public:
  TeamOfOneKick() {
    for (const char* part : {"motions/kicks", "config/modules"})
      std::filesystem::create_directories(folder_.path() / part);
    write("motions/kicks/tap.mof",
          "motion_id = tap\nvalue lift-frames = 20\nlabel start\n"
          "posture stand 1 lift-frames\ntransition allMotions extern start\n");
    write(
        "motions/kicks/pause.mof",
        "motion_id = pause\nlabel start\nposture stand 1 9\ntransition allMotions extern start\n");
    write("config/modules/SelfLocator.Kalman.cfg", "slip 0.25\ndrift 3\n");
    write("config/modules.cfg", "SelfLocator Kalman\n");
  }
  std::string path() const { return folder_.path().string(); }

 private:
  void write(const std::string& name, const std::string& text) {
    ASSERT_TRUE(writeFile((folder_.path() / name).string(), text));
  }
  TemporaryFolder folder_;
};

TEST(ChangedRoot, ChangesTheFilesOfATeam) {
  const TeamOfOneKick team;
  const std::string own = "motions.tap.lift-frames=71,SelfLocator.Kalman.slip=0.5";
  EXPECT_EQ(errorOf(own), "motions.tap.lift-frames: there is no such motion");
  const auto made = ChangedRoot::make(
      {}, own + ",motions.pushStrong.ready-frames=71,SelfLocator=GT2003", team.path());
  ASSERT_TRUE(made) << made.error().text();
  const DataRoot root = (*made)->root();
  const auto textOf = [&](const std::string& file) { return *readFile(root.path(file)); };
  EXPECT_THAT((*made)->files(),
              testing::IsSupersetOf({"motions/kicks/tap.mof", "motions/kicks/pushStrong.mof",
                                     "config/modules/SelfLocator.Kalman.cfg"}));
  EXPECT_THAT(textOf("motions/kicks/tap.mof"), testing::HasSubstr("value lift-frames = 71\n"));
  EXPECT_EQ(textOf("config/modules/SelfLocator.Kalman.cfg"), "slip 0.5\ndrift 3\n");
  const auto net = loadMotionNet(root.path("motions"));
  ASSERT_TRUE(net) << net.error().text();
  EXPECT_GE(net->find("tap"), 0);
  const auto configuration = loadConfiguration(ConfigurationPaths::in(root));
  ASSERT_TRUE(configuration) << configuration.error().text();
  std::vector<std::string> locators;
  for (const auto& choice : (*configuration)->solutions)
    if (choice.task == "SelfLocator") locators.push_back(choice.solution);
  ASSERT_FALSE(locators.empty());
  EXPECT_EQ(locators.back(), "GT2003") << "the team's choice counts, and is the changed one";
  const auto named = [&](const std::string& file) {
    return (*made)->named({.file = root.path(file), .what = "wrong"}).file;
  };
  EXPECT_EQ(named("config/modules.team.cfg"), "config/modules.team.cfg") << "it is a changed one";
  EXPECT_EQ(named("motions/kicks/pause.mof"), team.path() + "/motions/kicks/pause.mof");
  EXPECT_EQ(named("config/log.cfg"), "config/log.cfg") << "the project's";
  EXPECT_THAT(ChangedRoot::make({}, "", "nobody").error().text(),
              testing::HasSubstr("nobody: is no team"));
}

TEST(ChangedRoot, RefusesWhatDoesNotExist) {
  EXPECT_EQ(errorOf("motions.moonwalk.a=1"), "motions.moonwalk.a: there is no such motion");
  EXPECT_EQ(errorOf("motions.pushStrong.speed=1"),
            "motions/kicks/pushStrong.mof: has not all of the values");
  EXPECT_EQ(errorOf("Walk=InvKin"), "Walk: there is no such task");
  EXPECT_EQ(errorOf("SelfLocator=Best"), "SelfLocator: there is no solution 'Best'");
  EXPECT_EQ(errorOf("WalkingEngine.InvKin=3"), "WalkingEngine.InvKin: expected TASK.SOLUTION.PATH");
  EXPECT_THAT(errorOf("WalkingEngine.InvKin.normal.stepLength=3"),
              testing::StartsWith("WalkingEngine.InvKin.normal.stepLength: "));
  EXPECT_THAT(errorOf("WalkingEngine.InvKin.normal.stepLen=1"),
              testing::StartsWith("WalkingEngine.InvKin.normal.stepLen: "));
  EXPECT_THAT(errorOf("LEDControl"), testing::HasSubstr("expected TASK=SOLUTION"));
  EXPECT_THAT(errorOf("LEDControl=disabled,LEDControl=Default"),
              testing::HasSubstr("is given twice"));
}

}  // namespace
}  // namespace gt
