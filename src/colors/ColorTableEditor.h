#pragma once
#include <optional>
#include <vector>

#include "representations/perception/ColorTable64.h"

namespace gt {

/// Which colors the median filter adds to a class (report J.6.1).
struct MedianRule {
  int neighbors = 6;      ///< At least so many colors of the class have to be near.
  int distance = 1;       ///< How far away those may be, in cubes of the table (1 to 8).
  bool reassign = false;  ///< Also colors that have a class already.
};

/// What is done with each image that comes in (report J.6.1, *auto-remove/median*).
struct AutomaticFilters {
  bool remove = false, median = false;
  std::optional<ColorClass> selected;  ///< Nothing for all colors.
  MedianRule rule;
};

/// Makes a color table by clicking (report J.6.1). A color is a 4x4x4 cube of YCbCr. Each change
/// is a step that can be undone, as long as no more than four million colors were changed since.
class ColorTableEditor {
 public:
  explicit ColorTableEditor(const ColorTable64& table = {}) : table_(table) {}

  const ColorTable64& table() const { return table_; }

  /// Assigns the class to the color of a pixel: the left button.
  void set(const Pixel& pixel, ColorClass colorClass);
  /// Takes its class from the color of a pixel: the right button.
  void remove(const Pixel& pixel) { set(pixel, ColorClass::noColor); }
  /// Takes all its colors from a class.
  void clear(ColorClass colorClass);
  void reset();

  /// Removes the colors that have none of their class among their 26 neighbors; of the selected
  /// class, or of all.
  void removeIsolated(std::optional<ColorClass> selected = {});
  /// Adds colors to the selected class that have enough of its colors near, or to all classes
  /// the colors that have enough of theirs near: to that class of which there are most.
  void median(const MedianRule& rule, std::optional<ColorClass> selected = {});

  /// Filters as a part of the step before.
  void onPicture(const AutomaticFilters& filters);

  /// Takes the last step back; false if there is none.
  bool undo();

 private:
  struct Change {
    std::uint32_t color;
    ColorClass before;
  };
  using Step = std::vector<Change>;

  void assign(std::size_t color, ColorClass colorClass, Step& step);
  Step isolated(std::optional<ColorClass> selected);
  Step added(const MedianRule& rule, std::optional<ColorClass> selected);
  void keep(Step step);

  ColorTable64 table_;
  std::vector<Step> steps_;
};

}  // namespace gt
