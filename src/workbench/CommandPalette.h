#pragma once
#include <QAction>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

#include "workbench/SessionThread.h"

namespace gt {

/// Finds entries of the menus and commands of the console by some letters of their names.
class CommandPalette : public QDialog {
 public:
  CommandPalette(QWidget* parent, const QList<QAction*>& actions, SessionThread& session);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void find(const QString& letters);
  void choose();

  SessionThread& session_;
  QList<QAction*> actions_;
  QLineEdit* edit_;
  QListWidget* list_;
};

/// Rates how well letters match a text that contains them in their order; less is better, -1: the
/// text does not contain them.
int mismatch(const QString& letters, const QString& text);

}  // namespace gt
