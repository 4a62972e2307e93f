#include "labels/FieldLabels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/Enum.h"
#include "base/File.h"
#include "base/Lines.h"
#include "base/Number.h"
#include "representations/infrastructure/Player.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {
namespace {

constexpr std::string_view fieldHeading = "picture,time,what,x,y";
constexpr std::array columns{"picture", "time", "what", "x", "y"};

using Cells = std::array<std::string_view, columns.size()>;

/// A row of the table that is read; an error names the cell.
struct Row {
  const std::string& file;
  int line;
  Cells cells;

  Error wrong(std::size_t column, std::string what) const {
    return {.file = file, .line = line, .field = columns[column], .what = std::move(what)};
  }
  template <typename T>
  Result<T> number(std::size_t column) const {
    if (const auto value = numberFrom<T>(cells[column])) return *value;
    return wrong(column, "a number was expected");
  }
};

/// The labels that are read, and which line of an image each of its numbers means.
struct Reading {
  std::map<int, FieldLabel> labels;
  std::map<std::pair<int, std::string_view>, std::size_t> lines;
  std::map<std::pair<int, BoxName>, int> corners;  ///< How many of a box were read.

  Result<void> add(const Row& row);
};

Result<void> Reading::add(const Row& row) {
  const auto picture = row.number<int>(0);
  if (!picture) return picture.error();
  const auto time = row.number<std::int64_t>(1);
  if (!time) return time.error();
  const auto x = row.number<double>(3), y = row.number<double>(4);
  if (!x) return x.error();
  if (!y) return y.error();
  if (!std::isfinite(*x) || !std::isfinite(*y)) return row.wrong(3, "a number was expected");
  const auto [label, isNew] = labels.try_emplace(*picture);
  if (isNew) label->second.time = *time;
  if (label->second.time != *time) return row.wrong(1, "this image has another time above");
  const std::string_view what = row.cells[2];
  if (what == "none") return {};
  if (what == "leftPost") {
    label->second.leftPost = Vector2d{*x, *y};
  } else if (what == "rightPost") {
    label->second.rightPost = Vector2d{*x, *y};
  } else if (what.starts_with("line")) {
    auto& all = label->second.lines;
    const auto [line, isFirst] = lines.try_emplace({*picture, what}, all.size());
    if (isFirst) all.emplace_back();
    all[line->second].emplace_back(*x, *y);
  } else if (const auto box = BoxName::parse(what)) {
    BoxLabel& known = label->second.boxes[*box];
    int& count = corners[{*picture, *box}];
    if (++count > 2) return row.wrong(2, "has more than two corners");
    (count == 1 ? known.from : known.to) = Vector2d{*x, *y};
    if (count == 1) known.to = known.from;
  } else {
    return row.wrong(2,
                     "line and a number, leftPost, rightPost, flag.NAME, goal.COLOR, player.COLOR "
                     "and a number, or none was expected");
  }
  return {};
}

template <typename E>
std::optional<BoxName> boxName(BoxName::Kind kind, std::string_view name, int number = 0) {
  const auto which = enumValue<E>(name);
  if (!which) return std::nullopt;
  return BoxName{kind, static_cast<int>(*which), number};
}

double distanceToSegment(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
  const Vector2d way = b - a;
  const double square = way.squaredNorm();
  const double part = square > 0 ? std::clamp((point - a).dot(way) / square, 0.0, 1.0) : 0;
  return (point - (a + part * way)).norm();
}

}  // namespace

double FieldLabel::distance(const Vector2d& point) const {
  // Between points further apart something was in the way, or the line was not labeled.
  constexpr double farthest = 25;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vector2d& next = line[std::min(i + 1, line.size() - 1)];
      const bool joined = (next - line[i]).norm() <= farthest;
      least = std::min(least, distanceToSegment(point, line[i], joined ? next : line[i]));
    }
  return least;
}

std::string BoxName::text() const {
  switch (kind) {
    case Kind::flag:
      return "flag." + std::string{enumName(static_cast<FlagType>(which))};
    case Kind::goal:
      return "goal." + std::string{enumName(static_cast<GoalColor>(which))};
    case Kind::player:
      break;
  }
  return "player." + std::string{enumName(static_cast<TeamColor>(which))} + std::to_string(number);
}

std::optional<BoxName> BoxName::parse(std::string_view text) {
  const std::size_t dot = text.find('.');
  if (dot == text.npos) return std::nullopt;
  const std::string_view kind = text.substr(0, dot);
  std::string_view name = text.substr(dot + 1);
  if (kind == "flag") return boxName<FlagType>(Kind::flag, name);
  if (kind == "goal") return boxName<GoalColor>(Kind::goal, name);
  if (kind != "player") return std::nullopt;
  const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
  const auto number = numberFrom<int>(name.substr(digits));
  if (!number || *number < 1) return std::nullopt;
  return boxName<TeamColor>(Kind::player, name.substr(0, digits), *number);
}

Result<std::map<int, FieldLabel>> parseFieldLabels(std::string_view text, const std::string& file) {
  Reading reading;
  LineReader reader{text};
  while (const auto row = reader.next()) {
    const int line = reader.number();
    std::string_view rest = *row;
    if (line == 1) {
      if (rest == fieldHeading) continue;
      return Error{.file = file, .line = line, .what = std::string{fieldHeading} + " was expected"};
    }
    if (rest.empty()) continue;
    Cells cells;
    for (std::string_view& cell : cells) {
      cell = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(cell.size() + 1, rest.size()));
    }
    if (auto done = reading.add({file, line, cells}); !done) return done.error();
  }
  if (reading.labels.empty()) return Error{.file = file, .what = "there are no labels"};
  for (const auto& [box, count] : reading.corners)
    if (count < 2)
      return Error{.file = file,
                   .field = box.second.text(),
                   .what = "has one corner only in image " + std::to_string(box.first)};
  return std::move(reading.labels);
}

Result<std::map<int, FieldLabel>> readFieldLabels(const std::string& file) {
  const auto content = readFile(file);
  if (!content) return content.error();
  return parseFieldLabels(*content, file);
}

std::string fieldLabelTable(const std::map<int, FieldLabel>& labels) {
  std::string text = std::string{fieldHeading} + "\n";
  for (const auto& [picture, label] : labels) {
    const std::string begin = std::to_string(picture) + "," + std::to_string(label.time) + ",";
    const std::size_t before = text.size();
    const auto add = [&](const std::string& what, const Vector2d& at) {
      text += begin + what + "," + numberText(at.x()) + "," + numberText(at.y()) + "\n";
    };
    for (std::size_t i = 0; i < label.lines.size(); ++i)
      for (const Vector2d& point : label.lines[i]) add("line" + std::to_string(i + 1), point);
    if (label.leftPost) add("leftPost", *label.leftPost);
    if (label.rightPost) add("rightPost", *label.rightPost);
    for (const auto& [name, box] : label.boxes) {
      add(name.text(), box.from);
      add(name.text(), box.to);
    }
    if (text.size() == before) add("none", Vector2d::Zero());
  }
  return text;
}

}  // namespace gt
