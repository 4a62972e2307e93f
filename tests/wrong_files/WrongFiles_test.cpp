#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "Workplace.h"
#include "base/Random.h"

namespace gt {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Break = std::function<std::string(const std::string&)>;

Break truncated(std::size_t size) {
  return [size](const std::string& text) { return text.substr(0, size); };
}

Break truncatedAfter(const std::string& word) {
  return [word](const std::string& text) { return text.substr(0, text.find(word) + word.size()); };
}

Break text(const std::string& content) {
  return [content](const std::string&) { return content; };
}

Break replaced(const std::string& from, const std::string& to) {
  return [from, to](std::string content) {
    const auto at = content.find(from);
    EXPECT_NE(at, content.npos) << from;
    return at == content.npos ? content : content.replace(at, from.size(), to);
  };
}

Break garbage() {
  return [](const std::string&) {
    Random random{1};
    std::string bytes(500, '\0');
    for (char& c : bytes) c = static_cast<char>(random.index(256));
    bytes[0] = '\x07';
    return bytes;
  };
}

/// The file is removed.
const Break missing;

/// A wrong file: how it is broken, which program reads it, and how the line that reports it
/// begins.
struct WrongFile {
  const char* name;
  std::string file;
  Break change;
  std::string program;
  std::string line;
};

void PrintTo(const WrongFile& wrong, std::ostream* stream) {
  *stream << wrong.name;
}

const std::string play = "simgt play scenes/one-robot.scene --minutes 0.01 --no-logs --out out";
const std::string see =
    "replay --log robot.log --colors robot.c64 --labels labels.csv --field-labels field.csv "
    "--out out";
const std::string checkBehavior = "xabsl check behavior/GT2003.xabsl";
const std::string checkMotions = "motionnet check motions";

class WrongFiles : public testing::TestWithParam<WrongFile> {
 protected:
  static void SetUpTestSuite() { workplace = std::make_unique<Workplace>(); }
  static void TearDownTestSuite() { workplace.reset(); }

  static std::unique_ptr<Workplace> workplace;
};
std::unique_ptr<Workplace> WrongFiles::workplace;

TEST_P(WrongFiles, EndWithOneLine) {
  const WrongFile& wrong = GetParam();
  const std::string good = workplace->read(wrong.file);
  if (wrong.change)
    workplace->write(wrong.file, wrong.change(good));
  else
    fs::remove(workplace->root() / wrong.file);
  const Outcome outcome = workplace->run(wrong.program);
  workplace->write(wrong.file, good);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, StartsWith(wrong.line));
  EXPECT_EQ(messages(outcome.errors), 1) << outcome.errors;
}

