#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "base/ChildProgram.h"
#include "base/File.h"
#include "base/Program.h"
#include "base/TemporaryFolder.h"
#include "crash/CrashReport.h"
#include "support/ProgramFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes patience{2};  // under a sanitizer programs take long

/// A program that runs in a folder of its own, and what it wrote there.
class CrashReports : public testing::Test {
 protected:
  /// Runs a program until a text stands in what it prints, and has a signal crash it. Returns its
  /// report.
  CrashReport crash(const std::string& name, const std::string& arguments,
                    const std::string& sign) {
    fs::create_directories(folder.path() / "here");
    ChildProgram program{{"/bin/sh", "-c",
                          "cd " + folder.path().string() + "/here && XDG_STATE_HOME=" +
                              folder.path().string() + "/state exec " + programFolder() + "/" +
                              name + " " + arguments + " >../printed 2>&1"}};
    const auto end = std::chrono::steady_clock::now() + patience;
    while (program.runs() && printed().find(sign) == std::string::npos &&
           std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
    EXPECT_TRUE(program.runs()) << printed();
    program.kill(SIGSEGV);
    EXPECT_TRUE(WIFSIGNALED(program.status()));
    EXPECT_EQ(WTERMSIG(program.status()), SIGSEGV);
    std::error_code failed;
    const fs::directory_iterator reports{folder.path() / "state/gt2003/crashes", failed};
    EXPECT_FALSE(failed) << printed();
    if (failed) return {};
    const std::string path = reports->path().string();
    EXPECT_THAT(printed(),
                testing::EndsWith(": crashed; crashlog reads the report " + path + "\n"));
    const auto text = readFile(path);
    EXPECT_TRUE(text) << text.error().text();
    const auto report = parseCrashReport(*text, path);
    EXPECT_TRUE(report) << report.error().text();
    if (!report) return {};
    EXPECT_TRUE(report->complete);
    EXPECT_FALSE(fs::exists(folder.path() / "here/out/crashes")) << "nobody asked for it there";
    EXPECT_THAT(report->program, testing::StrCaseEq(name));
    EXPECT_EQ(report->signal, "SIGSEGV");
    EXPECT_FALSE(report->frames.empty());
    return *report;
  }
  std::string printed() const {
    const auto text = readFile((folder.path() / "printed").string());
    return text ? *text : "";
  }

  const TemporaryFolder folder;
  const std::string root = fs::current_path().string();
};

TEST_F(CrashReports, OfAMatch) {
  crash("simgt", "play " + root + "/scenes/match.scene --threads 1 --no-logs", "Kick-off");
}

TEST_F(CrashReports, OfAConsole) {
  crash("simgt", "console " + root + "/scenes/one-robot.scene -c 'echo begins' -c 'run 10000'",
        "begins");
}

/// The thread that dies does the job, mostly in a process of a robot.
TEST_F(CrashReports, OfAJob) {
  const auto report = crash(
      "experiment",
      "run --job 'fidelity walk=forward100 seed=1' --job 'match minutes=1000 seed=7' --threads 1",
      "1/2");
  EXPECT_THAT(report.running,
              testing::MatchesRegex(
                  "match blue=GT2003 fidelity=kinematic minutes=1000 oracled=none "
                  "profile=padova red=GT2003 values=none seed=7[^,]*(, (red|blue)[1-4].*)?"));
}

TEST_F(CrashReports, OfARobotsProcess) {
  crash("gtrobot-debug", "--sockets ..", "does not answer");
}

/// One file has what it takes to look into a fault elsewhere.
TEST_F(CrashReports, ArePackedWithWhatShowsTheFault) {
  crash("simgt", "play " + root + "/scenes/match.scene --threads 1 --no-logs", "Kick-off");
  const std::string state = folder.path().string() + "/state",
                    file = folder.path() / "fault.tar.gz";
  const auto pack = [&](const std::string& arguments) {
    const auto packed = runProgram({"/bin/sh", "-c",
                                    "XDG_STATE_HOME=" + state + " " + programFolder() +
                                        "/simgt fault-report --out " + file + " " + arguments});
    EXPECT_TRUE(packed) << packed.error().text();
    return packed ? packed->status : -1;
  };
  EXPECT_EQ(pack("nowhere.mcap"), 2);
  EXPECT_FALSE(fs::exists(file));
  ASSERT_EQ(pack(folder.path().string() + "/printed --note 'it fell'"), 0);
  const fs::path out = folder.path() / "unpacked";
  fs::create_directories(out);
  const auto unpacked = runProgram({"tar", "-xzf", file, "-C", out.string()});
  ASSERT_TRUE(unpacked && unpacked->status == 0);
  const auto about = readFile((out / "about.txt").string());
  ASSERT_TRUE(about) << about.error().text();
  EXPECT_THAT(*about, testing::StartsWith("fault: it fell\nversion: "));
  EXPECT_EQ(*readFile((out / "results/printed").string()), printed());
  EXPECT_EQ(*readFile((out / "root/config/modules.cfg").string()), *readFile("config/modules.cfg"));
  const fs::path report = fs::directory_iterator {
    out / "crashes"
    } -> path();
  const auto text = readFile(report.string());
  ASSERT_TRUE(text) << text.error().text();
  EXPECT_TRUE(parseCrashReport(*text, report.string()));
}

}  // namespace
}  // namespace gt
