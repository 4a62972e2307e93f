#include "labels/LabelEditor.h"

#include <algorithm>
#include <string_view>

#include "base/Enum.h"
#include "base/Number.h"
#include "representations/infrastructure/Player.h"

namespace gt {
namespace {

constexpr std::size_t mostUndone = 100;

template <typename E>
void addBoxes(std::vector<LabelTool>& tools, BoxName::Kind kind, const std::string& what,
              int number = 0) {
  for (std::size_t i = 0; i < enumCount<E>; ++i)
    tools.push_back({what + " " + std::string{enumNames<E>[i]},
                     LabelTool::Kind::box,
                     {},
                     {kind, static_cast<int>(i), number}});
}

/// The line that a name such as line2 means, from 0; empty if it means none.
std::optional<std::size_t> lineNumber(std::string_view name, std::size_t lines) {
  constexpr std::string_view begin = "line";
  if (!name.starts_with(begin)) return std::nullopt;
  const auto number = numberFrom<std::size_t>(name.substr(begin.size()));
  return number && *number >= 1 && *number <= lines ? std::optional{*number - 1} : std::nullopt;
}

}  // namespace

std::vector<LabelTool> labelTools() {
  using Kind = LabelTool::Kind;
  std::vector<LabelTool> tools{{"ball, whole", Kind::ball, BallView::whole},
                               {"ball, in part or blurred", Kind::ball, BallView::partial},
                               {"no ball", Kind::noBall},
                               {"field line", Kind::line},
                               {"goal's left post", Kind::leftPost},
                               {"goal's right post", Kind::rightPost}};
  addBoxes<FlagType>(tools, BoxName::Kind::flag, "flag");
  addBoxes<GoalColor>(tools, BoxName::Kind::goal, "goal");
  addBoxes<TeamColor>(tools, BoxName::Kind::player, "player");
  tools.push_back({"nothing of the field", Kind::nothing});
  return tools;
}

void LabelEditor::load(ImageLabels labels) {
  labels_ = std::move(labels);
  before_.clear();
  lineOf_ = -1;
  changed_ = false;
}

void LabelEditor::remember() {
  before_.push_back(labels_);
  if (before_.size() > mostUndone) before_.pop_front();
  changed_ = true;
}

void LabelEditor::draw(int picture, std::int64_t time, const LabelTool& tool, const Vector2d& from,
                       const Vector2d& to) {
  using Kind = LabelTool::Kind;
  remember();
  const bool goesOn = tool.kind == Kind::line && lineOf_ == picture;
  lineOf_ = tool.kind == Kind::line ? picture : -1;
  if (tool.kind == Kind::ball) {
    labels_.balls[picture] = {picture, time, tool.view, from, (to - from).norm()};
    return;
  }
  if (tool.kind == Kind::noBall) {
    labels_.balls[picture] = {picture, time, BallView::none, Vector2d::Zero(), 0};
    return;
  }
  FieldLabel& label = labels_.fields[picture];
  label.time = time;
  if (tool.kind == Kind::nothing) label = {time};
  if (tool.kind == Kind::leftPost) label.leftPost = from;
  if (tool.kind == Kind::rightPost) label.rightPost = from;
  if (tool.kind == Kind::line) {
    if (!goesOn || label.lines.empty()) label.lines.emplace_back();
    label.lines.back().push_back(from);
  }
  if (tool.kind != Kind::box) return;
  BoxName name = tool.box;
  // There may be several players of a color.
  if (name.kind == BoxName::Kind::player)
    for (name.number = 1; label.boxes.contains(name);) ++name.number;
  label.boxes[name] = {from, to};
}

std::vector<std::string> LabelEditor::names(int picture) const {
  std::vector<std::string> names;
  if (labels_.balls.contains(picture)) names.emplace_back("ball");
  const auto field = labels_.fields.find(picture);
  if (field == labels_.fields.end()) return names;
  const FieldLabel& label = field->second;
  const std::size_t before = names.size();
  for (std::size_t i = 0; i < label.lines.size(); ++i)
    names.push_back("line" + std::to_string(i + 1));
  if (label.leftPost) names.emplace_back("leftPost");
  if (label.rightPost) names.emplace_back("rightPost");
  for (const auto& [name, box] : label.boxes) names.push_back(name.text());
  if (names.size() == before) names.emplace_back("none");
  return names;
}

void LabelEditor::remove(int picture, const std::string& name) {
  const auto known = names(picture);
  if (std::ranges::find(known, name) == known.end()) return;
  remember();
  lineOf_ = -1;
  if (name == "ball") {
    labels_.balls.erase(picture);
    return;
  }
  FieldLabel& label = labels_.fields[picture];
  if (name == "leftPost") label.leftPost.reset();
  if (name == "rightPost") label.rightPost.reset();
  if (const auto line = lineNumber(name, label.lines.size()))
    label.lines.erase(label.lines.begin() + static_cast<std::ptrdiff_t>(*line));
  if (const auto box = BoxName::parse(name)) label.boxes.erase(*box);
  // An image of which nothing is labeled any more is one that nobody has looked at.
  if (label == FieldLabel{label.time}) labels_.fields.erase(picture);
}

bool LabelEditor::undo() {
  if (before_.empty()) return false;
  labels_ = std::move(before_.back());
  before_.pop_back();
  lineOf_ = -1;
  changed_ = true;
  return true;
}

}  // namespace gt
