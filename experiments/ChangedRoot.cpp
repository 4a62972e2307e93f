#include "ChangedRoot.h"

#include <filesystem>
#include <map>
#include <sstream>

#include "base/File.h"
#include "base/Lines.h"
#include "base/LinkFiles.h"
#include "framework/UnknownNames.h"
#include "robot/ConfigFolder.h"
#include "robot/Solutions.h"
#include "robot/TeamSolutions.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// New values by name, for each file of the configuration.
using Changes = std::map<std::string, std::map<std::string, std::string>>;

Error wrong(const std::string& field, const std::string& what) {
  return {.field = field, .what = what};
}

/// The file of a motion of a root, relative to it.
std::string motionFile(const DataRoot& root, const std::string& motion) {
  const fs::path folder = root.path("motions");
  std::error_code failed;  // then it is not found
  for (fs::recursive_directory_iterator at{folder, failed}, end; !failed && at != end;
       at.increment(failed))
    if (at->path().filename() == motion + ".mof")
      return ("motions" / at->path().lexically_relative(folder)).string();
  return {};
}

/// Adds SOLUTION of a task, the value of TASK.SOLUTION.PATH or that of motions.MOTION.NAME.
Result<void> addChange(const DataRoot& root, const std::string& one, Changes& changes) {
  const auto equals = one.find('=');
  if (equals == one.npos || equals == 0 || equals + 1 == one.size())
    return wrong(one,
                 "expected TASK=SOLUTION, TASK.SOLUTION.PATH=VALUE or motions.MOTION.NAME=VALUE");
  const std::string path = one.substr(0, equals), value = one.substr(equals + 1);
  const auto dot = path.find('.');
  if (path.substr(0, dot) == "motions") {
    const auto second = std::min(path.find('.', dot + 1), path.size());
    const std::string file = motionFile(root, path.substr(dot + 1, second - dot - 1));
    if (file.empty()) return wrong(path, "there is no such motion");
    if (!changes[file].emplace(path.substr(second + 1), value).second)
      return wrong(path, "is given twice");
    return {};
  }
  const Task* task = solutions().find(path.substr(0, dot));
  if (!task) return wrong(path.substr(0, dot), noSuchTask(solutions(), path.substr(0, dot)));
  // A team's choice of solutions counts before the project's.
  std::error_code missing;
  std::string file = fs::exists(root.path("config") + '/' + teamSolutions, missing) ? teamSolutions
                                                                                    : "modules.cfg";
  std::string name = path, solution = value;
  if (dot != path.npos) {
    const auto second = path.find('.', dot + 1);
    if (second == path.npos) return wrong(path, "expected TASK.SOLUTION.PATH");
    solution = path.substr(dot + 1, second - dot - 1);
    file = "modules/" + path.substr(0, second) + ".cfg";
    name = path.substr(second + 1);
  } else if (solution == SolutionTable::disabled) {
    solution.clear();
  }
  if (!solution.empty() && !task->find(solution))
    return wrong(task->name, noSuchSolution(*task, solution));
  if (!changes[file].emplace(name, value).second) return wrong(path, "is given twice");
  return {};
}

/// A file of the configuration with other values, which stand before all sections.
std::string changedText(const std::string& text, const std::map<std::string, std::string>& values) {
  std::string changed;
  for (const auto& [name, value] : values) changed.append(name).append(" " + value + "\n");
  std::string section;
  LineReader lines{text};
  while (const auto line = lines.next()) {
    const std::string_view content = withoutComment(*line);
    if (content.starts_with('['))
      section = std::string{trimmed(content.substr(1, content.find(']') - 1))} + '.';
    const std::string name{content.substr(0, content.find_first_of(" \t="))};
    if (!values.contains(section + name)) changed.append(*line) += '\n';
  }
  return changed;
}

/// Whether a solution has the parameters of its file.
Result<void> checkParameters(const std::string& file, const std::string& text) {
  const std::string stem = fs::path{file}.stem().string();
  const auto dot = stem.find('.');
  const Solution& solution = *solutions().find(stem.substr(0, dot))->find(stem.substr(dot + 1));
  Blackboard blackboard;
  Debug debug;
  return solution.make({blackboard, debug, Random{0}})->configure(text, file).firstError();
}