std::vector<WrongFile> wrongFiles() {
  const std::string scene = "scenes/one-robot.scene", model = "models/ball.xml";
  const std::string layout = "layouts/cmd.layout", logLayout = "layouts/replay.layout";
  const std::string agents = "behavior/GT2003.xabsl", option = "behavior/options/ball/kick.xabsl";
  const std::string mof = "motions/postures/getupFromBelly.mof", table = "config/coltable.c64";
  return {
      {"SceneMissing", scene, missing, play, "simgt: " + scene + ": there is no such file"},
      {"SceneTruncated", scene, truncated(300), play, "simgt: " + scene + ":"},
      {"SceneGarbage", scene, garbage(), play, "simgt: " + scene + ":1:1: "},
      {"SceneWrongName", scene, replaced("team=", "crew="), play, "simgt: " + scene + ":6:12: "},
      {"SceneWrongValue", scene, replaced("x=\"-800\"", "x=\"left\""), play,
       "simgt: " + scene + ":6:39: x: "},
      {"ModelMissing", model, missing, play, "simgt: " + scene + ":9:5: model: "},
      {"ModelGarbage", model, garbage(), play, "simgt: models/ball.xml"},
      {"ModelTruncated", model, truncated(200), play, "simgt: models/ball.xml"},

      {"LayoutMissing", layout, missing, play,
       "simgt: " + scene + ":6:5: layout: there is no file " + layout},
      {"LayoutTruncated", layout, replaced("  SensorDataProcessor\n", ""), play,
       "simgt: " + layout + ":"},
      {"LayoutGarbage", layout, garbage(), play, "simgt: " + layout + ":1: "},
      {"LayoutWrongName", layout, replaced("BallLocator", "BallFinder"), play,
       "simgt: " + layout + ":8: BallFinder: there is no such task"},
      {"LogLayoutMissing", logLayout, missing, see, "replay: " + logLayout + ": "},
      {"LogLayoutWrongName", logLayout, replaced("SelfLocator", "SelfFinder"), see,
       "replay: " + logLayout + ":6: SelfFinder: there is no such task"},

      {"BehaviorMissing", agents, missing, play, "simgt: " + agents + ": "},
      {"BehaviorTruncated", option, truncated(300), play, "simgt: " + option + ":"},
      {"BehaviorGarbage", option, garbage(), play, "simgt: " + agents + ":"},
      {"BehaviorWrongName", agents, replaced("agent ", "agnet "), play, "simgt: " + agents + ":"},
      {"CheckedBehaviorMissing", agents, missing, checkBehavior, agents + ": "},
      {"CheckedBehaviorTruncated", option, truncated(300), checkBehavior, option + ":"},
      {"CheckedBehaviorGarbage", agents, garbage(), checkBehavior, agents + ": "},

      {"MotionMissing", "motions/postures/stand.mof", missing, play, "simgt: motions/"},
      {"MotionTruncated", mof, truncated(144), play, "simgt: " + mof + ": label start: "},
      {"MotionGarbage", mof, garbage(), play, "simgt: " + mof + ":1: "},
      {"MotionWrongName", "motions/postures/sit.mof", replaced("scratchHead", "scratchEar"), play,
       "simgt: motions/postures/sit.mof:12: requested: unknown motion"},
      {"CheckedMotionTruncated", mof, truncated(144), checkMotions,
       "motionnet: " + mof + ": label start: "},
      {"CheckedMotionWrongName", mof, replaced("label start", "label begin"), checkMotions,
       "motionnet: " + mof + ": label start: "},

      {"ColorTableMissing", table, missing, play, "simgt: " + table + ": there is no such file"},
      {"ColorTableTruncated", table, truncated(1000), play, "simgt: " + table + ": byte "},
      {"ColorTableGarbage", table, garbage(), play, "simgt: " + table + ": byte 0: "},
      {"LogColorTableMissing", "robot.c64", missing, see, "replay: robot.c64: "},
      {"LogColorTableTruncated", "robot.c64", truncated(5), see, "replay: robot.c64: byte 5: "},
      {"LogColorTableWrongClass", "robot.c64",
       replaced(std::string(1, '\4') + '\0' + '\0', std::string{'\4', '\0', '\13'}), see,
       "replay: robot.c64: byte "},

      {"ComparedTableGarbage", "robot.c64", garbage(),
       "colortable compare config/coltable.c64 robot.c64", "colortable: robot.c64: byte 0: "},
      {"ConvertedClassesWrongName", "classes.tsl", replaced("tint", "tone"),
       "colortable convert classes.tsl out.c64", "colortable: classes.tsl:2: orange.tone: "},
      {"RegionsWrongClass", "regions.csv", replaced("orange", "purple"),
       "colortable learn --pictures robot.log --labels regions.csv --out out.c64",
       "colortable: regions.csv:2: class: there is no class 'purple'"},
      {"LabeledImageGarbage", "robot.log", garbage(),
       "colortable learn --pictures robot.log --labels regions.csv --out out.c64",
       "colortable: robot.log: "},

      {"LogMissing", "robot.log", missing, see, "replay: robot.log: there is no such file"},
      {"LogEmpty", "robot.log", text(""), see,
       "replay: robot.log: the file ends within its header"},
      {"LogTruncated", "robot.log", truncated(100), see, "replay: robot.log: the log is cut off"},
      {"LogGarbage", "robot.log", garbage(), see, "replay: robot.log: "},
      {"ListedLogMissing", "robot.log", missing, "gtlog list robot.log",
       "gtlog: robot.log: there is no such file"},
      {"CheckedLogGarbage", "robot.log", garbage(), "gtlog check robot.log",
       "gtlog: robot.log: is not an MCAP file"},
      {"RepairedLogGarbage", "robot.log", garbage(), "gtlog repair robot.log new.mcap",
       "gtlog: robot.log: is not an MCAP file"},
      {"ReplayedLogGarbage", "robot.log", garbage(), "gtlog replay robot.log new.mcap",
       "gtlog: robot.log: is not an MCAP file"},
      {"ImportedLogTruncated", "robot.log", truncated(100), "gtlog import robot.log new.mcap",
       "gtlog: robot.log: the log is cut off"},
      {"CrashReportMissing", "labels.csv", missing, "crashlog labels.csv",
       "crashlog: labels.csv: there is no such file"},
      {"CrashReportGarbage", "labels.csv", garbage(), "crashlog labels.csv",
       "crashlog: labels.csv:1: is no crash report"},
      {"LabelsMissing", "labels.csv", missing, see, "replay: labels.csv: "},
      {"LabelsGarbage", "labels.csv", garbage(), see, "replay: labels.csv:1: "},
      {"LabelsTruncated", "labels.csv", truncated(36), see, "replay: labels.csv:2: x: "},

      {"FieldLabelsGarbage", "field.csv", garbage(), see, "replay: field.csv:1: "},
      {"FieldLabelsWrongName", "field.csv", replaced("line1", "wall"), see,
       "replay: field.csv:2: what: "},

      {"FieldWrongName", "config/nao2009/field.cfg", replaced("ballRadius", "ballRadus"), see,
       "replay: config/nao2009/field.cfg:16: ballRadus: "},
      {"FieldGarbage", "config/nao2009/field.cfg", garbage(), see,
       "replay: config/nao2009/field.cfg:1: "},
      {"FieldTruncated", "config/nao2009/field.cfg", truncatedAfter("xPenalty"), see,
       "replay: config/nao2009/field.cfg:"},
      {"ModulesWrongTask", "config/modules.cfg", replaced("SelfLocator", "SelfFinder"), play,
       "simgt: config/modules.cfg:4: SelfFinder: there is no such task"},
      {"ModulesTruncated", "config/modules.cfg", text("SelfLocator\n"), play,
       "simgt: config/modules.cfg:1: SelfLocator: "},
      {"ModulesGarbage", "config/modules.cfg", garbage(), play, "simgt: config/modules.cfg:1: "},
      {"LogSettingsWrongName", "config/log.cfg", replaced("pictures", "images"), play,
       "simgt: config/log.cfg:15: images: "},
  };
}

