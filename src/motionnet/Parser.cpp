#include "motionnet/Parser.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <functional>
#include <map>
#include <optional>

namespace motionnet {
namespace {

using Words = std::vector<std::string_view>;
using Angles = std::vector<std::optional<int>>;

constexpr std::size_t maxStatements = 20000;
constexpr std::size_t maxErrors = 20;  // of one file; garbage is reported briefly
constexpr int maxFrames = 10000;
constexpr int mostOdometry = 10000;  // mm or mrad, a second or at once

Words split(std::string_view line) {
  Words words;
  std::size_t at = 0;
  while (at < line.size()) {
    while (at < line.size() && std::isspace(static_cast<unsigned char>(line[at]))) ++at;
    std::size_t end = at;
    while (end < line.size() && !std::isspace(static_cast<unsigned char>(line[end]))) ++end;
    if (end > at) words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

bool isName(std::string_view word) {
  return !word.empty() && word.size() <= 64 && !std::isdigit(static_cast<unsigned char>(word[0])) &&
         std::all_of(word.begin(), word.end(), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
         });
}

std::optional<int> number(std::string_view word) {
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// An input word for a message: shortened and without control characters.
std::string shown(std::string_view word) {
  std::string s;
  for (const char c : word.substr(0, 40))
    s += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
  return "\"" + s + "\"";
}

class Parser {
 public:
  Parser(std::string_view file, const Rules& rules, std::vector<Diagnostic>& errors)
      : rules_(rules), errors_(errors) {
    motion_.file = file;
  }

  Motion parse(std::string_view text) {
    const auto errorsBefore = errors_.size();
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
    while (!text.empty() && motion_.statements.size() < maxStatements) {
      if (errors_.size() > errorsBefore + maxErrors) return std::move(motion_);
      const auto end = text.find('\n');
      auto line = text.substr(0, end);
      text = end == text.npos ? std::string_view{} : text.substr(end + 1);
      line_ += 1;
      const auto words = split(line.substr(0, line.find("//")));
      if (!words.empty()) parseLine(words);
    }
    if (!text.empty()) error("", "more than 20000 statements");
    line_ = 0;
    if (motion_.name.empty()) error("motion_id", "missing; the first line must name the motion");
    if (!motion_.labels.count("start")) error("label start", "missing; every motion begins there");
    return std::move(motion_);
  }

 private:
  void error(std::string field, std::string message) {
    errors_.push_back({motion_.file, line_, std::move(field), std::move(message)});
  }

  void parseLine(const Words& words) {
    const auto word = words[0];
    if (word == "motion_id")
      parseMotionId(words);
    else if (motion_.name.empty() && motion_.nameLine == 0) {
      motion_.nameLine = line_;
      error(std::string{"motion_id"}, "must come before everything else");
    } else if (word == "group")
      parseGroup(words);
    else if (word == "posture")
      parsePosture(words);
    else if (word == "label")
      parseLabel(words);
    else if (word == "value")
      parseValue(words);
    else if (word == "transition")
      parseTransition(words);
    else if (word == "pid")
      parsePid(words);
    else if (word == "odometry")
      parseOdometry(words, Node::Kind::odometry);
    else if (word == "displacement")
      parseOdometry(words, Node::Kind::displacement);
    else if (word == "~" || number(word) || values_.contains(word))
      parseData(words);
    else
      error(shown(word),
            "unknown; a line begins with motion_id, group, posture, label, value, "
            "transition, pid, odometry, displacement, an angle, a value's name or ~");
  }

  bool wantName(std::string_view word, const char* what) {
    if (isName(word)) return true;
    error(what, shown(word) + " is no name: letters, digits, - and _, no digit first");
    return false;
  }

  void parseMotionId(const Words& words) {
    if (words.size() != 3 || words[1] != "=")
      return error("motion_id", "expected: motion_id = NAME");
    if (!motion_.name.empty()) return error("motion_id", "given twice");
    motion_.nameLine = line_;
    if (wantName(words[2], "motion_id")) motion_.name = words[2];
    if (words[2] == "allMotions") error("motion_id", "allMotions stands for all motions");
  }

  void parseGroup(const Words& words) {
    if (words.size() < 4 || words[2] != "=")
      return error("group", "expected: group NAME = MOTION MOTION ...");
    if (!wantName(words[1], "group")) return;
    Motion::Group group{{}, line_};
    for (std::size_t i = 3; i < words.size(); ++i)
      if (wantName(words[i], "group")) group.members.emplace_back(words[i]);
    if (!motion_.groups.emplace(words[1], group).second)
      error("group", shown(words[1]) + " is defined twice");
  }

  /// `posture NAME = A1 ... An` gives angles a name, `posture NAME INTERPOLATE COUNT` is data.
  void parsePosture(const Words& words) {
    const std::size_t joints = rules_.joints.size();
    const bool defines = words.size() > 2 && words[2] == "=";
    if (words.size() != (defines ? joints + 3 : 4))
      return error("posture", "expected: posture NAME INTERPOLATE COUNT, or posture NAME = and " +
                                  std::to_string(joints) + " angles");
    if (!wantName(words[1], "posture")) return;
    if (!defines) return addData({}, words[2], words[3], words[1]);
    auto angles = parseAngles({words.begin() + 3, words.end()});
    if (!angles) return;
    if (!motion_.postures.emplace(words[1], Motion::Posture{*std::move(angles), line_}).second)
      error("posture", shown(words[1]) + " is defined twice");
  }

  void parseLabel(const Words& words) {
    if (words.size() != 2) return error("label", "expected: label NAME");
    if (!wantName(words[1], "label")) return;
    const Motion::Label label{static_cast<int>(motion_.statements.size()), line_};
    if (!motion_.labels.emplace(words[1], label).second)
      error("label", shown(words[1]) + " is defined twice");
  }

  void parseValue(const Words& words) {
    if (words.size() != 4 || words[2] != "=")
      return error("value", "expected: value NAME = NUMBER");
    if (!wantName(words[1], "value")) return;
    const auto value = number(words[3]);
    if (!value) return error("value", shown(words[3]) + " is no whole number");
    if (!values_.emplace(words[1], *value).second)
      error("value", shown(words[1]) + " is defined twice");
  }

  void parseTransition(const Words& words) {
    if (words.size() != 4)
      return error("transition", "expected: transition REQUESTED MOTION LABEL");
    const bool requested = wantName(words[1], "requested");
    const bool motion = wantName(words[2], "motion");
    const bool label = wantName(words[3], "label");
    if (!requested || !motion || !label) return;
    auto& statement = add(Node::Kind::transition);
    statement.requested = words[1];
    statement.motion = words[2];
    statement.label = words[3];
  }

  void parsePid(const Words& words) {
    if (words.size() != 5) return error("pid", "expected: pid JOINT P I D");
    const auto joint = std::find_if(rules_.joints.begin(), rules_.joints.end(),
                                    [&](const JointRule& rule) { return rule.name == words[1]; });
    if (joint == rules_.joints.end())
      return error("pid", "no joint has the name " + shown(words[1]));
    const auto p = integer(words[2], "p", 0, 255), i = integer(words[3], "i", 0, 255),
               d = integer(words[4], "d", 0, 255);
    if (!p || !i || !d) return;
    auto& node = add(Node::Kind::pid).node;
    node.joint = static_cast<int>(joint - rules_.joints.begin());
    node.p = *p;
    node.i = *i;
    node.d = *d;
  }

  void parseOdometry(const Words& words, Node::Kind kind) {
    const std::string word{words[0]};
    if (words.size() != 4) return error(word, "expected: " + word + " X Y ROTATION");
    const auto x = integer(words[1], "x", -mostOdometry, mostOdometry),
               y = integer(words[2], "y", -mostOdometry, mostOdometry),
               rotation = integer(words[3], "rotation", -mostOdometry, mostOdometry);
    if (!x || !y || !rotation) return;
    auto& node = add(kind).node;
    node.x = *x;
    node.y = *y;
    node.rotation = *rotation;
  }

  void parseData(const Words& words) {
    const std::size_t joints = rules_.joints.size();
    if (words.size() != joints + 2)
      return error("data", "expected " + std::to_string(joints) +
                               " angles, the interpolation and the count; there are " +
                               std::to_string(words.size()) + " values");
    if (auto angles = parseAngles({words.begin(), words.end() - 2}))
      addData(*std::move(angles), words[joints], words[joints + 1], {});
  }

  /// An angle or ~ for each joint.
  std::optional<Angles> parseAngles(const Words& words) {
    Angles angles(words.size());
    bool good = true;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == "~") continue;
      const auto& rule = rules_.joints[i];
      angles[i] = integer(words[i], rule.name.c_str(), rule.low, rule.high);
      good = good && angles[i];
    }
    return good ? std::optional{std::move(angles)} : std::nullopt;
  }

  void addData(Angles angles, std::string_view interpolateWord, std::string_view count,
               std::string_view posture) {
    const auto interpolate = integer(interpolateWord, "interpolation", 0, 1);
    const auto frames = integer(count, "count", 1, maxFrames);
    if (!interpolate || !frames) return;
    Statement& statement = add(Node::Kind::data);
    statement.posture = posture;
    statement.node.angles = std::move(angles);
    statement.node.interpolate = *interpolate == 1;
    statement.node.frames = *frames;
  }

  /// A number, or that of a value's name.
  std::optional<int> integer(std::string_view word, const char* field, int low, int high) {
    const auto named = values_.find(word);
    const auto value = named == values_.end() ? number(word) : named->second;
    if (!value)
      error(field, shown(word) + " is no whole number");
    else if (*value < low || *value > high)
      error(field, std::to_string(*value) + " is not within " + std::to_string(low) + " and " +
                       std::to_string(high));
    else
      return value;
    return std::nullopt;
  }

  Statement& add(Node::Kind kind) {
    Statement statement;
    statement.node.kind = kind;
    statement.node.line = line_;
    motion_.statements.push_back(std::move(statement));
    return motion_.statements.back();
  }

  const Rules& rules_;
  std::vector<Diagnostic>& errors_;
  Motion motion_;
  std::map<std::string, int, std::less<>> values_;
  int line_ = 0;
};

}  // namespace

Motion parse(std::string_view text, std::string_view file, const Rules& rules,
             std::vector<Diagnostic>& errors) {
  return Parser{file, rules, errors}.parse(text);
}

}  // namespace motionnet