Result<void> change(const fs::path& config, const std::string& name,
                    const std::map<std::string, std::string>& values) {
  const auto folder = ConfigFolder::open(config.string());
  if (!folder) return folder.error();
  const std::string file = folder->path(name);
  std::string before;
  std::error_code ignored;  // then writing reports what is wrong
  if (fs::exists(file)) {
    auto text = readFile(file);
    if (!text) return text.error();
    before = *std::move(text);
    fs::remove(file, ignored);
  }
  fs::create_directories(fs::path{file}.parent_path(), ignored);
  const std::string text = changedText(before, values);
  if (name != "modules.cfg" && name != teamSolutions)
    if (auto done = checkParameters(file, text); !done)
      return wrong(fs::path{file}.stem().string() + "." + done.error().field, done.error().what);
  return writeFile(file, text);
}

/// Changes named values of a motion.
Result<void> changeMotion(const fs::path& root, const std::string& name,
                          const std::map<std::string, std::string>& values) {
  const fs::path file = root / name;
  const auto text = readFile(file.string());
  if (!text) return text.error();
  std::string changed;
  std::size_t found = 0;
  LineReader lines{*text};
  while (const auto line = lines.next()) {
    std::istringstream words{std::string{*line}};
    std::string keyword, value;
    words >> keyword >> value;
    const auto other = values.find(value);
    const bool isOther = keyword == "value" && other != values.end();
    changed += (isOther ? "value " + value + " = " + other->second : std::string{*line}) + '\n';
    found += isOther;
  }
  if (found < values.size()) return wrong(name, "has not all of the values");
  std::error_code ignored;  // then writing reports what is wrong
  fs::remove(file, ignored);
  return writeFile(file.string(), changed);
}

}  // namespace

/// Fills the folder with links.
Result<void> ChangedRoot::link(const DataRoot& root, const std::string& team) {
  const fs::path folder = folder_.path();
  if (folder.empty()) return Error{.what = "there is no temporary folder"};
  for (const char* part : {"behavior", "config", "experiments/colors", "layouts", "models",
                           "motions", "scenes", "teams", "tests/real"})
    if (auto done = linkFiles(fs::absolute(root.path(part)), folder / part); !done) return done;
  const auto own = teamOfVersion(team, root);
  if (!own) return own.error();
  if (own->empty()) return {};
  auto opened = TeamFolder::open(*own, ConfigurationPaths::in(root));
  if (!opened) return opened.error();
  team_ = *std::move(opened);
  const ConfigurationPaths& paths = team_->paths();
  for (const auto& [from, part] : {std::pair{fs::path{paths.behavior}.parent_path(), "behavior"},
                                   {fs::path{paths.config}, "config"},
                                   {fs::path{paths.motions}, "motions"}})
    if (auto done = linkFiles(from, folder / part); !done) return done;
  return {};
}

Error ChangedRoot::named(Error error) const {
  const fs::path within = fs::path{error.file}.lexically_relative(folder_.path());
  if (within.empty() || *within.begin() == "..") return error;
  std::error_code changed;  // then it is no link
  const fs::path file = fs::read_symlink(error.file, changed);
  error.file = (changed ? within : file).string();
  return team_ ? team_->named(std::move(error)) : error;
}

Result<std::unique_ptr<ChangedRoot>> ChangedRoot::make(const DataRoot& root,
                                                       const std::string& values,
                                                       const std::string& team) {
  auto made = std::make_unique<ChangedRoot>();
  if (auto done = made->link(root, team); !done) return done.error();
  const fs::path folder = made->folder_.path();
  Changes changes;
  std::istringstream words{values};
  for (std::string one; std::getline(words, one, ',');)
    if (auto done = addChange(made->root(), one, changes); !done) return done.error();
  for (const auto& [file, numbers] : changes) {
    auto done = file.starts_with("motions/") ? changeMotion(folder, file, numbers)
                                             : change(folder / "config", file, numbers);
    if (!done) return done.error();
    made->files_.push_back(file.starts_with("motions/") ? file : "config/" + file);
  }
  return made;
}

}  // namespace gt
