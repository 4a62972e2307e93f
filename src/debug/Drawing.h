#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Result.h"
#include "streams/Reflection.h"

namespace gt {

/// A color to draw with.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;

  static constexpr auto fields() {
    return Fields{field<&Color::r>(), field<&Color::g>(), field<&Color::b>(),
                  field<&Color::a>("opacity; 255 is opaque")};
  }
};

namespace colors {
constexpr Color black{0, 0, 0}, white{255, 255, 255}, gray{128, 128, 128}, red{220, 30, 30},
    green{30, 160, 50}, blue{40, 70, 220}, yellow{250, 220, 20}, skyblue{70, 180, 240},
    pink{250, 90, 170}, orange{255, 130, 0};
}

/// The system of coordinates of a drawing (report E.5).
enum class DrawingSpace { field, robot, image };
enum class ElementType {
  point,
  line,
  arrow,
  circle,
  disk,
  ellipse,  ///< Points: center and the ends of the two half axes.
  sector,   ///< Part of a disk. Points: center, begin and end of the arc, counterclockwise.
  path,     ///< Connects its points by lines.
  polygon,
  area,  ///< A filled polygon.
  text
};

enum class PenStyle { solid, dash, dot };

/// One element of a drawing; the meaning of its points depends on its type.
struct DrawingElement {
  ElementType type = ElementType::point;
  std::vector<Vector2d> points;
  double size = 0;
  Color color;
  double penWidth = 1;
  std::string text;
  PenStyle penStyle = PenStyle::solid;

  static constexpr auto fields() {
    return Fields{field<&DrawingElement::type>(),
                  field<&DrawingElement::points>(Unit::mmOrPixel),
                  field<&DrawingElement::size>(
                      Unit::mmOrPixel, "radius of circles, disks and points, height of text"),
                  field<&DrawingElement::color>(),
                  field<&DrawingElement::penWidth>(Unit::pixel),
                  field<&DrawingElement::text>(),
                  field<&DrawingElement::penStyle>("style of lines")};
  }
};

/// A debug drawing (report E.5): all elements drawn under a key in one cycle.
struct Drawing {
  std::string key;
  DrawingSpace space = DrawingSpace::field;
  std::vector<DrawingElement> elements;

  static constexpr auto fields() {
    return Fields{field<&Drawing::key>(), field<&Drawing::space>(), field<&Drawing::elements>()};
  }
};

/// A number over time (report's value history).
struct Plot {
  std::string key;
  double value = 0;

  static constexpr auto fields() { return Fields{field<&Plot::key>(), field<&Plot::value>()}; }
};

/// Numbers for a module, for quick experiments (report E.2). They are assigned to the module's
/// parameters in the order of their declaration; the remaining parameters keep their values.
struct GenericDebugData {
  std::string id;
  std::vector<double> data;

  static constexpr auto fields() {
    return Fields{field<&GenericDebugData::id>("TASK for the active solution, or TASK.SOLUTION"),
                  field<&GenericDebugData::data>()};
  }
};

/// The duration of a piece of work (report E.7).
struct StopwatchTime {
  std::string event;
  double microseconds = 0;

  static constexpr auto fields() {
    return Fields{field<&StopwatchTime::event>("name of a task, or of a piece of work in a module"),
                  field<&StopwatchTime::microseconds>(Unit::us)};
  }
};

/// A text that a module wrote (report's idText).
struct Text {
  std::string text;
  Severity severity = Severity::note;

  static constexpr auto fields() { return Fields{field<&Text::text>(), field<&Text::severity>()}; }
};

}  // namespace gt
