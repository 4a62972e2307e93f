#pragma once
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>
#include <QTimer>
#include <map>

#include "workbench/Dialog.h"
#include "workbench/LayoutStore.h"
#include "workbench/Theme.h"

namespace gt {

/// The window of the workbench (report 5.2, appendix J): dialogs in docks, toolbars, menus made of
/// the dialogs that there are, a status line, and layouts.
class MainWindow : public QMainWindow {
 public:
  /// Layouts lie in a folder; the layout that was chosen last is restored, or that of the scene.
  MainWindow(SessionThread& session, const QString& folder);

  /// Opens a dialog, or shows it if it is open and there may be one only; null if there is none of
  /// this type.
  Dialog* open(const QString& type);
  /// Shows an open dialog before those that share its place.
  void bringToFront(const QString& key);
  /// An open dialog or toolbar by type and number, such as image and image#2; null if there is
  /// none.
  Dialog* dialog(const QString& key) const;

  /// Which dialogs are open, where they are, and their settings.
  QJsonObject arrangement() const;
  /// Restores that. Returns an error, and arranges the dialogs as at the first start, if it is
  /// none.
  Result<void> arrange(const QJsonObject& arrangement);
  /// The arrangement of the first start.
  void arrangeAtFirst();

  LayoutStore& layouts() { return layouts_; }
  /// Restores a saved layout, and remembers it as the one to start with.
  Result<void> chooseLayout(const QString& name);
  Result<void> saveLayout(const QString& name);

  /// All that the menus offer.
  QList<QAction*> commands() const;

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void addMenus();
  void addViewMenu();
  void fillLayoutMenu(QMenu& menu);
  void fillRobotMenu(QMenu& menu);
  void openScene();
  void openLog();
  void showPalette();
  void showTheme(Theme theme);
  void report(const Result<void>& done);
  Dialog* create(const DialogType& type, const QString& key);
  void place(const DialogType& type, const QString& key);
  void closeAll();
  void refresh();
  void showStatus();

  SessionThread& session_;
  LayoutStore layouts_;
  std::map<QString, QPointer<Dialog>> dialogs_;  ///< All that are open, toolbars too.
  std::map<QString, QPointer<QWidget>> frames_;  ///< Docks and toolbars, by the same keys.
  QLabel* robotLabel_;
  QLabel* timeLabel_;
  QLabel* gameLabel_;
  QLabel* busyLabel_;
  QLabel* logLabel_;
  QTimer timer_;
  QString scene_;
};

}  // namespace gt
