#include "views/ViewText.h"

#include <algorithm>
#include <cstdio>

namespace gt {

std::string decimal(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

double secondsOf(Time time) {
  return static_cast<double>(time.ms) / 1000;
}

TeamColor teamOf(ObservedRobot& robot) {
  const auto player = robot.value<Player>();
  return player ? (*player)->teamColor : TeamColor::red;
}

void TextLines::add(const std::vector<std::pair<double, std::string>>& columns, Color color) {
  y_ += height;
  for (const auto& [x, text] : columns) sheet_.text({left_ + x, y_}, text, color);
}

void TextLines::heading(const std::string& text) {
  y_ += 6;
  add({{0, text}}, faintText);
}

int TextLines::sheetHeight(std::size_t lines) {
  constexpr std::size_t mostLines = 200;
  return static_cast<int>(height * static_cast<double>(std::min(lines, mostLines))) + 60;
}

}  // namespace gt
