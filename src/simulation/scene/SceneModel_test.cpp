#include "simulation/scene/SceneModel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "simulation/Simulation.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

/// A model as MuJoCo itself reads it from its file.
Model alone(const std::string& path) {
  char message[1000] = "";
  Model model{mj_loadXML(path.c_str(), nullptr, message, sizeof message)};
  EXPECT_TRUE(model) << path << ": " << message;
  return model;
}

/// Compares the things of a model with those of the same name, behind a prefix, in a scene.
class Comparison {
 public:
  Comparison(const mjModel& file, const mjModel& scene, std::string prefix)
      : file_{file}, scene_{scene}, prefix_{std::move(prefix)} {}

  /// Returns how many things were compared.
  int compare() {
    compareBodies();
    compareJoints();
    compareShapes();
    compareOthers();
    comparePoses();
    return count_;
  }

 private:
  /// Calls visit(id in the file, id in the scene) for all of a type that have names.
  template <typename Visit>
  void forEach(mjtObj type, int count, const Visit& visit) {
    for (int id = 0; id < count; ++id) {
      const std::string name = nameOf(file_, type, id);
      if (name.empty() || name == "world") continue;
      what_ = prefix_ + name;
      const int there = mj_name2id(&scene_, type, what_.c_str());
      ASSERT_GE(there, 0) << what_;
      visit(id, there);
      ++count_;
    }
  }
  template <typename T>
  void same(const T* a, const T* b, int width, int id, int there, const char* field) {
    for (int k = 0; k < width; ++k)
      EXPECT_NEAR(static_cast<double>(a[width * id + k]), static_cast<double>(b[width * there + k]),
                  1e-9)
          << what_ << ' ' << field << ' ' << k;
  }
#define SAME(array, width) same(file_.array, scene_.array, width, id, there, #array)

