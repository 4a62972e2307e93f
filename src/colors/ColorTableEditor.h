#pragma once
#include <optional>
#include <vector>

#include "representations/perception/ColorTable64.h"

namespace gt {

/// Parameters of the median filter, which adds colors to a class (report J.6.1).
struct MedianRule {
  int neighbors = 6;      ///< Least number of near colors of the class.
  int distance = 1;       ///< Greatest distance of near colors, in cubes of the table (1 to 8).
  bool reassign = false;  ///< Whether colors that already have a class may change it.
};

/// Filters that are applied after each image (report J.6.1, *auto-remove/median*).
struct AutomaticFilters {
  bool remove = false, median = false;
  std::optional<ColorClass> selected;  ///< The class to be filtered; empty for all.
  MedianRule rule;
};

/// Creates a color table by clicking (report J.6.1). A color is a 4x4x4 cube of YCbCr. Each change
/// is a step that can be undone, as long as no more than four million colors were changed since.
class ColorTableEditor {
 public:
  explicit ColorTableEditor(const ColorTable64& table = {}) : table_(table) {}

  const ColorTable64& table() const { return table_; }

  /// Assigns a class to the color of a pixel (left button).
  void set(const Pixel& pixel, ColorClass colorClass);
  /// Removes the class from the color of a pixel (right button).
  void remove(const Pixel& pixel) { set(pixel, ColorClass::noColor); }
  /// Removes all colors from a class.
  void clear(ColorClass colorClass);
  void reset();

  /// Removes the colors without a color of the same class among their 26 neighbors, in the selected
  /// class or in all.
  void removeIsolated(std::optional<ColorClass> selected = {});
  /// Adds colors with enough near colors of the selected class to that class. Without a selected
  /// class, adds each color to the class with most near colors, if these are enough.
  void median(const MedianRule& rule, std::optional<ColorClass> selected = {});

  /// Applies the filters as a part of the previous step.
  void onPicture(const AutomaticFilters& filters);

  /// Undoes the last step. Returns false if there is none.
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
