#include <QAction>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QMenu>
#include <QToolButton>

#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// Report J.1: buttons that open the dialogs which one needs most; the context menu chooses them.
class ViewsToolbar : public Dialog {
 public:
  explicit ViewsToolbar(SessionThread& session) : Dialog{session} {
    layout_ = new QHBoxLayout{this};
    layout_->setContentsMargins(2, 0, 2, 0);
    layout_->setSpacing(1);
    setToolTip("Opens dialogs; the context menu chooses which");
    showButtons();
  }

  QJsonObject settings() const override {
    return {{"dialogs", QJsonArray::fromStringList(dialogs_)}};
  }
  void restore(const QJsonObject& settings) override {
    if (!settings["dialogs"].isArray()) return;
    dialogs_.clear();
    for (const QJsonValue id : settings["dialogs"].toArray())
      if (Dialog::typeOf(id.toString())) dialogs_ << id.toString();
    showButtons();
  }
  void refresh() override {}

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override {
    QMenu menu;
    for (const DialogType& type : Dialog::types()) {
      QAction* action = menu.addAction(type.title, this, [this, id = QString{type.id}] {
        if (!dialogs_.removeOne(id)) dialogs_ << id;
        showButtons();
      });
      action->setCheckable(true);
      action->setChecked(dialogs_.contains(type.id));
    }
    menu.exec(event->globalPos());
  }

 private:
  void showButtons() {
    qDeleteAll(buttons_);
    buttons_.clear();
    for (const QString& id : dialogs_) {
      const DialogType* type = Dialog::typeOf(id);
      if (!type) continue;
      auto* made = makeControl<QToolButton>("open." + id, type->help);
      made->setText(type->title);
      made->setAutoRaise(true);
      // The entry of the menu View, which the window has.
      QObject::connect(made, &QToolButton::clicked, this, [this, id] {
        if (auto* action = window()->findChild<QAction*>("view." + id)) action->trigger();
      });
      layout_->addWidget(made);
      buttons_ << made;
    }
  }

  QHBoxLayout* layout_;
  QStringList dialogs_{"field", "image", "scene", "plot", "behaviorGraph", "values", "times"};
  QList<QToolButton*> buttons_;
};

const RegisterDialog<ViewsToolbar> registeredViewsToolbar{
    {.id = "views",
     .title = "Views",
     .group = "Toolbars",
     .help = "Buttons that open the dialogs which one needs most",
     .report = "J.1",
     .place = DialogPlace::toolbar}};

}  // namespace
}  // namespace gt
