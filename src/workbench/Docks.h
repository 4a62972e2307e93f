#pragma once
#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>
#include <map>
#include <vector>

#include "workbench/Dialog.h"
#include "workbench/Unsaved.h"

namespace gt {

/// The open dialogs of a window in docks and toolbars, with their places and settings. An open
/// dialog's key is its type's name, with a number if there are several: image, image#2.
class Docks {
 public:
  Docks(QMainWindow& window, SessionThread& session) : window_{window}, session_{session} {}

  /// Opens a dialog, or shows it if it is open and there may be one only; null if there is none of
  /// this type.
  Dialog* open(const QString& type);
  /// Shows an open dialog in front of those that share its place.
  void bringToFront(const QString& key);
  /// An open dialog or toolbar; null if there is none.
  Dialog* dialog(const QString& key) const;
  /// Refreshes the visible dialogs.
  void refresh();
  bool empty() const { return dialogs_.empty(); }

  /// The open dialogs with their places and settings.
  QJsonObject arrangement() const;
  /// Restores an arrangement. Without places and sizes, dialogs are placed where their types
  /// belong, the first in front of the others. If the arrangement is invalid, returns an error and
  /// arranges the dialogs as at the first start.
  Result<void> arrange(const QJsonObject& arrangement);
  /// The arrangement of the first start.
  void arrangeAtFirst();

  /// The unsaved changes of open dialogs.
  std::vector<Unsaved> unsaved() const;

 private:
  Dialog* create(const DialogType& type, const QString& key);
  void place(const DialogType& type, const QString& key);
  void addMissingToolbars();
  void arrangeByPlaces(const QStringList& keys);
  void closeAll();

  QMainWindow& window_;
  SessionThread& session_;
  std::map<QString, QPointer<Dialog>> dialogs_;  ///< All open dialogs, including toolbars.
  std::map<QString, QPointer<QWidget>> frames_;  ///< Docks and toolbars, by the same keys.
};

/// The tooltip of a type of dialog.
QString helpOf(const DialogType& type);

}  // namespace gt
