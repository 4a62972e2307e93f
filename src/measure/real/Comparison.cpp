#include "measure/real/Comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/Statistics.h"

namespace gt {

double differenceOfDistances(const BallPercept& ball) {
  if (ball.distanceByProjection <= 0 || ball.distanceBySize <= 0) return 0;
  return ball.distanceByProjection / ball.distanceBySize - 1;
}

Verdict compareDistances(const BallPercept& ball, const BallLabel* label) {
  constexpr double nearest = 1500, most = 0.1, sameRadius = 0.05;
  if (!ball.seen || ball.distanceByProjection <= 0 || ball.distanceBySize <= 0)
    return Verdict::notCompared;
  if (std::min(ball.distanceBySize, ball.distanceByProjection) >= nearest)
    return Verdict::notCompared;
  if (std::abs(differenceOfDistances(ball)) <= most) return Verdict::agree;
  if (!label || label->view != BallView::whole) return Verdict::notKnown;
  return std::abs(ball.radiusInImage / label->radius - 1) <= sameRadius ? Verdict::cameraMatrixIsOff
                                                                        : Verdict::visionIsOff;
}

void Comparison::add(const BallPercept& ball, const BallLabel* label) {
  const Verdict verdict = compareDistances(ball, label);
  ++verdicts_[static_cast<std::size_t>(verdict)];
  if (verdict != Verdict::notCompared) ratios_.push_back(1 + differenceOfDistances(ball));
  if (!label) return;
  const auto view = static_cast<std::size_t>(label->view);
  ++total_[view];
  if (!ball.seen) return;
  ++found_[view];
  if (label->view != BallView::whole) return;
  centerErrors_.push_back((ball.centerInImage - label->center).norm());
  radiusErrors_.push_back(std::abs(ball.radiusInImage - label->radius));
}

std::string Comparison::text() const {
  std::string text;
  for (std::size_t i = 0; i < total_.size(); ++i)
    text += fmt::format("{:8} {:3} images, ball found in {:3}\n", enumNames<BallView>[i], total_[i],
                        found_[i]);
  if (!centerErrors_.empty())
    text += fmt::format(
        "whole balls differ from the labels by {:.2f} pixels in the center and {:.2f} in the "
        "radius on average\n",
        mean(centerErrors_), mean(radiusErrors_));
  text += "distances by projection and by size, nearer than 1.5 m:";
  for (std::size_t i = 1; i < verdicts_.size(); ++i)
    text += fmt::format(" {} {}", enumNames<Verdict>[i], verdicts_[i]);
  if (!ratios_.empty())
    text += fmt::format("; projection / size {:.3f} on average, from {:.3f} to {:.3f}",
                        mean(ratios_), *std::min_element(ratios_.begin(), ratios_.end()),
                        *std::max_element(ratios_.begin(), ratios_.end()));
  return text + "\n";
}

Figures Comparison::figures() const {
  Figures figures;
  const auto percent = [&](BallView view, const char* name, Aim aim) {
    if (pictures(view) == 0) return;
    std::vector<double> each(static_cast<std::size_t>(pictures(view)), 0.0);
    std::fill_n(each.begin(), found(view), 100.0);
    figures.add(std::string{"vision.real.ball."} + name, "%", each, aim);
  };
  percent(BallView::whole, "whole.found", Aim::atLeast(90));
  percent(BallView::partial, "partial.found", {});
  percent(BallView::none, "false", Aim::atMost(0));
  figures.add("vision.real.ball.center.error", "pixel", centerErrors_);
  figures.add("vision.real.ball.radius.error", "pixel", radiusErrors_);
  figures.add("vision.real.ball.distance.ratio", "", ratios_);
  return figures;
}

}  // namespace gt
