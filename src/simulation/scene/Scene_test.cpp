#include "simulation/scene/Scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

#include "simulation/Simulation.h"
#include "simulation/scene/SceneModel.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A folder for wrong files.
class WrongFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path{testing::TempDir()} /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& text, const std::string& name = "wrong.scene") {
    const auto path = folder_ / name;
    std::ofstream{path} << text;
    return path.string();
  }
  /// The error that a scene's text gives.
  Error errorOf(const std::string& text) {
    const auto scene = loadScene(write(text));
    if (!scene) return scene.error();
    const auto model = composeModel(*scene);
    return model ? Error{} : model.error();
  }

  std::filesystem::path folder_;
};

TEST(Scene, MatchHasTwoTeams) {
  const SceneDescription scene = matchScene();
  ASSERT_EQ(scene.robots.size(), 8u);
  EXPECT_EQ(scene.robots[0].name, "red1");
  EXPECT_EQ(scene.robots[7].name, "blue4");
  EXPECT_EQ(scene.robots[4].player().role, PlayerRole::goalie);
  EXPECT_NEAR(scene.robots[4].pose().rotation, -pi, 1e-9);
  EXPECT_EQ(scene.balls.size(), 1u);
  EXPECT_EQ(scene.resolve("../config"), "config");
}

TEST(Scene, AllScenesOfTheRepositoryLoad) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator{"scenes"}) {
    if (entry.path().extension() != ".scene") continue;
    ++scenes;
    const auto scene = loadScene(entry.path().string());
    ASSERT_TRUE(scene) << scene.error().text();
    const auto model = composeModel(*scene);
    EXPECT_TRUE(model) << model.error().text();
    const auto found = findSceneFiles(*scene);
    EXPECT_TRUE(found) << found.error().text();
  }
  EXPECT_GE(scenes, 3);
}

TEST(Scene, PeopleStandWhereTheyAreMeantTo) {
  SceneDescription scene = matchScene();
  scene.audience = 40;
  scene.referees = 3;
  const auto model = composeModel(scene);
  ASSERT_TRUE(model) << model.error().text();
  const auto geom = [&](const std::string& name) {
    return mj_name2id(model->get(), mjOBJ_GEOM, name.c_str());
  };
  const auto place = [&](int id) {
    return Vector2d{(*model)->geom_pos[3 * id], (*model)->geom_pos[3 * id + 1]};
  };
  for (int i = 0; i < scene.audience; ++i) {
    const int shirt = geom("audience" + std::to_string(i) + "/shirt");
    ASSERT_GE(shirt, 0);
    EXPECT_TRUE(std::abs(place(shirt).x()) > 3.5 || std::abs(place(shirt).y()) > 2.6);
    EXPECT_EQ((*model)->geom_contype[shirt], 0);
  }
  EXPECT_EQ(geom("audience40/shirt"), -1);
  for (int i = 0; i < scene.referees; ++i) {
    const int leg = geom("referee" + std::to_string(i) + "/left");
    ASSERT_GE(leg, 0);
    EXPECT_LT(std::abs(place(leg).x()), 2.1);
    EXPECT_LT(std::abs(place(leg).y()), 1.35);
    EXPECT_EQ((*model)->geom_group[leg], 2) << "what robots run into";
  }
  const auto again = composeModel(scene);
  ASSERT_TRUE(again);
  const mjtNum* positions = (*model)->geom_pos;
  EXPECT_TRUE(std::equal(positions, positions + 3 * (*model)->ngeom, (*again)->geom_pos));
}

TEST(Scene, TheAudienceIsAnotherForEachSeedAndWearsAllColors) {
  SceneDescription scene = matchScene();
  scene.audience = 8;
  const auto people = [&](std::uint64_t seed) {
    std::set<std::array<float, 3>> colors;
    std::vector<double> places;
    const auto model = composeModel(scene, Random{seed});
    for (int i = 0; i < scene.audience; ++i) {
      const std::string name = "audience" + std::to_string(i) + "/shirt";
      const int shirt = mj_name2id(model->get(), mjOBJ_GEOM, name.c_str());
      const float* rgba = (*model)->geom_rgba + 4 * shirt;
      colors.insert({rgba[0], rgba[1], rgba[2]});
      places.push_back((*model)->geom_pos[3 * shirt]);
    }
    return std::pair{colors, places};
  };
  const auto [colors, places] = people(1);
  EXPECT_EQ(colors.size(), 8u);
  EXPECT_NE(places, people(2).second);
}