INSTANTIATE_TEST_SUITE_P(All, WrongFiles, testing::ValuesIn(wrongFiles()),
                         [](const auto& test) { return std::string{test.param.name}; });

TEST(Programs, AcceptTheRepositorysFiles) {
  const Workplace workplace;
  for (const std::string& program :
       {play, see, checkBehavior, checkMotions, std::string{"simgt check"}}) {
    const Outcome outcome = workplace.run(program);
    EXPECT_EQ(outcome.status, 0) << program;
    EXPECT_EQ(outcome.errors, "") << program;
  }
}

TEST(Programs, TellEveryErrorOfAMotion) {
  const Workplace workplace;
  workplace.write("motions/postures/stand.mof", "garbage\n");
  const Outcome outcome = workplace.run(checkMotions);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, StartsWith("motionnet: motions/postures/stand.mof:1: "));
}

/// A team's files are wrong in the team's folder, and fail as they would in a match.
TEST(Programs, CheckLooksIntoTeams) {
  const Workplace workplace;
  workplace.write("teams/mine/config/modules.cfg", "BallLocator Nonsense\n");
  workplace.write("teams/mine/behavior/options/ball/search_ball.xabsl",
                  "option search_ball { initial state a { action { sleeep(); } } }\n");
  workplace.write("teams/none/readme/it.txt", "");
  const std::string option = "teams/mine/behavior/options/ball/search_ball.xabsl:1:49: ";
  const Outcome all = workplace.run("simgt check");
  EXPECT_EQ(all.status, 2);
  EXPECT_THAT(all.errors, HasSubstr("simgt: teams/mine/config/modules.cfg:1: BallLocator: "));
  EXPECT_THAT(all.errors, HasSubstr("simgt: " + option));
  EXPECT_THAT(all.errors, HasSubstr("simgt: teams/none: is no team: "));
  for (const char* command : {"xabsl check --team mine", "xabsl check --team teams/mine",
                              "xabsl check behavior/GT2003.xabsl --team mine"}) {
    const Outcome behavior = workplace.run(command);
    EXPECT_EQ(behavior.status, 2) << command;
    EXPECT_THAT(behavior.errors, HasSubstr("teams/mine/behavior/options/ball/search_ball.xabsl:1:"))
        << command;
    EXPECT_THAT(behavior.errors, HasSubstr("sleeep")) << command;
  }
  EXPECT_EQ(workplace.run("xabsl check --team none").status, 2);
}

