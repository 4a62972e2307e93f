#pragma once
#include <QLabel>
#include <QMainWindow>
#include <QTimer>

#include "workbench/Docks.h"
#include "workbench/LayoutStore.h"
#include "workbench/MainMenus.h"
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
  Dialog* open(const QString& type) { return docks_.open(type); }
  /// Shows an open dialog before those that share its place.
  void bringToFront(const QString& key) { docks_.bringToFront(key); }
  /// An open dialog or toolbar by type and number, such as image and image#2; null if there is
  /// none.
  Dialog* dialog(const QString& key) const { return docks_.dialog(key); }

  /// Which dialogs are open, where they are, and their settings.
  QJsonObject arrangement() const { return docks_.arrangement(); }
  /// Restores that. Returns an error, and arranges the dialogs as at the first start, if it is
  /// none.
  Result<void> arrange(const QJsonObject& arrangement);
  /// The arrangement of the first start.
  void arrangeAtFirst();

  LayoutStore& layouts() { return layouts_; }
  /// Restores a saved layout, and remembers it as the one to start with.
  Result<void> chooseLayout(const QString& name);
  Result<void> saveLayout(const QString& name);

  /// What another layout would lose: what dialogs hold, and changes of this layout.
  std::vector<Unsaved> unsavedOnLayoutChange();
  /// What is lost when the window is closed: that, and recordings.
  std::vector<Unsaved> unsaved();

  /// All that the menus offer.
  QList<QAction*> commands() const { return menus_.commands(); }
  /// File name of the scene that is shown.
  const QString& scene() const { return scene_; }
  void showTheme(Theme theme);
  /// Shows an error in the status line.
  void report(const Result<void>& done);

 protected:
  void childEvent(QChildEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  bool saveRecording(const std::string& robot);
  void refresh();
  void showStatus();

  SessionThread& session_;
  LayoutStore layouts_;
  Docks docks_;
  QJsonValue chosen_;  ///< The dialogs and settings of the layout that was chosen or saved.
  QLabel* robotLabel_;
  QLabel* timeLabel_;
  QLabel* gameLabel_;
  QLabel* busyLabel_;
  QLabel* logLabel_;
  QTimer timer_;
  QString scene_;
  MainMenus menus_;  // uses all of the above
};

}  // namespace gt