// Who has a simulation's seed sees its people, also after its fidelity has changed.
TEST(Scene, ASimulationsSeedPlacesItsAudience) {
  SceneDescription scene = matchScene();
  scene.audience = 3;
  const auto placeIn = [](const Simulation& simulation) {
    const mjModel& model = simulation.world().model();
    return model.geom_pos[3 * mj_name2id(&model, mjOBJ_GEOM, "audience2/shirt")];
  };
  const auto first = Simulation::make(scene, 1), second = Simulation::make(scene, 2);
  ASSERT_TRUE(first && second);
  const double place = placeIn(**first);
  EXPECT_NE(place, placeIn(**second));
  ASSERT_TRUE((*first)->changeFidelity(Fidelity::dynamic));
  EXPECT_EQ(placeIn(**first), place);
}

TEST_F(WrongFiles, MissingScene) {
  const auto scene = loadScene("scenes/nowhere.scene");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().text(), "scenes/nowhere.scene: there is no such file");
  EXPECT_EQ(loadScene("scenes").error().text(), "scenes: is a folder");
}

TEST_F(WrongFiles, Garbage) {
  for (const std::string text : {"", "\xff\xfe\x00garbage", "<scene", "not xml at all", "<a/>"})
    EXPECT_THAT(errorOf(text).text(), HasSubstr("wrong.scene")) << text;
}

