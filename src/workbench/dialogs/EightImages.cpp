#include <QGridLayout>
#include <QJsonArray>
#include <array>
#include <cstddef>

#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr int imageColumns = 4;
constexpr std::size_t fieldCount = 8;

/// Report J.3.1: eight small images beside each other. Each is an image viewer of its own: its
/// context menu chooses robot, image and drawings. At first they show camera images and color
/// classes by turns.
class EightImages : public Dialog {
 public:
  explicit EightImages(SessionThread& session) : Dialog{session} {
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    const DialogType& image = *Dialog::typeOf("image");
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      fields_[i] = image.make(session);
      fields_[i]->setObjectName(QString{"field%1"}.arg(i + 1));
      if (i % 2) fields_[i]->restore({{"image", "colorClassImage"}});
      grid->addWidget(fields_[i], static_cast<int>(i) / imageColumns,
                      static_cast<int>(i) % imageColumns);
    }
  }

  QJsonObject settings() const override {
    QJsonArray fields;
    for (const Dialog* field : fields_) fields.append(field->settings());
    return {{"fields", fields}};
  }
  void restore(const QJsonObject& settings) override {
    const QJsonArray fields = settings["fields"].toArray();
    for (std::size_t i = 0; i < fields_.size() && static_cast<qsizetype>(i) < fields.size(); ++i)
      fields_[i]->restore(fields[static_cast<qsizetype>(i)].toObject());
  }
  void refresh() override {
    for (Dialog* field : fields_) field->refresh();
  }

 private:
  std::array<Dialog*, fieldCount> fields_{};
};

const RegisterDialog<EightImages> registeredEightImages{
    {.id = "images",
     .title = "Eight images",
     .group = "Viewers",
     .help = "Eight small images with a robot, an image and drawings each",
     .report = "J.3.1",
     .place = DialogPlace::bottom,
     .several = true}};

}  // namespace
}  // namespace gt
