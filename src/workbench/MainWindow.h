#pragma once
#include <QLabel>
#include <QMainWindow>
#include <QTimer>

#include "workbench/Docks.h"
#include "workbench/LayoutStore.h"
#include "workbench/MainMenus.h"
#include "workbench/Theme.h"

namespace gt {

/// The window of the workbench (report 5.2, appendix J): dialogs in docks, toolbars, menus made
/// from the registered types of dialogs, a status line, and layouts.
class MainWindow : public QMainWindow {
 public:
  /// Layouts lie in `folder`. Restores the layout that was chosen last, or that of the scene.
  MainWindow(SessionThread& session, const QString& folder);

  /// Opens a dialog, or shows it if it is open and there may be one only; null if there is none of
  /// this type.
  Dialog* open(const QString& type) { return docks_.open(type); }
  /// Shows an open dialog in front of those that share its place.
  void bringToFront(const QString& key) { docks_.bringToFront(key); }
  /// An open dialog or toolbar by type and number, such as image and image#2; null if there is
  /// none.
  Dialog* dialog(const QString& key) const { return docks_.dialog(key); }

  /// The open dialogs with their places and settings.
  QJsonObject arrangement() const { return docks_.arrangement(); }
  /// Restores an arrangement. If it is invalid, returns an error and arranges the dialogs as at the
  /// first start.
  Result<void> arrange(const QJsonObject& arrangement);
  /// The arrangement of the first start.
  void arrangeAtFirst();

  LayoutStore& layouts() { return layouts_; }
  /// Restores a saved layout, which is also restored at the next start.
  Result<void> chooseLayout(const QString& name);
  Result<void> saveLayout(const QString& name);

  /// The unsaved changes that are lost with another layout: those of dialogs, and of this layout.
  std::vector<Unsaved> unsavedOnLayoutChange();
  /// The unsaved changes that are lost when the window is closed: also recordings.
  std::vector<Unsaved> unsaved();

  /// All entries of the menus.
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