TEST_F(WrongFiles, TruncatedAnywhereIsAnErrorWithTheFile) {
  std::ifstream file{"scenes/match.scene"};
  const std::string whole{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t end = whole.rfind("</scene>");
  for (std::size_t length = 0; length < end + 7; length += 41) {
    const auto scene = loadScene(write(whole.substr(0, length)));
    ASSERT_FALSE(scene) << length;
    EXPECT_THAT(scene.error().file, HasSubstr("wrong.scene"));
    EXPECT_FALSE(scene.error().what.empty());
  }
}

TEST_F(WrongFiles, NamesFileLineAndField) {
  const auto expectError = [&](const std::string& text, int line, const std::string& field,
                               const std::string& what) {
    const Error error = errorOf(text);
    EXPECT_EQ(error.line, line) << error.text();
    EXPECT_EQ(error.field, field) << error.text();
    EXPECT_THAT(error.what, HasSubstr(what));
  };
  expectError("<scene>\n<robbots/>\n</scene>", 2, "robbots", "<noise>");
  expectError("<scene>\n<noise\njoint=\"1\"/></scene>", 3, "joint", "no such attribute");
  expectError("<scene>\n<noise joints=\"many\"/></scene>", 2, "joints", "expected a number");
  expectError("<scene>\n<noise joints=\"nan\"/></scene>", 2, "joints", "must be from 0");
  expectError("<scene>\n<optics centerX=\"nan\"/></scene>", 2, "centerX", "expected a number");
  expectError("<scene>\n<radio loss=\"1.5\"/></scene>", 2, "loss", "must be from");
  expectError("<scene>\n<radio delayMin=\"300\"/></scene>", 2, "delayMin", "greater");
  expectError("<scene\naudience=\"-1\"/>", 2, "audience", "must be from");
  expectError("<scene\nreferees=\"1.5\"/>", 2, "referees", "whole number");
  expectError("<scene>\n<game referee=\"maybe\"/></scene>", 2, "referee", "true | false");
  expectError("<scene>\n<robots>\n<robot team=\"green\"/></robots></scene>", 3, "team",
              "red | blue");
  expectError("<scene>\n<robots>\n<robot>\n<leg/></robot></robots></scene>", 4, "leg",
              "no content");
  expectError("<scene><robots><robot/>\n<robot/></robots></scene>", 2, "name", "red1");
  expectError("<scene><robots><robot/>\n<robot name=\"x\"/></robots></scene>", 2, "role", "goalie");
  expectError("<scene><robots>\n<ball/></robots></scene>", 2, "ball", "expected <robot>");
  expectError("<scene><balls/>\n<balls/></scene>", 2, "balls", "a second <balls>");
  expectError("<scene>\n<optics width=\"2000\"/></scene>", 2, "width", "at most 1280");
  expectError("<scene>\n<optics distortion2=\"-2\"/></scene>", 2, "distortion2", "must be from");
  expectError("<scene>\n<optics height=\"240\"/></scene>", 2, "rowTime", "longer than 40");
  expectError("<scene fidelity=\"dreamlike\"/>", 1, "fidelity", "kinematic");
  expectError("<scene>\n<ballz>\n<ball/></ballz></scene>", 2, "ballz", "<balls>");
  expectError("<scene\nfield=\"gone.xml\"/>", 2, "field", "there is no file");
}

TEST_F(WrongFiles, FilesThatAreMissingAreNamedWithTheScene) {
  const auto reportedOf = [&](const std::string& attributes, const std::string& robot) {
    const auto scene = loadScene(
        write("<scene\n" + attributes + ">\n<robots>\n<robot " + robot + "/></robots></scene>"));
    EXPECT_TRUE(scene);
    const auto found = findSceneFiles(*scene);
    if (found) return std::string{"nothing"};
    EXPECT_THAT(found.error().file, HasSubstr("wrong.scene"));
    return std::to_string(found.error().line) + ": " + found.error().field;
  };
  const std::string config = "config='" + std::filesystem::absolute("config").string() + "'",
                    layout =
                        "layout='" + std::filesystem::absolute("layouts/cmd.layout").string() + "'";
  EXPECT_EQ(reportedOf(config, layout), "nothing");
  EXPECT_EQ(reportedOf("config='nowhere'", layout), "2: config");
  EXPECT_EQ(reportedOf(config + "\nscript='mine'", layout), "3: script");
  EXPECT_EQ(reportedOf(config, "layout='none.layout'"), "4: layout");
  // Attributes that nobody wrote have a default, which is named.
  const auto unwritten = loadScene(write("<scene/>"));
  ASSERT_TRUE(unwritten);
  EXPECT_THAT(findSceneFiles(*unwritten).error().what, HasSubstr("; ../config is the attribute's"));
  EXPECT_THAT(composeModel(*unwritten).error().what, HasSubstr("; ../models/field2003.xml is the"));
  write("# nothing", "mine.con");
  EXPECT_EQ(reportedOf(config + "\nscript='mine'", layout), "nothing") << "has the extension .con";
}

TEST_F(WrongFiles, NamesTheColumn) {
  const auto reported = [&](const std::string& text) {
    const std::string error = errorOf(text).text();
    return error.substr(error.find("wrong.scene") + 11);
  };
  EXPECT_EQ(reported("<scene>\n  <noise psd='1' joints = \"many\"/></scene>"),
            ":2:18: joints: expected a number, found \"many\"");
  EXPECT_EQ(reported("<scene><!-- <a b=''> -->\n<robots> <robot/>\t<leg/></robots></scene>"),
            ":2:19: leg: expected <robot>");
  EXPECT_EQ(reported("<?xml version='1.0'?>\n<scene><!-- \xc3\xa4 --><noise psd='-1'/></scene>"),
            ":2:25: psd: must be from 0 to 1000");
  EXPECT_EQ(reported("<scene>\n<robots>\n  here\n</robots></scene>"),
            ":3:3: text: expected <robot>");
  EXPECT_EQ(reported("<scene><robots><robot/> <robot/></robots></scene>"),
            ":1:25: name: a second robot \"red1\"");
  EXPECT_THAT(reported("<scene>\n <noise <</scene>"), StartsWith(":2:10: "));
  const std::string field = std::filesystem::absolute("models/field2003.xml").string();
  EXPECT_THAT(
      reported("<scene field='" + field + "'><balls>\n  <ball model='gone.xml'/></balls></scene>"),
      StartsWith(":2:3: model: there is no file"));
}

TEST_F(WrongFiles, TooManyAreTold) {
  const auto sceneOf = [](const char* group, const std::string& entry, int count) {
    std::string text = std::string{"<scene><game referee='false'/><"} + group + ">\n";
    for (int i = 0; i < count; ++i) {
      std::string line = entry;
      if (const auto at = line.find('#'); at != line.npos) line.replace(at, 1, std::to_string(i));
      text += line + "\n";
    }
    return text + "</" + group + "></scene>";
  };
  EXPECT_TRUE(loadScene(write(sceneOf("robots", "<robot name='r#'/>", 22))));
  const Error robots = errorOf(sceneOf("robots", "<robot name='r#'/>", 23));
  EXPECT_EQ(robots.line, 24);
  EXPECT_THAT(robots.what, HasSubstr("one more than 22"));
  EXPECT_TRUE(loadScene(write(sceneOf("balls", "<ball/>", 100))));
  const Error balls = errorOf(sceneOf("balls", "<ball/>", 101));
  EXPECT_EQ(balls.line, 102);
  EXPECT_THAT(balls.what, HasSubstr("one more than 100"));
}

TEST_F(WrongFiles, APassiveRobotIsActivatedByMovingItsEntry) {
  std::ifstream file{"scenes/obstacle-challenge.scene"};
  std::string text{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t begin = text.find("<robot name=\"obstacle1\""),
                    end = text.find("/>", begin) + 2;
  const std::string entry = text.substr(begin, end - begin);
  text.erase(begin, end - begin);
  text.insert(text.find("</robots>"), entry);
  auto scene = loadScene(write(text));
  ASSERT_TRUE(scene) << scene.error().text();
  scene->file = "scenes/moved.scene";  // where its models are
  const auto world = worldOf(*scene);
  EXPECT_EQ(world->activeRobots(), 2u);
  EXPECT_EQ(world->robotCount(), 8u);
}

TEST(Scene, AnyNumberOfRobotsAndBallsMoves) {
  const SceneDescription match = matchScene();
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic})
    for (const auto& [robots, balls] : {std::pair{0, 0}, {0, 3}, {1, 0}, {22, 10}}) {
      SceneDescription scene = match;
      scene.fidelity = fidelity;
      scene.robots.clear();
      scene.balls.assign(static_cast<std::size_t>(balls), match.balls[0]);
      for (int i = 0; i < balls; ++i) scene.balls[static_cast<std::size_t>(i)].x = 100 * i;
      for (int i = 0; i < robots; ++i) {
        SceneRobot robot = match.robots[0];
        robot.name = "robot" + std::to_string(i);
        robot.x = -1500 + 300 * (i % 11);
        robot.y = i < 11 ? -900 : 900;
        scene.robots.push_back(robot);
      }
      const auto world = worldOf(scene);
      const std::vector<RobotCommand> commands(world->activeRobots(), standingCommand());
      for (int i = 0; i < 25; ++i) world->step(commands);
      EXPECT_EQ(world->robotCount(), static_cast<std::size_t>(robots));
      EXPECT_EQ(world->ballCount(), static_cast<std::size_t>(balls));
      EXPECT_EQ(world->time().ms, 200);
    }
}

