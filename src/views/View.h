#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "observer/ObservedRobot.h"
#include "simulation/Simulation.h"
#include "views/painting/Sheet.h"

namespace gt {

/// What views look at. Filled in by who shows them; all of it must outlive the call of a view.
struct ViewSubject {
  using Series = std::map<std::string, std::vector<ObservedRobot::Point>>;

  Time now;
  std::vector<ObservedRobot*> robots;  ///< Those that are selected; most views show the first.
  Simulation* simulation = nullptr;    ///< Null where nothing is simulated: there is no truth then.
  FieldDimensions field;
  const Series* recorded = nullptr;  ///< Values over time, by their names; null if there are none.

  /// The first robot; an error if there is none.
  Result<ObservedRobot*> robot() const;
  /// The index in the world of a robot of the scene; an error if it is none.
  Result<std::size_t> sceneRobot(const std::string& name) const;
};

/// A view: turns what is known into a sheet, which becomes PNG or SVG, an image of a film, or what
/// a window shows. It keeps nothing between two calls, and asks the robots for what it needs; what
/// debug drawings show must have been asked for (`dk`). One file a view; `builtInViews` lists them.
class View {
 public:
  View(std::string name, std::string help) : name_{std::move(name)}, help_{std::move(help)} {}
  virtual ~View() = default;

  const std::string& name() const { return name_; }
  /// What it shows and what its numbers mean, in one line.
  const std::string& help() const { return help_; }
  /// Shows the subject as it is now. The numbers are the view's own parameters, such as from where
  /// it looks; none of them is needed.
  virtual Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const = 0;

 private:
  std::string name_, help_;
};

}  // namespace gt
