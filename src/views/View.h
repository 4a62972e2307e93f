#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "observer/ObservedRobot.h"
#include "simulation/Simulation.h"
#include "views/painting/Sheet.h"

namespace gt {

/// The data that views show. Filled in by the caller of a view; all of it must outlive the call.
struct ViewSubject {
  using Series = std::map<std::string, std::vector<ObservedRobot::Point>>;

  Time now;
  std::vector<ObservedRobot*> robots;  ///< The selected robots; most views show the first.
  Simulation* simulation = nullptr;    ///< Null where nothing is simulated: then without truth.
  FieldDimensions field;
  const Series* recorded = nullptr;  ///< Values over time, by their names; null if there are none.

  /// The first robot; an error if there is none.
  Result<ObservedRobot*> robot() const;
  /// The index in the world of a robot of the scene; an error if it is none.
  Result<std::size_t> sceneRobot(const std::string& name) const;
};

/// A view: paints data on a sheet, which becomes PNG or SVG, an image of a film, or the content of
/// a window. It is stateless, and requests the values that it needs from the robots; debug drawings
/// must have been requested before (`dk`). One file a view; `builtInViews` lists them.
class View {
 public:
  View(std::string name, std::string help) : name_{std::move(name)}, help_{std::move(help)} {}
  virtual ~View() = default;

  const std::string& name() const { return name_; }
  /// Describes in one line what it shows and what its numbers mean.
  const std::string& help() const { return help_; }
  /// Paints the present state of the subject. `numbers` are the view's own parameters, such as the
  /// place from which it looks; all of them are optional.
  virtual Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const = 0;

 private:
  std::string name_, help_;
};

}  // namespace gt