  void compareBodies() {
    forEach(mjOBJ_BODY, file_.nbody, [&](int id, int there) {
      SAME(body_pos, 3);
      SAME(body_quat, 4);
      SAME(body_ipos, 3);
      SAME(body_iquat, 4);
      SAME(body_mass, 1);
      SAME(body_inertia, 3);
      SAME(body_subtreemass, 1);
      SAME(body_invweight0, 2);
      SAME(body_jntnum, 1);
      SAME(body_geomnum, 1);
    });
  }
  void compareJoints() {
    forEach(mjOBJ_JOINT, file_.njnt, [&](int id, int there) {
      SAME(jnt_type, 1);
      SAME(jnt_limited, 1);
      SAME(jnt_pos, 3);
      SAME(jnt_axis, 3);
      SAME(jnt_stiffness, 1);
      SAME(jnt_range, 2);
      EXPECT_NEAR(file_.qpos0[file_.jnt_qposadr[id]], scene_.qpos0[scene_.jnt_qposadr[there]], 1e-9)
          << what_;
      EXPECT_NEAR(file_.qpos_spring[file_.jnt_qposadr[id]],
                  scene_.qpos_spring[scene_.jnt_qposadr[there]], 1e-9)
          << what_;
      id = file_.jnt_dofadr[id];
      there = scene_.jnt_dofadr[there];
      SAME(dof_damping, 1);
      SAME(dof_armature, 1);
      SAME(dof_frictionloss, 1);
      SAME(dof_invweight0, 1);
      SAME(dof_M0, 1);
    });
  }
  void compareShapes() {
    forEach(mjOBJ_GEOM, file_.ngeom, [&](int id, int there) {
      SAME(geom_type, 1);
      SAME(geom_contype, 1);
      SAME(geom_group, 1);
      SAME(geom_size, 3);
      SAME(geom_rbound, 1);
      SAME(geom_pos, 3);
      SAME(geom_quat, 4);
      SAME(geom_friction, 3);
      SAME(geom_solref, 2);
      SAME(geom_margin, 1);
      SAME(geom_gap, 1);
      SAME(geom_rgba, 4);
      if (const int mesh = file_.geom_dataid[id]; mesh >= 0) {
        const int other = scene_.geom_dataid[there];
        ASSERT_EQ(file_.mesh_vertnum[mesh], scene_.mesh_vertnum[other]) << what_;
        for (int k = 0; k < 3 * file_.mesh_vertnum[mesh]; ++k)
          EXPECT_EQ(file_.mesh_vert[3 * file_.mesh_vertadr[mesh] + k],
                    scene_.mesh_vert[3 * scene_.mesh_vertadr[other] + k]);
        EXPECT_EQ(file_.mesh_graphadr[mesh] < 0, scene_.mesh_graphadr[other] < 0) << "a hull";
      }
    });
    forEach(mjOBJ_SITE, file_.nsite, [&](int id, int there) {
      SAME(site_size, 3);
      SAME(site_pos, 3);
      SAME(site_quat, 4);
    });
  }
  void compareOthers() {
    forEach(mjOBJ_CAMERA, file_.ncam, [&](int id, int there) {
      SAME(cam_pos, 3);
      SAME(cam_quat, 4);
      SAME(cam_fovy, 1);
    });
    forEach(mjOBJ_LIGHT, file_.nlight, [&](int id, int there) {
      SAME(light_pos, 3);
      SAME(light_dir, 3);
    });
    forEach(mjOBJ_PAIR, file_.npair, [&](int id, int there) { SAME(pair_friction, 5); });
    forEach(mjOBJ_EXCLUDE, file_.nexclude, [](int, int) {});
    forEach(mjOBJ_EQUALITY, file_.neq, [&](int id, int there) {
      SAME(eq_type, 1);
      SAME(eq_active, 1);
      SAME(eq_data, mjNEQDATA);
    });
    forEach(mjOBJ_TENDON, file_.ntendon, [&](int id, int there) {
      SAME(tendon_limited, 1);
      SAME(tendon_range, 2);
      SAME(tendon_stiffness, 1);
      SAME(tendon_lengthspring, 1);
      SAME(tendon_length0, 1);
    });
    forEach(mjOBJ_SENSOR, file_.nsensor, [&](int id, int there) {
      SAME(sensor_type, 1);
      SAME(sensor_noise, 1);
      EXPECT_EQ(nameOf(scene_, static_cast<mjtObj>(scene_.sensor_objtype[there]),
                       scene_.sensor_objid[there]),
                prefix_ + nameOf(file_, static_cast<mjtObj>(file_.sensor_objtype[id]),
                                 file_.sensor_objid[id]));
    });
  }
  void comparePoses() {
    const ModelData file = makeData(file_), scene = makeData(scene_);
    mj_kinematics(&file_, file.get());
    mj_kinematics(&scene_, scene.get());
    const auto near = [&](const mjtNum* a, const mjtNum* b, int width, int id, int there) {
      for (int k = 0; k < width; ++k)
        EXPECT_NEAR(a[width * id + k], b[width * there + k], 1e-9) << what_;
    };
    forEach(mjOBJ_GEOM, file_.ngeom, [&](int id, int there) {
      near(file->geom_xpos, scene->geom_xpos, 3, id, there);
      near(file->geom_xmat, scene->geom_xmat, 9, id, there);
    });
    forEach(mjOBJ_BODY, file_.nbody, [&](int id, int there) {
      near(file->xpos, scene->xpos, 3, id, there);
      near(file->ximat, scene->ximat, 9, id, there);
    });
  }
#undef SAME

  const mjModel& file_;
  const mjModel& scene_;
  std::string prefix_;
  std::string what_;
  int count_ = 0;
};

/// The scene of a match with two robots of a model.
SceneDescription withRobots(const std::string& model) {
  SceneDescription scene = duelScene({}, {500, 0});
  scene.robots.push_back(scene.robots[0]);
  scene.robots[1].team = TeamColor::blue;
  scene.robots[1].name = "blue1";
  for (SceneRobot& robot : scene.robots) robot.model = fs::absolute(model).string();
  return scene;
}

SceneDescription withField(const std::string& model) {
  SceneDescription scene = duelScene({}, {500, 0});
  scene.field = fs::absolute(model).string();
  return scene;
}

std::vector<std::string> testModels() {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator{"tests/models"})
    if (entry.path().extension() == ".xml") found.push_back(entry.path().string());
  EXPECT_GE(found.size(), 15u);
  return found;
}

