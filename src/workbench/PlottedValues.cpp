#include "workbench/PlottedValues.h"

#include <algorithm>
#include <deque>

#include "console/Values.h"

namespace gt {
namespace {

const std::deque<ObservedRobot::Point>* plotOf(Console& console, const std::string& name) {
  const std::size_t blank = name.find(' ');
  if (blank == name.npos) return nullptr;
  ConsoleRobot* const robot = console.session().find(name.substr(0, blank));
  if (!robot) return nullptr;
  const auto& plots = robot->observed().plots();
  const auto found = plots.find(name.substr(blank + 1));
  return found == plots.end() ? nullptr : &found->second;
}

template <typename List>
void addSince(std::vector<ObservedRobot::Point>& points, const List& list, Time after) {
  const auto begin = std::ranges::upper_bound(list, after, {}, &ObservedRobot::Point::time);
  points.insert(points.end(), begin, list.end());
}

std::string fullName(Console& console, const std::string& name) {
  const std::string first = name.substr(0, name.find('.'));
  const auto robot = console.firstRobot();
  if (!robot || name.find(' ') != name.npos || console.session().find(first)) return name;
  return (*robot)->observed().has(first) ? (*robot)->name() + "." + name : name;
}

}  // namespace

PlottedValues PlottedValues::since(Console& console, const std::map<std::string, Time>& known) {
  PlottedValues news{console.session().time(), {}};
  const auto& series = console.recorder().series();
  for (const auto& [name, after] : known) {
    Points fresh{name, {}};
    if (const auto* plot = plotOf(console, name))
      addSince(fresh.points, *plot, after);
    else if (const auto recorded = series.find(name); recorded != series.end())
      addSince(fresh.points, recorded->second, after);
    if (!fresh.points.empty()) news.points.push_back(std::move(fresh));
  }
  return news;
}

std::vector<std::string> plottableNames(Console& console) {
  std::vector<std::string> names = valueNames(console);
  for (ConsoleRobot* robot : console.selected())
    for (const auto& [key, points] : robot->observed().plots())
      names.push_back(robot->name() + " " + key);
  std::ranges::sort(names);
  return names;
}

Result<std::string> plottableName(Console& console, const std::string& name) {
  std::string full = fullName(console, name);
  if (plotOf(console, full)) return full;
  const auto value = valueAt(console, full);
  if (!value) return value.error();
  if (!value->number) return Error{.field = name, .what = "is no number"};
  return full;
}

}  // namespace gt