TEST_F(WrongFiles, AllErrorsAreTold) {
  std::vector<Error> errors;
  const SceneDescription scene =
      loadScene(write("<scene wrong=\"1\">\n<noise joints=\"x\" joint=\"1\"/>\n"
                      "<nonsense/>\n<radio delayMin=\"9\" delayMax=\"1\"/>\n"
                      "<robots>\n<robot x=\"far\" y=\"5\"/>\n<ball/>\n"
                      "<robot bodyTilt=\"21\"/>\n</robots>\n</scene>"),
                errors);
  std::vector<std::pair<int, std::string>> places;
  for (const Error& error : errors) places.emplace_back(error.line, error.field);
  EXPECT_THAT(places, testing::UnorderedElementsAre(std::pair{1, "wrong"}, std::pair{2, "joints"},
                                                    std::pair{2, "joint"}, std::pair{3, "nonsense"},
                                                    std::pair{4, "delayMin"}, std::pair{6, "x"},
                                                    std::pair{7, "ball"}, std::pair{8, "bodyTilt"},
                                                    std::pair{8, "name"}, std::pair{8, "role"}));
  ASSERT_EQ(scene.robots.size(), 2u);
  EXPECT_EQ(scene.robots[0].y, 5);
  EXPECT_EQ(loadScene((folder_ / "wrong.scene").string()).error().text(), errors.front().text());
}

