#include <QActionGroup>
#include <algorithm>

#include "workbench/DrawingMenu.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

/// Report J.3.1: what a robot's camera sees, with drawings on it.
class ImageViewer : public ViewDialog {
 public:
  explicit ImageViewer(SessionThread& session) : ViewDialog{session, nullptr} {
    setKeys({"ImageProcessor/percepts", "ImageProcessor/horizon"});
    compose();
    sheet().placeText = [](const QPointF& place) {
      return QString{"pixel %1, %2"}
          .arg(place.x() / imageViewScale, 0, 'f', 1)
          .arg(place.y() / imageViewScale, 0, 'f', 1);
    };
  }

  QJsonObject settings() const override {
    QJsonObject settings = ViewDialog::settings();
    settings["image"] = QString::fromStdString(image_);
    settings["drawings"] = arrayOf(keys());
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    ViewDialog::restore(settings);
    if (const QString image = settings["image"].toString();
        image.isEmpty() ||
        std::ranges::find(imageViewElements, image.toStdString()) != imageViewElements.end())
      image_ = image.toStdString();
    if (settings["drawings"].isArray()) setKeys(namesOf(settings["drawings"]));
    compose();
  }

 protected:
  void addActions(QMenu& menu, const QPointF&) override {
    constexpr std::pair<const char*, const char*> images[] = {
        {"image", "Camera image"}, {"colorClassImage", "Color classes"}, {"", "No image"}};
    auto* group = new QActionGroup{&menu};
    for (const auto& [image, text] : images) {
      QAction* action = menu.addAction(text, this, [this, name = image] {
        image_ = name;
        compose();
      });
      action->setCheckable(true);
      action->setChecked(image_ == image);
      action->setActionGroup(group);
    }
    addDrawingMenu(menu, knownKeys(), keys(), [this](const std::string& key, bool on) {
      showKey(key, on);
      compose();
    });
  }

 private:
  void compose() {
    std::vector<std::string> elements;
    if (!image_.empty()) elements.push_back(image_);
    elements.insert(elements.end(), keys().begin(), keys().end());
    setView(makeImageView("image", "", elements));
  }

  std::string image_ = "image";
};

const RegisterDialog<ImageViewer> registeredImageViewer{
    {.id = "image",
     .title = "Image",
     .group = "Viewers",
     .help = "What the robot's camera sees, or its color classes, with drawings on it",
     .report = "J.3.1",
     .place = DialogPlace::right,
     .several = true,
     .atFirst = true}};

}  // namespace
}  // namespace gt
