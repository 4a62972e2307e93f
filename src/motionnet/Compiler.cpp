#include "motionnet/Compiler.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "motionnet/Check.h"
#include "motionnet/Parser.h"

namespace motionnet {
namespace {

constexpr std::size_t maxMotions = 256;
constexpr std::size_t maxNodes = 200000;
constexpr std::uintmax_t maxFileSize = 4 << 20;

/// Puts parsed motions into one net and resolves their names.
class Linker {
 public:
  Linker(std::vector<Motion> motions, std::vector<Diagnostic>& errors)
      : motions_(std::move(motions)), errors_(errors) {}

  Net link() {
    nameMotions();
    nameGroups();
    namePostures();
    // Transitions for a group become one node for each member, so a statement's node is only known
    // when those before it are: the places first, then the targets.
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      place(static_cast<int>(i));
      if (net_.nodes.size() <= maxNodes) continue;
      error(motions_[i], 0, "", "the net has more than 200000 nodes");
      return {};
    }
    for (std::size_t i = 0; i < motions_.size(); ++i) resolve(static_cast<int>(i));
    net_.entry = motions_.empty() ? 0 : firstNode_[0][0];
    return std::move(net_);
  }

  /// Labels that no transition leads to; only extern may begin without.
  void checkLabels() {
    for (std::size_t i = 0; i < motions_.size(); ++i)
      for (const auto& [name, label] : motions_[i].labels) {
        const auto& used = usedLabels_[i];
        if (std::find(used.begin(), used.end(), name) == used.end() && i != 0)
          error(motions_[i], label.line, "label", name + " is the target of no transition");
      }
  }

 private:
  void error(const Motion& motion, int line, std::string field, std::string message) {
    errors_.push_back({motion.file, line, std::move(field), std::move(message)});
  }

  void nameMotions() {
    for (const auto& motion : motions_) {
      const int index = static_cast<int>(net_.motions.size());
      if (!motion.name.empty() && !byName_.emplace(motion.name, index).second)
        error(motion, motion.nameLine, "motion_id",
              motion.name + " is also the name of " +
                  motions_[static_cast<std::size_t>(byName_[motion.name])].file);
      net_.motions.push_back(motion.name);
    }
  }

  void nameGroups() {
    for (const auto& motion : motions_)
      for (const auto& [name, group] : motion.groups) {
        if (name == "allMotions" || byName_.count(name) || groups_.count(name))
          error(motion, group.line, "group", name + " has another meaning already");
        auto& members = groups_[name];
        for (const auto& member : group.members)
          if (const auto it = byName_.find(member); it == byName_.end())
            error(motion, group.line, "group", "unknown motion " + member);
          else if (std::find(members.begin(), members.end(), it->second) == members.end())
            members.push_back(it->second);
      }
  }

  void namePostures() {
    for (const auto& motion : motions_)
      for (const auto& [name, posture] : motion.postures)
        if (!postures_.emplace(name, &posture.angles).second)
          error(motion, posture.line, "posture", name + " has another meaning already");
  }

  /// For which requests a transition is followed; empty if the name is unknown.
  std::vector<int> requests(const std::string& name) const {
    if (name == "allMotions") return {-1};
    if (const auto it = byName_.find(name); it != byName_.end()) return {it->second};
    if (const auto it = groups_.find(name); it != groups_.end()) return it->second;
    return {};
  }

  void place(int index) {
    const auto& motion = motions_[static_cast<std::size_t>(index)];
    auto& first = firstNode_.emplace_back();
    for (const auto& statement : motion.statements) {
      first.push_back(static_cast<int>(net_.nodes.size()));
      Node node = statement.node;
      node.motion = index;
      if (!statement.posture.empty()) {
        if (const auto it = postures_.find(statement.posture); it != postures_.end())
          node.angles = *it->second;
        else
          error(motion, node.line, "posture", "unknown posture " + statement.posture);
      }
      if (node.kind != Node::Kind::transition) {
        net_.nodes.push_back(std::move(node));
        continue;
      }
      const auto list = requests(statement.requested);
      if (list.empty())
        error(motion, node.line, "requested", "unknown motion or group " + statement.requested);
      for (const int requested : list) {
        node.requested = requested;
        net_.nodes.push_back(node);
      }
    }
    first.push_back(static_cast<int>(net_.nodes.size()));
    Node end;  // in extern: out of the net; elsewhere the check finds that it is reached
    end.kind = Node::Kind::leave;
    end.motion = index;
    end.line = motion.statements.empty() ? motion.nameLine : motion.statements.back().node.line;
    net_.nodes.push_back(end);
  }

  void resolve(int index) {
    const auto& motion = motions_[static_cast<std::size_t>(index)];
    for (std::size_t i = 0; i < motion.statements.size(); ++i) {
      const auto& statement = motion.statements[i];
      if (statement.node.kind != Node::Kind::transition) continue;
      const int target = targetOf(motion, statement);
      const auto& first = firstNode_[static_cast<std::size_t>(index)];
      for (int n = first[i]; n < first[i + 1]; ++n)
        net_.nodes[static_cast<std::size_t>(n)].target = target;
    }
  }

