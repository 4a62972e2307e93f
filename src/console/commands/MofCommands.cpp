#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/File.h"
#include "console/Commands.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {
namespace {

Result<void> isDebugged(ConsoleRobot& robot) {
  const auto task = robot.observed().task("MotionControl");
  if (!task) return task.error();
  if ((*task)->active == "Debug") return {};
  return Error{.what = "only the solution Debug executes lines; sr MotionControl Debug"};
}

Result<void> sendSequence(Console& console, JointDataSequence sequence) {
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (auto done = isDebugged(robot); !done) return done;
    sequence.number = ++robot.sequences;
    return robot.observed().send(sequence);
  });
}

/// The file with a path, or the motion description with a name in a folder.
std::string fileOf(const std::string& word, const std::string& folder) {
  namespace fs = std::filesystem;
  if (fs::exists(word)) return word;
  std::error_code failure;
  for (fs::recursive_directory_iterator it{folder, failure}, end; !failure && it != end;
       it.increment(failure))
    if (it->path().extension() == ".mof" && it->path().stem() == word) return it->path().string();
  return word;
}

Result<void> executeMof(Console& console, const Words& words, bool loop) {
  const std::string& folder = console.session().options().motions;
  std::string text = words.rest.substr(words[1].size()), file;
  if (words.size() == 3) {
    file = fileOf(words[2], folder);
    const auto read = readFile(file);
    if (!read) return read.error();
    text = *read;
  }
  auto sequence = jointDataOf(text, file, folder);
  if (!sequence) {
    Error error = sequence.error();
    if (file.empty()) error.line = 0;  // there is only one
    return error;
  }
  sequence->loop = loop;
  return sendSequence(console, *sequence);
}

/// The line of a motion description that moves the joints to their present angles. Measured angles
/// may lie slightly beyond those that can be commanded.
std::string lineOf(const JointAngles& joints) {
  std::string line;
  const auto limits = motionRules().joints;
  for (std::size_t i = 0; i < MotionNet::jointCount; ++i) {
    const long angle = std::lround(joints.values[i] * 1000);
    line += std::to_string(std::clamp<long>(angle, limits[i].low, limits[i].high)) + " ";
  }
  return line + "1 25";
}

Result<void> mof(Console& console, const Words& words) {
  if (words[1] == "stop") return sendSequence(console, {});
  if (words[1] != "read") return executeMof(console, words, words[1] == "loop");
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    const auto sensors = robot.observed().value<SensorDataBuffer>();
    if (!sensors) return sensors.error();
    console.print(lineOf((*sensors)->newest().joints));
    return {};
  });
}

}  // namespace

std::vector<Command> mofCommands() {
  return {{Command::Kind::robot, "mof",
           "(execute | loop) (MOTION | FILE | VALUE VALUE {VALUE}) | stop | read",
           "Tries a motion line by line while the solution Debug of MotionControl runs (report "
           "J.5.4): executes the lines of joint data of a motion description, by its file or its "
           "name in motions/, or a line that is typed, once or again and again; otherwise the "
           "joints stay as forced. Read prints where they are as such a "
           "line.",
           mof, nullptr, true}};
}

}  // namespace gt
