#include "labels/LabelScript.h"

#include <algorithm>
#include <cmath>

#include "base/Number.h"

namespace gt {

std::string scriptOfLabels(const ImageLabels& labels, int picture, const std::string& log,
                           Time played, double tolerance) {
  // To a tenth of a pixel.
  const auto number = [](double value) { return numberText(std::round(value * 10) / 10); };
  std::string script = "# Image " + std::to_string(picture) + " of a log, and what a person saw.\n";
  script += "sl labeled \"" + log + "\"\nrobot labeled\nlp pause\nlp time " +
            std::to_string(played.ms / 1000.0) + "\n";
  const auto expect = [&](const std::string& condition) { script += "expect " + condition + "\n"; };
  const std::string ball = "labeled.BallPercept.", margin = " <= " + number(tolerance);
  if (const auto label = labels.balls.find(picture); label != labels.balls.end()) {
    expect(ball + "seen == " + (label->second.view == BallView::none ? "false" : "true"));
    if (label->second.view == BallView::whole) {
      expect("abs(" + ball + "centerInImage.x - " + number(label->second.center.x()) + ")" +
             margin);
      expect("abs(" + ball + "centerInImage.y - " + number(label->second.center.y()) + ")" +
             margin);
      expect("abs(" + ball + "radiusInImage - " + number(label->second.radius) + ")" + margin);
    }
  }
  if (const auto label = labels.fields.find(picture); label != labels.fields.end()) {
    int flags = 0, goals = 0;
    for (const auto& [name, box] : label->second.boxes) {
      flags += name.kind == BoxName::Kind::flag;
      goals += name.kind == BoxName::Kind::goal;
    }
    if (flags > 0) expect("labeled.LandmarksPercept.numberOfFlags >= " + std::to_string(flags));
    if (goals > 0 || label->second.leftPost || label->second.rightPost)
      expect("labeled.LandmarksPercept.numberOfGoals >= " + std::to_string(std::max(goals, 1)));
  }
  return script;
}

}  // namespace gt
