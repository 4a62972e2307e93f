#include <algorithm>
#include <filesystem>

#include "modules/behavior/control/GT2003BehaviorControl.h"
#include "modules/behavior/control/ObstacleAvoiderOnGreenField.h"
#include "modules/behavior/tactics/PlayValues.h"
#include "motionnet/Listing.h"
#include "representations/behavior/BehaviorRequest.h"
#include "representations/behavior/PotentialFields.h"
#include "representations/behavior/TargetPoints.h"
#include "robot/Robot.h"
#include "robot/Solutions.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/formats/Sources.h"
#include "xabsl/language/SourceFiles.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

void add(const std::vector<xabsl::Diagnostic>& diagnostics, Findings& findings) {
  for (const xabsl::Diagnostic& diagnostic : diagnostics) {
    const bool isError = diagnostic.severity == xabsl::Diagnostic::Severity::error;
    findings.add({.file = diagnostic.file,
                  .line = diagnostic.line,
                  .column = diagnostic.column,
                  .what = diagnostic.message,
                  .severity = isError ? Severity::error : Severity::warning});
  }
}

/// Compiles a behavior, and links it: that finds missing symbols before a robot runs. The file that
/// declares the special actions is made from the motions, instead of the one in the folder.
Behavior readBehavior(const BehaviorRequest& request, const MotionNet& motions,
                      Findings& findings) {
  xabsl::VirtualFiles files;
  for (const auto& [path, text] : request.files) files[path] = text;
  const xabsl::FileReader read = files.empty() ? xabsl::diskReader() : xabsl::readerOf(files);
  const bool motionsFailed = motions.motions.empty();
  std::vector<std::string> names;
  for (std::size_t i = 1; i < motions.motions.size(); ++i) names.push_back(motions.motions[i].name);
  xabsl::Compilation compilation = xabsl::compile(
      request.path, [&](const std::string& path, std::string& text) -> std::optional<std::string> {
        if (motionsFailed || fs::path{path}.filename() != "special_actions.xabsl")
          return read(path, text);
        text = motionnet::listing(names);
        return std::nullopt;
      });
  const std::size_t before = findings.errors();
  add(compilation.diagnostics, findings);
  if (findings.errors() > before || motionsFailed) return {};
  GT2003BehaviorControl control;
  add(xabsl::Engine::create(*compilation.behavior, control.symbols(motions)).diagnostics, findings);
  return Behavior{std::move(compilation.behavior)};
}

/// The file that a tool names: one of the behaviors beside that which the robot was started with.
/// No message makes it read any other file.
Result<std::string> ownBehavior(const std::string& name, const fs::path& configured) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator{configured.parent_path(), failed}) {
    if (entry.path().extension() != ".xabsl") continue;
    for (const fs::path& known : {entry.path(), entry.path().filename(), entry.path().stem()})
      if (known == name) return entry.path().string();
    names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  std::string known;
  for (const std::string& other : names) known += (known.empty() ? "" : ", ") + other;
  return Error{
      .file = name,
      .what = "is none of the robot's behaviors (" + known + "); send the texts of other ones"};
}

Result<void> change(const Message& message, ModuleProcess& process,
                    const ConfigurationFiles& files) {
  BehaviorRequest request;
  if (auto done = message.read(request); !done) return done;
  if (request.files.empty()) {
    const auto own = ownBehavior(request.path, files.paths.behavior);
    if (!own) return own.error();
    request.path = *own;
  }
  auto behavior = loadBehavior(request, process.blackboard().get<MotionNet>());
  if (!behavior) return behavior.error();
  process.blackboard().get<Behavior>() = std::move(*behavior);
  return {};
}

void read(const ConfigurationPart&, Configuration& configuration, Findings& findings) {
  configuration.set(readBehavior({configuration.files.paths.behavior, {}},
                                 configuration.get<MotionNet>(), findings));
}

void share(const Configuration& configuration, const std::string&, Blackboard& blackboard) {
  blackboard.get<Behavior>() = configuration.get<Behavior>();
}

void readValues(const ConfigurationPart& part, Configuration& configuration, Findings& findings) {
  readPart<PlayValues>(part, configuration, findings);
  if (auto done = configuration.get<PlayValues>().check(); !done) {
    Error error = done.error();
    error.file = configuration.files.folder.path(part.file);
    findings.add(error);
  }
}

bool handle(const Message& message, ModuleProcess& process, const ConfigurationFiles& files) {
  if (!message.is<BehaviorRequest>() || !process.solves("BehaviorControl")) return false;
  process.answer(message, change(message, process, files));
  return true;
}

}  // namespace

Result<Behavior> loadBehavior(const BehaviorRequest& request, const MotionNet& motions) {
  Findings findings;
  Behavior behavior = readBehavior(request, motions, findings);
  if (auto done = findings.firstError(); !done) return done.error();
  return behavior;
}

Result<BehaviorRequest> readBehaviorTexts(const std::string& file) {
  BehaviorRequest request;
  std::optional<Error> first;
  const xabsl::FileReader read = [&](const std::string& path, std::string& text) {
    auto failure = xabsl::readFile(path, text);
    if (!failure)
      request.files.push_back({path, text});
    else if (!first)
      first = Error{.file = path, .what = *failure};
    return failure;
  };
  xabsl::syntax::Program program;
  xabsl::Reporter reporter;  // of wrong texts the robot reports
  xabsl::readSources(file, read, program, reporter);
  if (first) return *first;
  request.path = request.files.front().path;
  return request;
}

Result<void> Robot::request(const BehaviorRequest& request) {
  for (const auto& process : processes_) {
    Blackboard& blackboard = process->blackboard();
    if (!blackboard.find(representation<Behavior>().name)) continue;
    auto behavior = loadBehavior(request, blackboard.get<MotionNet>());
    if (!behavior) return behavior.error();
    blackboard.get<Behavior>() = *std::move(behavior);
  }
  return {};
}

void addBehavior(RobotModules& modules) {
  addMotionNet(modules);  // first: a behavior names its motions
  SolutionTable& table = modules.solutions;
  table.add<BehaviorControl, GT2003BehaviorControl>("GT2003");
  table.add<SensorBehaviorControl, ObstacleAvoiderOnGreenField>("ObstacleAvoiderOnGreenField");
  modules.parts.push_back(
      {.type = &representation<Behavior>(), .read = read, .share = share, .handle = handle});
  modules.parts.push_back({.type = &representation<PotentialFields>(),
                           .file = "potentialfields.cfg",
                           .read = readPart<PotentialFields>});
  modules.parts.push_back({.type = &representation<TargetPoints>(),
                           .file = "targets.cfg",
                           .read = readPart<TargetPoints>});
  modules.parts.push_back(
      {.type = &representation<PlayValues>(), .file = "values.cfg", .read = readValues});
}

}  // namespace gt
