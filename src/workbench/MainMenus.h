#pragma once
#include <QAction>
#include <QMenu>

#include "workbench/SessionThread.h"

namespace gt {

class MainWindow;

/// The menus of the main window. The menu View has an entry for each type of dialog.
class MainMenus {
 public:
  MainMenus(MainWindow& window, SessionThread& session);

  /// All present entries of the menus.
  QList<QAction*> commands() const;

 private:
  QMenu* add(const QString& title);
  void addFileMenu();
  void addSimulationMenu();
  void addViewMenu();
  void addHelpMenu();
  void fillRobotMenu(QMenu& menu);
  void fillLayoutMenu(QMenu& menu);
  void openScene();
  void openLog();
  void showPalette();

  MainWindow& window_;
  SessionThread& session_;
};

}  // namespace gt