/// A team's tests lie in its folder, and test its files over the project's.
TEST(Programs, TestTheBehaviorOfATeam) {
  const Workplace workplace;
  workplace.write("behavior/a.xabsl",
                  "include \"options/b.xabsl\";\n"
                  "namespace skills(\"Skills\") { behavior here { } behavior there { } }\n"
                  "agent player(\"Player\", b);\n");
  workplace.write("behavior/options/b.xabsl",
                  "option b { initial state own { action { here(); } } }\n");
  workplace.write("teams/mine/behavior/options/b.xabsl",
                  "option b { initial state other { action { there(); } } }\n");
  const std::string test = "test \"t\" { run; expect b == other; }\n";
  workplace.write("teams/mine/behavior/tests/b.xtest", "behavior \"../a.xabsl\";\n" + test);
  workplace.write("behavior/tests/b.xtest", "behavior \"../a.xabsl\";\n" + test);
  for (const char* file : {"teams/mine/behavior/tests/b.xtest", "behavior/tests/b.xtest"}) {
    const Outcome team = workplace.run(std::string{"xabsl test --team mine "} + file);
    EXPECT_EQ(team.status, 0) << file << team.errors;
    EXPECT_NE(workplace.run(std::string{"xabsl test "} + file).status, 0) << file;
  }
}

