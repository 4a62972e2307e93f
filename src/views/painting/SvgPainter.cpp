#include "views/painting/SvgPainter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/Base64.h"
#include "images/Png.h"

namespace gt {
namespace {

/// A coordinate with two digits behind the point, if they are needed.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string result{text};
  result.erase(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string{" "} + name + "=\"" + value + "\"";
}

std::string place(const char* x, const char* y, const Vector2d& at) {
  return attribute(x, number(at.x())) + attribute(y, number(at.y()));
}

/// A color as an attribute, with its opacity if it is not opaque.
std::string paintAttribute(const char* name, const Color& color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
  return attribute(name, text) +
         (color.a == 255
              ? ""
              : attribute((std::string{name} + "-opacity").c_str(), number(color.a / 255.0)));
}

std::string stroke(const SheetPainter::Pen& pen) {
  std::string text = " fill=\"none\"" + paintAttribute("stroke", pen.color);
  if (pen.width != 1) text += attribute("stroke-width", number(pen.width));
  if (pen.style != PenStyle::solid)
    text += attribute("stroke-dasharray", number(pen.style == PenStyle::dash ? 4 * pen.width : 0) +
                                              " " + number(3 * pen.width));
  return text;
}

std::string listOf(std::span<const Vector2d> points) {
  std::string text;
  for (const Vector2d& p : points)
    text += (text.empty() ? "" : " ") + number(p.x()) + "," + number(p.y());
  return attribute("points", text);
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else
      result += c;
  }
  return result;
}

}  // namespace

SvgPainter::SvgPainter(int width, int height) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  svg_ = R"(<svg xmlns="http://www.w3.org/2000/svg")" + attribute("width", w) +
         attribute("height", h) + attribute("viewBox", "0 0 " + w + " " + h) +
         " font-family=\"sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\""
         " xml:space=\"preserve\">\n";
}

void SvgPainter::line(std::span<const Vector2d> points, bool closed, const Pen& pen) {
  svg_ += std::string{closed ? "<polygon" : "<polyline"} + listOf(points) + stroke(pen) + "/>\n";
}

void SvgPainter::area(std::span<const Vector2d> corners, Color color) {
  svg_ += "<polygon" + listOf(corners) + paintAttribute("fill", color) + "/>\n";
}

void SvgPainter::circle(const Vector2d& center, double radius, const Pen& pen) {
  svg_ +=
      "<circle" + place("cx", "cy", center) + attribute("r", number(radius)) + stroke(pen) + "/>\n";
}

void SvgPainter::disk(const Vector2d& center, double radius, Color color) {
  svg_ += "<circle" + place("cx", "cy", center) + attribute("r", number(radius)) +
          paintAttribute("fill", color) + "/>\n";
}

void SvgPainter::sector(const Vector2d& center, double radius, double from, double to,
                        Color color) {
  const auto text = [](const Vector2d& p) { return number(p.x()) + " " + number(p.y()); };
  double angle = std::fmod(to - from, 2 * pi);
  if (angle < 0) angle += 2 * pi;
  const std::string r = number(radius);
  svg_ += "<path" +
          attribute("d", "M" + text(center) + "L" + text(center + radius * direction(from)) + "A" +
                             r + " " + r + " 0 " + (angle > pi ? "1" : "0") + " 1 " +
                             text(center + radius * direction(to)) + "Z") +
          paintAttribute("fill", color) + "/>\n";
}

void SvgPainter::text(const Vector2d& at, std::string_view text, const Font& font) {
  const Color& c = font.color;
  const Color seam = c.r + c.g + c.b > 380 ? colors::black : colors::white;
  svg_ += "<text" + place("x", "y", at) + attribute("font-size", number(font.height)) +
          (font.bold ? attribute("font-weight", "bold") : "") + paintAttribute("fill", c) +
          (font.seam ? paintAttribute("stroke", {seam.r, seam.g, seam.b,
                                                 static_cast<std::uint8_t>(c.a * 7 / 10)}) +
                           attribute("stroke-width", number(std::max(2.0, font.height / 6))) +
                           attribute("paint-order", "stroke")
                     : "") +
          ">" + escaped(text) + "</text>\n";
}

void SvgPainter::picture(const RgbImage& picture, const Vector2d& at, double scale) {
  const auto png = encodePng(picture.width, picture.height, picture.pixels);
  svg_ += "<image" + place("x", "y", at) + attribute("width", number(picture.width * scale)) +
          attribute("height", number(picture.height * scale)) +
          " image-rendering=\"pixelated\" href=\"data:image/png;base64," +
          base64(std::as_bytes(std::span{png})) + "\"/>\n";
}

}  // namespace gt