TEST_F(WrongFiles, MissingAndBrokenModels) {
  Error error = errorOf("<scene field=\"gone.xml\"/>");
  EXPECT_EQ(error.field, "field");
  EXPECT_THAT(error.what, HasSubstr("gone.xml"));

  const std::string field = std::filesystem::absolute("models/field2003.xml").string();
  const std::string begin = "<scene field=\"" + field + "\">\n<robots>\n<robot model=\"";
  error = errorOf(begin + "gone.xml\"/></robots></scene>");
  EXPECT_EQ(error.line, 3);
  EXPECT_EQ(error.field, "model");

  write("<mujoco><worldbody/></mujoco>", "empty.xml");
  EXPECT_EQ(errorOf(begin + "empty.xml\"/></robots></scene>").field, "worldbody");

  write(
      "<mujoco><worldbody><body name=\"robot\">\n<geom type=\"tetrahedron\"/></body></worldbody>"
      "</mujoco>",
      "odd.xml");
  error = errorOf(begin + "odd.xml\"/></robots></scene>");
  EXPECT_THAT(error.what, HasSubstr("MuJoCo"));
  EXPECT_THAT(error.file, HasSubstr("odd.xml"));
  EXPECT_EQ(error.line, 2);

  // A model that MuJoCo takes and that is no robot.
  write(
      "<mujoco><worldbody><body name=\"robot\"><freejoint name=\"pose\"/><geom size=\"1\"/></body>"
      "</worldbody></mujoco>",
      "ball.xml");
  const auto scene = loadScene(write(begin + "ball.xml\"/></robots></scene>"));
  ASSERT_TRUE(scene);
  const auto world = makeWorld(*scene, Random{1});
  ASSERT_FALSE(world);
  EXPECT_THAT(world.error().what, HasSubstr("headTilt"));
}

TEST_F(WrongFiles, AModelWithOtherJointsIsRefused) {
  std::ifstream file{"models/ers210.xml"};
  const std::string whole{std::istreambuf_iterator<char>{file}, {}};
  const auto errorWith = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    write(text, "robot.xml");
    SceneDescription scene = duelScene({}, {500, 0});
    scene.robots[0].model = (folder_ / "robot.xml").string();
    const auto world = makeWorld(scene, Random{1});
    return world ? std::string{} : world.error().text();
  };
  EXPECT_THAT(errorWith("<joint name=\"legFL3\"", "<joint type=\"slide\" name=\"legFL3\""),
              HasSubstr("robot.xml: red1: the robot's model has no \"legFL3\", a hinge"));
  EXPECT_THAT(errorWith("<freejoint name=\"pose\"/>", "<joint name=\"pose\" range=\"-1 1\"/>"),
              HasSubstr("\"pose\", a free joint"));
  EXPECT_THAT(errorWith("<site name=\"camera\"", "<site name=\"eye\""), HasSubstr("\"camera\""));
  EXPECT_EQ(errorWith("<site name=\"camera\"", "<site name=\"camera\""), "");
}

TEST_F(WrongFiles, AFieldAndBallsOfAnotherKind) {
  const auto variant = [&](const std::string& model, const std::string& from,
                           const std::string& to) {
    std::ifstream file{"models/" + model};
    std::string text{std::istreambuf_iterator<char>{file}, {}};
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    write(text.replace(at, from.size(), to), model);
    return (folder_ / model).string();
  };
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic}) {
    SceneDescription scene = duelScene({0, -1500, -800}, {0, 0});
    scene.fidelity = fidelity;
    // The left wall's inner side is half a meter nearer than on the field of 2003.
    scene.field = variant("field2003.xml", "pos=\"0 1.4 0.05\"", "pos=\"0 0.9 0.05\"");
    scene.balls[0].model = variant("ball.xml", "size=\"0.043\"", "size=\"0.08\"");
    const auto world = worldOf(scene);
    const std::vector<RobotCommand> commands(1, standingCommand());
    world->placeBall(0, {0, 300}, {0, 1000});
    double farthest = 0;
    for (int i = 0; i < 125; ++i) {
      world->step(commands);
      farthest = std::max(farthest, world->ball(0).position.y());
    }
    EXPECT_NEAR(farthest, 850 - 80, 15);
    EXPECT_LT(world->ball(0).speed.y(), 0);
  }
}

TEST(Scene, TwentyTwoRobotsAndTenBalls) {
  SceneDescription scene = matchScene();
  for (int i = 0; i < 14; ++i) {
    SceneRobot robot = scene.robots[0];
    robot.name = "extra" + std::to_string(i);
    robot.x = -1500 + 220 * i;
    robot.y = 1000;
    scene.extras.push_back(robot);
  }
  for (int i = 0; i < 9; ++i) {
    SceneBall ball;
    ball.x = -900 + 200 * i;
    ball.y = -1000;
    scene.balls.push_back(ball);
  }
  const auto world = worldOf(scene);
  EXPECT_EQ(world->robotCount(), 22u);
  EXPECT_EQ(world->activeRobots(), 8u);
  EXPECT_EQ(world->ballCount(), 10u);
}

}  // namespace
}  // namespace gt
