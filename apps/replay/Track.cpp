#include "replay/Track.h"

#include <algorithm>

#include "views/painting/Sheet.h"

namespace gt {
namespace {

constexpr double scale = 0.12;  // pixels a millimeter
constexpr double margin = 400;  // mm around the field
constexpr double jump = 300;    // mm between two images
constexpr Color carpet{46, 120, 60};

/// The field's lines on a sheet.
class FieldSheet {
 public:
  explicit FieldSheet(const FieldDimensions& field)
      : half_{std::max(field.xGoalBack, field.xGroundline) + margin, field.ySideline + margin},
        sheet_{static_cast<int>(2 * half_.x() * scale), static_cast<int>(2 * half_.y() * scale),
               carpet} {
    const double x = field.xGroundline, y = field.ySideline;
    box({-x, -y}, {x, y}, colors::white);
    line({0, -y}, {0, y}, colors::white, 2);
    for (const double side : {-1., 1.}) {
      box({side * x, -field.yPenaltyArea}, {side * field.xPenaltyArea, field.yPenaltyArea},
          colors::white);
      box({side * x, -field.yGoal}, {side * field.xGoalBack, field.yGoal},
          side < 0 ? colors::yellow : colors::skyblue);
    }
    constexpr int corners = 48;
    for (int i = 0; i < corners; ++i)
      line(field.centerCircleRadius * direction(2 * pi * i / corners),
           field.centerCircleRadius * direction(2 * pi * (i + 1) / corners), colors::white, 2);
  }

  void line(const Vector2d& from, const Vector2d& to, Color color, double width) {
    sheet_.line(at(from), at(to), color, width);
  }
  void text(const Vector2d& where, const std::string& words, Color color) {
    sheet_.text(at(where), words, color, 14);
  }
  Result<void> write(const std::string& path) const { return sheet_.write(path); }

 private:
  Vector2d at(const Vector2d& p) const {
    return {(p.x() + half_.x()) * scale, (half_.y() - p.y()) * scale};
  }
  void box(const Vector2d& a, const Vector2d& b, Color color) {
    line(a, {a.x(), b.y()}, color, 2);
    line({a.x(), b.y()}, b, color, 2);
    line(b, {b.x(), a.y()}, color, 2);
    line({b.x(), a.y()}, a, color, 2);
  }

  Vector2d half_;
  Sheet sheet_;
};

}  // namespace

Result<void> Track::write(const std::string& path, const FieldDimensions& field) const {
  FieldSheet sheet{field};
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    const Pose2D& end = poses_.back().pose;
    const auto byOdometry = [&](std::size_t k) {
      return (end * odometry_[k].relativeTo(odometry_.back())).translation;
    };
    sheet.line(byOdometry(i - 1), byOdometry(i), colors::black, 1.5);
    // Another hypothesis is no walk.
    const Vector2d &from = poses_[i - 1].pose.translation, &to = poses_[i].pose.translation;
    if ((to - from).norm() < jump) sheet.line(from, to, colors::red, 2);
  }
  // Where it looked, ever stronger the surer it was.
  for (const RobotPose& p : poses_) {
    const auto alpha = static_cast<std::uint8_t>(55 + 200 * std::clamp(p.validity, 0., 1.));
    sheet.line(p.pose.translation, p.pose * Vector2d{150, 0},
               {colors::red.r, colors::red.g, colors::red.b, alpha}, 1);
  }
  const Vector2d corner{-field.xGroundline, -field.ySideline - 300};
  sheet.text(corner, "red: the self-locator's track, each pose with its direction", colors::white);
  sheet.text(corner + Vector2d{0, 150}, "black: odometry alone", colors::white);
  return sheet.write(path);
}

}  // namespace gt