TEST(SceneModel, RobotsMeanWhatTheirFileMeansAlone) {
  for (const std::string& path : testModels()) {
    SCOPED_TRACE(path);
    const auto scene = composeModel(withRobots(path));
    ASSERT_TRUE(scene) << scene.error().text();
    const Model file = alone(path);
    for (const char* robot : {"red1/", "blue1/"})
      EXPECT_GT((Comparison{*file, **scene, robot}.compare()), 3);
  }
}

TEST(SceneModel, AFieldMeansWhatItsFileMeansAlone) {
  for (const std::string& path : testModels())
    for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic}) {
      SCOPED_TRACE(path);
      SceneDescription description = withField(path);
      description.fidelity = fidelity;
      const auto scene = composeModel(description);
      ASSERT_TRUE(scene) << scene.error().text();
      EXPECT_GT((Comparison{*alone(path), **scene, ""}.compare()), 3);
      const Model robot = alone("models/ers210.xml");
      EXPECT_GT((Comparison{*robot, **scene, "red1/"}.compare()), 60);
      const Model ball = alone("models/ball.xml");
      EXPECT_GT((Comparison{*ball, **scene, "ball0/"}.compare()), 2);
    }
}

TEST(SceneModel, TheFieldOfAMatchMeansWhatItMeansAlone) {
  SceneDescription scene = matchScene();
  scene.fidelity = Fidelity::dynamic;
  scene.audience = 3;
  const auto model = composeModel(scene);
  ASSERT_TRUE(model) << model.error().text();
  const Model field = alone("models/field2003.xml");
  EXPECT_GT((Comparison{*field, **model, ""}.compare()), 50);
}

/// A folder for files.
class SceneModelFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path{testing::TempDir()} /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream{folder_ / name} << text;
    return (folder_ / name).string();
  }
  /// A model around the inside of its body.
  std::string robot(const std::string& sections, const std::string& inside = "",
                    const std::string& beside = "") {
    return write("robot.xml", "<mujoco>\n" + sections +
                                  "\n<worldbody><body name=\"robot\"><freejoint name=\"pose\"/>"
                                  "<geom name=\"trunk\" size=\"0.1\"/>" +
                                  inside + "</body>" + beside + "</worldbody>\n</mujoco>\n");
  }
  static std::string errorOf(const SceneDescription& scene) {
    const auto model = composeModel(scene);
    return model ? "" : model.error().text();
  }
  static std::vector<std::string> warningsOf(const SceneDescription& scene) {
    std::vector<Error> warnings;
    const auto model = composeModel(scene, Random{}, &warnings);
    EXPECT_TRUE(model) << model.error().text();
    std::vector<std::string> texts;
    for (const Error& warning : warnings) texts.push_back(warning.text());
    return texts;
  }

  fs::path folder_;
};

TEST_F(SceneModelFiles, FilesOfOneNameInTwoFolders) {
  const std::string
      one = write("a/robot.xml",
                  "<mujoco><asset><material name='red' rgba='1 0 0 1'/></asset>"
                  "<worldbody><body name='robot'><freejoint/>"
                  "<geom name='trunk' size='0.1' material='red'/></body></worldbody></mujoco>"),
      other = write("b/robot.xml",
                    "<mujoco><asset><material name='red' rgba='0 1 0 1'/></asset>"
                    "<worldbody><body name='robot'><freejoint/>"
                    "<geom name='trunk' size='0.1' material='red'/></body></worldbody></mujoco>");
  SceneDescription scene = withRobots(one);
  scene.robots[1].model = other;
  const auto model = composeModel(scene);
  ASSERT_TRUE(model) << model.error().text();
  const auto green = [&](const char* geom) {
    const int id = mj_name2id(model->get(), mjOBJ_GEOM, geom);
    return (*model)->mat_rgba[4 * (*model)->geom_matid[id] + 1];
  };
  EXPECT_EQ(green("red1/trunk"), 0);
  EXPECT_EQ(green("blue1/trunk"), 1);
}

