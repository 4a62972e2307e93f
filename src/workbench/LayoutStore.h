#pragma once
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <utility>

#include "base/Result.h"

namespace gt {

/// The layouts of a window (the open dialogs and their places) by their names, and the layout of
/// each scene. Each layout is a file in the user's folder. Layouts that come with the program lie
/// in a folder of their own; the user's layout of the same name takes precedence. Choices are saved
/// at once. The last valid state of each file is kept beside it (FILE~), and used while the file is
/// broken.
class LayoutStore {
 public:
  LayoutStore(QString folder, QString shipped);

  QStringList names() const;
  /// Whether a layout is the user's own, which can be renamed and deleted.
  bool isOwn(const QString& name) const;
  /// Loads a layout. Returns an error if there is none of this name, or if its file is broken.
  Result<QJsonObject> load(const QString& name);
  /// The error in files whose last valid state was used instead, since the last call.
  Result<void> fault() { return std::exchange(fault_, {}); }
  Result<void> save(const QString& name, const QJsonObject& layout);
  Result<void> rename(const QString& from, const QString& to);
  Result<void> remove(const QString& name);

  /// The layout that was chosen last; empty if none was.
  QString current() const { return settings_["current"].toString(); }
  void setCurrent(const QString& name);
  /// The layout of a scene; empty if it has none.
  QString ofScene(const QString& scene) const { return settings_["scenes"][scene].toString(); }
  /// Sets the layout of a scene; empty: none of its own.
  void setOfScene(const QString& scene, const QString& name);
  /// Other saved settings, by their names.
  QJsonValue setting(const QString& name) const { return settings_[name]; }
  void set(const QString& name, const QJsonValue& value);

 private:
  QString path(const QString& name) const;
  Result<QJsonObject> readGood(const QString& path);
  void write();

  QString folder_, shipped_;
  Result<void> fault_;
  QJsonObject settings_;
};

}  // namespace gt
