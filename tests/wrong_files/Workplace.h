#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>

#include "base/File.h"
#include "support/ProgramFolder.h"
#include "support/TestLog.h"

namespace gt {

namespace fs = std::filesystem;

/// How a program ended and what it printed.
struct Outcome {
  int status = -1;  ///< Exit status; -1 if it crashed.
  std::string errors;
};

/// A copy of all files that the programs read, to break one of.
class Workplace {
 public:
  Workplace() : root_{fs::temp_directory_path() / ("gt2003-wrong-" + std::to_string(::getpid()))} {
    fs::remove_all(root_);
    fs::create_directories(root_);
    for (const char* folder : {"config", "motions", "behavior", "layouts", "scenes", "models"})
      fs::copy(folder, root_ / folder, fs::copy_options::recursive);
    LogBuilder log;
    for (int i = 0; i < 22; ++i) log.put(0.1 * i);
    log.put(std::uint32_t{5000}).end(5);
    log.put(0.25).put(100.0).put(-50.0).end(8);
    write("robot.log", log.log());
    // One run of 64^3 colors of class 0, and the end.
    write("robot.c64", std::string("\0\0\4\0\0\0\0\0\0", 9));
    write("classes.tsl", "[orange]\ntint 110 140\nsaturation 60 255\nluminance 40 200\n");
    write("regions.csv", "picture,class,left,top,right,bottom\n0,orange,1,1,2,2\n");
    write("field.csv", "picture,time,what,x,y\n0,5000,line1,100,120\n");
    write("labels.csv", "picture,time,class,x,y,r\n0,5000,whole,160,120,20\n");
  }
  ~Workplace() { fs::remove_all(root_); }

  std::string read(const std::string& file) const { return *readFile((root_ / file).string()); }
  void write(const std::string& file, std::string_view content) const {
    fs::create_directories((root_ / file).parent_path());
    ASSERT_TRUE(writeFile((root_ / file).string(), content));
  }
  const fs::path& root() const { return root_; }

  /// Runs a program in there; names of files in its output are relative to it. The shell can be
  /// told something before, such as a limit.
  Outcome run(const std::string& arguments, const std::string& before = "") const {
    const std::string log = (root_ / "errors").string();
    const std::string place =
        "cd " + root_.string() + " && GT2003_ROOT=. XDG_STATE_HOME=" + root_.string() + "/state";
    const std::string program =
        "sh -c '" + before + "exec " + programFolder() + "/" + arguments + "'";
    const int raw =
        std::system((place + " timeout 300 " + program + " >/dev/null 2>" + log).c_str());
    return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, *readFile(log)};
  }

 private:
  fs::path root_;
};

/// The messages in what a program prints: a compiler shows the line below, indented, with a caret.
inline int messages(const std::string& errors) {
  std::istringstream lines{errors};
  int count = 0;
  for (std::string line; std::getline(lines, line);) count += !line.starts_with(' ');
  return count;
}

}  // namespace gt