TEST_F(SceneModelFiles, WhatIsLeftOutIsSaid) {
  const std::string path = robot(
      "<option timestep='0.01'/>\n<visual/>\n<custom><numeric name='n' data='1'/></custom>\n"
      "<keyframe><key name='k'/></keyframe>\n"
      "<actuator><motor name='push' joint='arm'/></actuator>\n"
      "<sensor><jointpos joint='arm'/><actuatorfrc actuator='push'/><force site='s'/></sensor>\n"
      "<contact><exclude body1='robot' body2='box'/></contact>",
      "<body name='part'><joint name='arm'/><geom size='0.1'/><site name='s'/></body>",
      "<geom type='plane' size='1 1 1'/><body name='box'><geom size='0.1'/></body>");
  EXPECT_THAT(warningsOf(withRobots(path)),
              testing::IsSupersetOf(
                  {HasSubstr("robot.xml:2: warning: option: is left out of the scene: "),
                   HasSubstr("robot.xml:3: warning: visual: is left out"),
                   HasSubstr("robot.xml:4: warning: custom: is left out"),
                   HasSubstr("robot.xml:5: warning: keyframe: is left out"),
                   HasSubstr("robot.xml:6: warning: actuator: is left out"),
                   HasSubstr("robot.xml:7: warning: actuatorfrc: is left out of the scene: refers "
                             "to \"push\""),
                   HasSubstr("robot.xml:7: warning: force: is left out"),
                   HasSubstr("robot.xml:8: warning: exclude: is left out of the scene: refers to "
                             "\"box\""),
                   HasSubstr("robot.xml:9: warning: geom: is left out"),
                   HasSubstr("robot.xml:9: warning: body: is left out")}));
}

TEST_F(SceneModelFiles, TheWorldIsTheScenes) {
  const std::string path =
      robot("<equality><weld name='held' body1='robot' body2='world'/></equality>");
  EXPECT_THAT(warningsOf(withRobots(path)), testing::IsEmpty());
  const auto model = composeModel(withRobots(path));
  ASSERT_TRUE(model);
  const int held = mj_name2id(model->get(), mjOBJ_EQUALITY, "blue1/held");
  ASSERT_GE(held, 0);
  EXPECT_EQ((*model)->eq_obj2id[held], 0);
  EXPECT_EQ(nameOf(**model, mjOBJ_BODY, (*model)->eq_obj1id[held]), "blue1/robot");
}

TEST_F(SceneModelFiles, NamesThatMuJoCoTakes) {
  EXPECT_EQ(errorOf(withRobots(robot("", "<geom name='world' size='0.1'/>"))), "");
  const std::string mesh =
      "<mesh file='" + fs::absolute("tests/models/parts/meshes/wedge.stl").string() + "'/>";
  EXPECT_EQ(errorOf(withRobots(robot("<asset>" + mesh + mesh + "</asset>"))), "");
}

TEST_F(SceneModelFiles, OurOwnModelsAreTakenWhole) {
  EXPECT_THAT(warningsOf(matchScene()), testing::IsEmpty());
}

TEST_F(SceneModelFiles, AFieldsOptions) {
  const std::string path =
      write("field.xml",
            "<mujoco>\n<option timestep='0.01' gravity='3 0 -9.81' solver='PGS' cone='elliptic'/>\n"
            "<keyframe><key name='home'/></keyframe>\n"
            "<worldbody><geom type='plane' size='1 1 1'/></worldbody></mujoco>");
  SceneDescription scene = withField(path);
  EXPECT_THAT(warningsOf(scene),
              testing::ElementsAre(HasSubstr("field.xml:2: warning: timestep: is left out"),
                                   HasSubstr("field.xml:2: warning: solver: is left out"),
                                   HasSubstr("field.xml:2: warning: gravity: is left out"),
                                   HasSubstr("field.xml:3: warning: keyframe: is left out")));
  const auto simulation = Simulation::make(scene, 1);
  ASSERT_TRUE(simulation) << simulation.error().text();
  EXPECT_EQ((*simulation)->modelWarnings().size(), 4u);
  const auto model = composeModel(scene);
  ASSERT_TRUE(model);
  EXPECT_EQ((*model)->opt.gravity[0], 0);
  EXPECT_EQ((*model)->opt.cone, mjCONE_ELLIPTIC);
  EXPECT_EQ((*model)->nkey, 0);
}

