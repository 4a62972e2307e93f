#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/Result.h"
#include "views/View.h"

namespace gt {

class Console;
class FilmWriter;

/// Records values (command plot) and a film of a view while time passes.
class ViewRecorder {
 public:
  ViewRecorder();
  ~ViewRecorder();  ///< Closes the film.

  /// Records a value from now on, by its path; does nothing if it is already recorded.
  Result<void> record(Console& console, const std::string& path);
  /// Stops recording a value, and discards its records; false if it was not recorded.
  bool forget(const std::string& path) { return series_.erase(path) > 0; }
  /// The recorded values, by their paths.
  const ViewSubject::Series& series() const { return series_; }

  /// Films a view from now on, 25 images a simulated second.
  Result<void> startFilm(Console& console, const std::string& file,
                         std::shared_ptr<const View> view, std::vector<double> numbers);
  /// Ends the film; returns its file.
  Result<std::string> stopFilm();

  /// Called after each step.
  void step(Console& console);
  /// Discards the values, and ends the film.
  void clear(Console& console);

 private:
  struct Film;
  ViewSubject::Series series_;
  std::unique_ptr<Film> film_;
};

}  // namespace gt
