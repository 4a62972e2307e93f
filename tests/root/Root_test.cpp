#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "support/ProgramFolder.h"
#include "support/TestLog.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

/// How a program ended and what it printed.
struct Outcome {
  int status = -1;
  std::string output;
};

/// An empty folder in which programs of a tree run.
class Elsewhere {
 public:
  explicit Elsewhere(std::string programs) : programs_{std::move(programs)} {}

  Outcome run(const std::string& command) const {
    const std::string log = (folder_.path() / "printed").string();
    const std::string line = "cd " + path().string() + " && env -u GT2003_ROOT " + variables +
                             " timeout 300 " + programs_ + "/" + command + " >" + log + " 2>&1";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, *readFile(log)};
  }
  void succeeds(const std::string& command) const {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << command << '\n' << outcome.output;
  }
  fs::path path() const { return folder_.path(); }
  std::string variables;

 private:
  std::string programs_;
  TemporaryFolder folder_;
};

/// All programs that read data find them; `root` is where they lie.
void workFromAnywhere(const Elsewhere& place, const std::string& root) {
  place.succeeds("simgt play --minutes 0.02");
  EXPECT_TRUE(fs::exists(place.path() / "out/match/report.html"));
  EXPECT_TRUE(fs::exists(place.path() / "out/match/red1.mcap"));
  place.succeeds("simgt check");
  place.succeeds("simgt layout");
  place.succeeds(
      "experiment --seeds 1 --only localization.robustness.bench --set trouble=none --set "
      "minutes=0.1");
  EXPECT_TRUE(fs::exists(place.path() / "out/experiments.json"));
  place.succeeds(
      "experiment --seeds 1 --only vision.pictures --set moments=1 "
      "--set condition=GridImageProcessorTSL");
  place.succeeds("motionnet check");
  place.succeeds("colortable learn --moments 1 --out out/learned.c64");
  place.succeeds("xabsl check " + root + "/behavior/GT2003.xabsl");

  LogBuilder log;
  for (int i = 0; i < 22; ++i) log.put(0.1 * i);
  log.put(std::uint32_t{5000}).end(5);
  log.put(0.25).put(100.0).put(-50.0).end(8);
  ASSERT_TRUE(writeFile((place.path() / "robot.log").string(), log.log()));
  // One run of 64^3 colors of class 0, and the end.
  ASSERT_TRUE(
      writeFile((place.path() / "robot.c64").string(), std::string("\0\0\4\0\0\0\0\0\0", 9)));
  place.succeeds("replay --log robot.log --colors robot.c64");
  EXPECT_TRUE(fs::exists(place.path() / "out/replay.json"));
}

TEST(Root, ProgramsOfTheBuildTreeWorkFromAnywhere) {
  const Elsewhere place{programFolder()};
  workFromAnywhere(place, fs::current_path().string());
}

TEST(Root, ProgramsOfAnInstalledTreeWorkFromAnywhere) {
  const TemporaryFolder prefix;
  const std::string install = "cmake --install " +
                              fs::path{programFolder()}.parent_path().string() + " --prefix " +
                              prefix.path().string() + " >" + (prefix.path() / "log").string();
  ASSERT_EQ(std::system(install.c_str()), 0);
  const fs::path root = prefix.path() / "share/gt2003";
  const Elsewhere place{(prefix.path() / "bin").string()};
  workFromAnywhere(place, root.string());

  // It is the installed data that are read.
  ASSERT_TRUE(writeFile((root / "config/modules.cfg").string(), "NoTask NoSolution\n"));
  const Outcome outcome = place.run("simgt play --minutes 0.02");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.output, HasSubstr((root / "config/modules.cfg").string() + ":1: NoTask"));
}

TEST(Root, OptionAndVariableNameAnotherRoot) {
  const TemporaryFolder other;
  for (const char* folder : {"behavior", "config", "layouts", "models", "motions", "scenes"})
    fs::create_directories(other.path() / folder);
  Elsewhere place{programFolder()};
  const std::string line = "simgt: " + other.path().string() + "/scenes/match.scene";
  for (const std::string command : {"simgt play --root ", "simgt --root ", "simgt play --root="}) {
    std::string arguments = command + other.path().string();
    if (command == "simgt --root ") arguments += " play";
    EXPECT_THAT(place.run(arguments).output, StartsWith(line)) << command;
  }
  place.variables = "GT2003_ROOT=" + other.path().string();
  EXPECT_THAT(place.run("simgt play").output, StartsWith(line));
  place.succeeds("simgt check --root " + fs::current_path().string());
  place.variables = "GT2003_ROOT=nowhere";
  const Outcome outcome = place.run("simgt play");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.output,
            "simgt: nowhere: GT2003_ROOT: is no data root: it has no folder 'behavior'\n");
}

}  // namespace
}  // namespace gt