TEST_F(SceneModelFiles, WhatCannotBeJoinedNamesItsLine) {
  EXPECT_THAT(errorOf(withRobots(robot("<compiler discardvisual='true'/>",
                                       "<geom size='0.1' contype='0' conaffinity='0'/>"))),
              HasSubstr("robot.xml:2: discardvisual: changes what the model consists of"));
  EXPECT_THAT(errorOf(withRobots(robot("<compiler fusestatic='true'/>",
                                       "<body name='part'><geom size='0.1'/></body>"))),
              HasSubstr("robot.xml:2: fusestatic: changes what the model consists of"));
  EXPECT_EQ(errorOf(withRobots(robot("<compiler fusestatic='true'/>"))), "") << "nothing to fuse";
  EXPECT_THAT(errorOf(withRobots(robot("", "\n<camera mode='targetbody' target='box'/>",
                                       "<body name='box'><geom size='0.1'/></body>"))),
              HasSubstr("robot.xml:4: camera: refers to \"box\""));
  EXPECT_THAT(errorOf(withRobots(write("robot.xml", "<mujoco>\n<worldbody/></mujoco>"))),
              HasSubstr("robot.xml:1: worldbody: expected a <body> in it"));
}

TEST_F(SceneModelFiles, TheBlueTeamNeedsABlueMaterial) {
  EXPECT_THAT(errorOf(withRobots(robot("<default><default class='tricot'/></default>",
                                       "\n<geom class='tricot' size='0.1'/>"))),
              HasSubstr("robot.xml:4: material: expected a material \"blue\""));
}

TEST_F(SceneModelFiles, ErrorsOfMuJoCoNameTheUsersLine) {
  write("part.xml", "<mujoco>\n\n\n<geom type='mesh' mesh='absent'/></mujoco>");
  EXPECT_THAT(errorOf(withRobots(robot("", "<include file='part.xml'/>"))),
              HasSubstr("part.xml:4: MuJoCo: "));
  EXPECT_THAT(errorOf(withRobots(robot("\n\n\n<foo/>"))), HasSubstr("robot.xml:5: MuJoCo: "));
  EXPECT_THAT(errorOf(withRobots(robot("<sensor>\n<jointpos joint='absent'/></sensor>"))),
              HasSubstr("robot.xml:3: MuJoCo: "));
  EXPECT_THAT(errorOf(withRobots(robot("\n\n\n<foo/>"))), testing::Not(HasSubstr(", line")));
}

TEST_F(SceneModelFiles, FlagsOfIncludesAndOfBodiesAreRemoved) {
  write("flags.xml", "<mujoco><geom name='flag1' class='flag' size='0.1'/></mujoco>");
  SceneDescription scene = withField(
      write("field.xml",
            "<mujoco><default><default class='flag'><geom type='sphere'/></default></default>"
            "<worldbody><geom type='plane' size='1 1 1'/><include file='flags.xml'/>"
            "<body childclass='flag'><geom name='flag2' size='0.1'/></body></worldbody></mujoco>"));
  const auto find = [&](const char* name) {
    const auto model = composeModel(scene);
    EXPECT_TRUE(model) << model.error().text();
    return mj_name2id(model->get(), mjOBJ_GEOM, name);
  };
  EXPECT_GE(find("flag1"), 0);
  EXPECT_GE(find("flag2"), 0);
  scene.flags = false;
  EXPECT_EQ(find("flag1"), -1);
  EXPECT_EQ(find("flag2"), -1);
}

TEST_F(SceneModelFiles, WhatTheFieldStatesOfTheWholeIsKept) {
  // Another unit than the scene's: numbers are copied, and MuJoCo derives again what follows.
  SceneDescription scene = withField(
      write("field.xml",
            "<mujoco><compiler angle='radian'/><statistic extent='7' center='1 2 3'/><worldbody>"
            "<geom type='plane' size='1 1 1'/><geom size='1 1 1' type='box' euler='0 0 1'/>"
            "</worldbody></mujoco>"));
  const auto model = composeModel(scene);
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ((*model)->stat.extent, 7);
  EXPECT_EQ((*model)->stat.center[2], 3);
}

TEST_F(SceneModelFiles, MeshesOfTwoMindsAreRefused) {
  SceneDescription scene = withRobots("tests/models/convexhull.xml");
  scene.robots[1].model = fs::absolute("tests/models/degree.xml").string();
  EXPECT_THAT(errorOf(scene), HasSubstr("convexhull: expected "));
}

}  // namespace
}  // namespace gt
