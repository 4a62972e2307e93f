#pragma once
#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>
#include <map>
#include <vector>

#include "workbench/Dialog.h"
#include "workbench/Unsaved.h"

namespace gt {

/// The dialogs of a window, in docks and toolbars: which are open, where they are, and their
/// settings. An open dialog's key is its type's name, with a number if there are several: image,
/// image#2.
class Docks {
 public:
  Docks(QMainWindow& window, SessionThread& session) : window_{window}, session_{session} {}

  /// Opens a dialog, or shows it if it is open and there may be one only; null if there is none of
  /// this type.
  Dialog* open(const QString& type);
  /// Shows an open dialog before those that share its place.
  void bringToFront(const QString& key);
  /// An open dialog or toolbar; null if there is none.
  Dialog* dialog(const QString& key) const;
  /// Has the dialogs that can be seen show what is new.
  void refresh();
  bool empty() const { return dialogs_.empty(); }

  /// Which dialogs are open, where they are, and their settings.
  QJsonObject arrangement() const;
  /// Restores that. Without places and sizes, dialogs go where their types belong, the first before
  /// the others. Returns an error, and arranges the dialogs as at the first start, if it is none.
  Result<void> arrange(const QJsonObject& arrangement);
  /// The arrangement of the first start.
  void arrangeAtFirst();

  /// What open dialogs hold that no file does.
  std::vector<Unsaved> unsaved() const;

 private:
  Dialog* create(const DialogType& type, const QString& key);
  void place(const DialogType& type, const QString& key);
  void addMissingToolbars();
  void arrangeByPlaces(const QStringList& keys);
  void closeAll();

  QMainWindow& window_;
  SessionThread& session_;
  std::map<QString, QPointer<Dialog>> dialogs_;  ///< All that are open, toolbars too.
  std::map<QString, QPointer<QWidget>> frames_;  ///< Docks and toolbars, by the same keys.
};

/// What a tooltip says about a type of dialog.
QString helpOf(const DialogType& type);

}  // namespace gt
