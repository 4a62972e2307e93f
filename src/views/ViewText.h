#pragma once
#include <string>
#include <utility>
#include <vector>

#include "representations/infrastructure/Player.h"
#include "simulation/rules/GameEvent.h"
#include "views/View.h"

namespace gt {

/// A number with some digits behind the point.
std::string decimal(double value, int digits = 1);
/// A time in seconds.
double secondsOf(Time time);

/// The team of a robot; red if the robot does not report it.
TeamColor teamOf(ObservedRobot& robot);

constexpr Color faintText{120, 120, 120}, barColor{90, 140, 210};

/// Text in lines and columns, from the top of a sheet.
class TextLines {
 public:
  static constexpr double height = 18;  ///< Of a line, in pixels.

  TextLines(Sheet& sheet, double left) : sheet_{sheet}, left_{left} {}
  /// Adds a line. Each column has its distance from the left (pixels) and its text.
  void add(const std::vector<std::pair<double, std::string>>& columns, Color color = colors::black);
  void heading(const std::string& text);
  /// The base line of the text that was added last (pixels from the top).
  double y() const { return y_; }

  /// The height of a sheet for a number of lines (pixels).
  static int sheetHeight(std::size_t lines);

 private:
  Sheet& sheet_;
  double left_;
  double y_ = 10;
};

}  // namespace gt
