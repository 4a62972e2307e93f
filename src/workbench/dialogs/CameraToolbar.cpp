#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMessageBox>
#include <optional>

#include "base/File.h"
#include "representations/infrastructure/CameraSettings.h"
#include "streams/Config.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/SendToRobots.h"

namespace gt {
namespace {

/// Report J.6.4: how the camera is set. The boxes begin with what the connected robot uses.
class CameraToolbar : public Dialog {
 public:
  explicit CameraToolbar(SessionThread& session) : Dialog{session} {
    auto* layout = new QHBoxLayout{this};
    layout->setContentsMargins(2, 0, 2, 0);
    whiteBalance_ = box("whiteBalance", {"indoor", "outdoor", "FL"}, "White balance");
    shutter_ = box("shutter", {"slow", "medium", "fast"}, "How long the shutter is open");
    gain_ = box("gain", {"low", "medium", "high"}, "How much the image is amplified");
    for (QComboBox* known : {whiteBalance_, shutter_, gain_}) layout->addWidget(known);
    addButton(*layout, *this, "send", "Send to robot",
              "Sets the cameras of the connected robots at once",
              [this] { sendToRobots(this->session(), chosen(), "The camera's setting"); });
    addButton(*layout, *this, "save", "Save…", "Writes camera.cfg, with which robots begin",
              [this] { save(); });
  }

  void refresh() override {
    const std::uint64_t beginnings = session().status().beginnings;
    if (beginnings == beginnings_) return;
    beginnings_ = beginnings;
    session().ask(
        this,
        [](Console& console) -> std::optional<CameraSettings> {
          const auto robot = console.firstRobot();
          if (!robot) return std::nullopt;
          const auto known = (*robot)->observed().value<CameraSettings>();
          return known ? std::optional{**known} : std::nullopt;
        },
        [this](const std::optional<CameraSettings>& known) {
          if (!known) return;
          whiteBalance_->setCurrentIndex(static_cast<int>(known->whiteBalance));
          shutter_->setCurrentIndex(static_cast<int>(known->shutterSpeed));
          gain_->setCurrentIndex(static_cast<int>(known->gain));
        });
  }

 private:
  static QComboBox* box(const char* name, const QStringList& words, const char* help) {
    auto* made = makeControl<QComboBox>(name, help);
    made->addItems(words);
    made->setCurrentIndex(1);
    return made;
  }
  /// The words stand in the order of the enumerations.
  CameraSettings chosen() const {
    return {static_cast<WhiteBalance>(whiteBalance_->currentIndex()),
            static_cast<Gain>(gain_->currentIndex()),
            static_cast<ShutterSpeed>(shutter_->currentIndex())};
  }
  void save() {
    const QString file = QFileDialog::getSaveFileName(
        this, "Save", QString::fromStdString(session().root().path("config/camera.cfg")),
        "Configuration (*.cfg)");
    if (file.isEmpty()) return;
    if (const auto done = writeFile(file.toStdString(), writeConfig(chosen())); !done)
      QMessageBox::warning(this, "Camera", QString::fromStdString(done.error().text()));
  }

  QComboBox* whiteBalance_;
  QComboBox* shutter_;
  QComboBox* gain_;
  std::uint64_t beginnings_ = 0;
};

const RegisterDialog<CameraToolbar> registeredCameraToolbar{
    {.id = "camera",
     .title = "Camera",
     .group = "Toolbars",
     .help = "White balance, shutter and gain of the robot's camera",
     .report = "J.6.4",
     .place = DialogPlace::toolbar}};

}  // namespace
}  // namespace gt