  int targetOf(const Motion& from, const Statement& statement) {
    const auto motion = byName_.find(statement.motion);
    if (motion == byName_.end()) {
      error(from, statement.node.line, "motion", "unknown motion " + statement.motion);
      return 0;
    }
    const auto index = static_cast<std::size_t>(motion->second);
    const auto& labels = motions_[index].labels;
    const auto label = labels.find(statement.label);
    if (label == labels.end()) {
      error(from, statement.node.line, "label",
            statement.motion + " has no label " + statement.label);
      return 0;
    }
    usedLabels_[index].push_back(statement.label);
    return firstNode_[index][static_cast<std::size_t>(label->second.statement)];
  }

  std::vector<Motion> motions_;
  std::vector<Diagnostic>& errors_;
  Net net_;
  std::map<std::string, int> byName_;
  std::map<std::string, std::vector<int>> groups_;
  std::map<std::string, const std::vector<std::optional<int>>*> postures_;
  std::vector<std::vector<int>> firstNode_;  ///< Of each statement, and the end.
  std::map<std::size_t, std::vector<std::string>> usedLabels_;
};

/// The default entry, used if no file describes it: a transition to each motion's start.
Motion makeEntry(const std::vector<Motion>& motions) {
  Motion entry;
  entry.file = "extern";
  entry.name = "extern";
  entry.labels["start"] = {};
  for (const auto& motion : motions) {
    Statement& statement = entry.statements.emplace_back();
    statement.node.kind = Node::Kind::transition;
    statement.requested = statement.motion = motion.name;
    statement.label = "start";
  }
  return entry;
}

}  // namespace

Compilation compile(const std::vector<Source>& sources, const Rules& rules) {
  Compilation result;
  std::vector<Motion> motions;
  if (sources.size() > maxMotions) {
    result.errors.push_back({sources[maxMotions].file, 0, "", "more than 256 motions"});
    return result;
  }
  for (const auto& source : sources)
    motions.push_back(parse(source.text, source.file, rules, result.errors));
  if (!result.errors.empty()) return result;
  const auto entry = std::find_if(motions.begin(), motions.end(),
                                  [](const Motion& motion) { return motion.name == "extern"; });
  if (entry == motions.end())
    motions.insert(motions.begin(), makeEntry(motions));
  else
    std::rotate(motions.begin(), entry, entry + 1);

  std::vector<std::string> files;
  for (const auto& motion : motions) files.push_back(motion.file);
  Linker linker{std::move(motions), result.errors};
  result.net = linker.link();
  if (result.errors.empty()) result.errors = check(result.net, files);
  if (result.errors.empty()) linker.checkLabels();
  return result;
}

std::vector<Source> readFolder(const std::string& folder, std::vector<Diagnostic>& errors) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  std::error_code failure;
  for (fs::recursive_directory_iterator it{folder, failure}, end; !failure && it != end;
       it.increment(failure))
    if (it->path().extension() == ".mof") files.push_back(it->path().string());
  if (failure) {
    errors.push_back({.file = folder, .message = "cannot be read: " + failure.message()});
    return {};
  }
  std::sort(files.begin(), files.end());
  std::vector<Source> sources;
  for (const auto& file : files) {
    std::ifstream stream{file, std::ios::binary};
    std::stringstream text;
    const auto size = fs::file_size(file, failure);
    std::string problem;
    if (failure || !stream)
      problem = "cannot be read" + (failure ? ": " + failure.message() : "");
    else if (size == 0)
      problem = "is empty";
    else if (size > maxFileSize)
      problem = "is longer than 4 MB";
    else if (!(text << stream.rdbuf()))
      problem = "cannot be read";
    if (problem.empty())
      sources.push_back({file, text.str()});
    else
      errors.push_back({.file = file, .message = problem});
  }
  if (errors.empty() && sources.empty())
    errors.push_back({.file = folder, .message = "holds no .mof file"});
  return sources;
}

Compilation compileFolder(const std::string& folder, const Rules& rules) {
  Compilation result;
  const auto sources = readFolder(folder, result.errors);
  return result.errors.empty() ? compile(sources, rules) : result;
}

std::vector<Node> dataOf(const Source& text, const std::vector<Source>& others, const Rules& rules,
                         std::vector<Diagnostic>& errors) {
  // What a description begins with, if the text is only a part of one.
  const bool part = text.text.find("motion_id") == std::string::npos;
  const std::string begin = part ? "motion_id = tried\nlabel start\n" : "";
  const int added = part ? 2 : 0;
  const Motion motion = parse(begin + text.text, text.file, rules, errors);
  for (auto& error : errors) error.line = std::max(0, error.line - added);
  if (!errors.empty()) return {};

  std::map<std::string, std::vector<std::optional<int>>> postures;
  for (const Source& other : others) {
    std::vector<Diagnostic> theirs;  // reported where the net is compiled
    for (const auto& [name, posture] : parse(other.text, other.file, rules, theirs).postures)
      postures[name] = posture.angles;
  }
  for (const auto& [name, posture] : motion.postures) postures[name] = posture.angles;

  std::vector<Node> data;
  for (const Statement& statement : motion.statements) {
    if (statement.node.kind != Node::Kind::data) continue;
    Node& node = data.emplace_back(statement.node);
    if (statement.posture.empty()) continue;
    if (const auto it = postures.find(statement.posture); it != postures.end())
      node.angles = it->second;
    else
      errors.push_back(
          {text.file, node.line - added, "posture", "unknown posture " + statement.posture});
  }
  return data;
}

}  // namespace motionnet