TEST(Programs, CheckTellsAllErrorsOfATree) {
  const Workplace workplace;
  workplace.write("behavior/options/ball/kick.xabsl", "garbage");
  workplace.write("config/camera.cfg", "gain loud\n");
  workplace.write("config/log.cfg", "pictures 100\nrepresentation BallMoodel\n");
  workplace.write("config/modules.cfg", "SelfLocater MonteCarlo\nBallLocator Unheard\n");
  workplace.write("config/nao2009/field.cfg", "ballRadus 3\nwallHeight x\n");
  workplace.write("config/player.cfg", "teamColor green\n");
  workplace.write("layouts/single.layout", "process All on Image\n  BallFinder\n  GoalFinder\n");
  workplace.write("motions/postures/stand.mof", "garbage\n");
  workplace.write("scenes/empty.scene", "<scene><robots/></scean>");
  workplace.write("scenes/match.scene", "<scene>\n<ball/>\n<noise joints=\"x\"/>\n</scene>");
  workplace.write("models/odd.xml", "<mujoco><worldbody/></mujoco>");
  workplace.write("models/odder.xml",
                  "<mujoco><worldbody><body><bogus/></body></worldbody></mujoco>");
  workplace.write(
      "scenes/several.scene",
      "<scene>\n<robots>\n<robot team=\"red\" role=\"goalie\" model=\"../models/none.xml\"/>\n"
      "<robot team=\"red\" role=\"defender\" model=\"../models/odd.xml\"/>\n"
      "<robot team=\"red\" role=\"striker1\" model=\"../models/odder.xml\"/>\n</robots>\n</scene>");
  const Outcome outcome = workplace.run("simgt check");
  EXPECT_EQ(outcome.status, 2);
  std::istringstream lines{outcome.errors};
  std::size_t at = 0;
  for (const char* file :
       {"behavior/", "config/camera.cfg:1: gain", "config/log.cfg:2: BallMoodel",
        "config/modules.cfg:1: SelfLocater", "config/modules.cfg:2: BallLocator",
        "config/nao2009/field.cfg:1: ballRadus", "config/nao2009/field.cfg:2: wallHeight",
        "config/player.cfg:1: teamColor", "layouts/single.layout:2: BallFinder",
        "layouts/single.layout:3: GoalFinder", "models/odd.xml:1: worldbody",
        "models/odder.xml:1: ", "motions/postures/stand.mof:1: ", "scenes/empty.scene:1:25: ",
        "scenes/match.scene:2:1: ball", "scenes/match.scene:3:8: joints",
        "scenes/several.scene:3:1: model"}) {
    const std::size_t found = outcome.errors.find("simgt: " + std::string{file}, at);
    EXPECT_NE(found, outcome.errors.npos) << file << " is not reported, or not in order:\n"
                                          << outcome.errors;
    if (found != outcome.errors.npos) at = found;
  }
}

/// XML whose entity stands for ten thousand million letters, or for a file of the machine.
std::string xmlBomb(const std::string& root) {
  std::string entities = "<!ENTITY a0 \"aaaaaaaaaa\">";
  for (int i = 1; i < 10; ++i) {
    std::string ten;
    for (int k = 0; k < 10; ++k) ten += "&a" + std::to_string(i - 1) + ";";
    entities += "<!ENTITY a" + std::to_string(i) + " \"" + ten + "\">";
  }
  return "<!DOCTYPE x [" + entities + "]>\n<" + root + " name=\"&a9;\">&a9;</" + root + ">";
}
std::string xmlThatReads(const std::string& root) {
  return "<!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/passwd\">]>\n<" + root + ">&e;</" + root +
         ">";
}
std::string deepXml() {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "<a>";
  return text;
}

/// What is small and claims to be large, deep or another's file ends at once, in little memory.
TEST(Programs, EndOnBombs) {
  const Workplace workplace;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  const std::string limit;  // they take all addresses
#else
  const std::string limit = "ulimit -v 4000000; ";
#endif
  const auto outcome = [&](const std::string& command) { return workplace.run(command, limit); };
  const std::string playBomb = "simgt play --minutes 0.01 --out bomb ";
  EXPECT_EQ(outcome(playBomb + "scenes/one-robot.scene").status, 0);
  for (const char* root : {"agent-collection", "scene"}) {
    const bool isScene = std::string{root} == "scene";
    for (const std::string& text : {xmlBomb(root), xmlThatReads(root), deepXml()}) {
      workplace.write("bomb.xml", text);
      const Outcome ended = outcome((isScene ? playBomb : "xabsl check ") + "bomb.xml");
      EXPECT_EQ(ended.status, 2) << root << "\n" << ended.errors;
      EXPECT_THAT(ended.errors, HasSubstr("bomb.xml:"));
      EXPECT_THAT(ended.errors, Not(HasSubstr("/root:"))) << "no file of the machine is read";
    }
  }
}

}  // namespace
}  // namespace gt
