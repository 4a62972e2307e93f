#pragma once
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <utility>

#include "base/Result.h"

namespace gt {

/// The layouts of a window, which dialogs are open where, by their names, and which of them belongs
/// to which scene; a file each in the user's folder. Layouts that come with the program lie in a
/// folder of their own; the user's layout of the same name goes before them. What is chosen is
/// remembered at once. Of each file the last good state is kept beside it (FILE~), and used while
/// the file is broken.
class LayoutStore {
 public:
  LayoutStore(QString folder, QString shipped);

  QStringList names() const;
  /// Whether a layout is the user's own, which can be renamed and deleted.
  bool isOwn(const QString& name) const;
  /// Returns an error if there is none of this name, or its file is broken.
  Result<QJsonObject> load(const QString& name);
  /// What was wrong with files whose last good state is used instead, since this was asked for
  /// last.
  Result<void> fault() { return std::exchange(fault_, {}); }
  Result<void> save(const QString& name, const QJsonObject& layout);
  Result<void> rename(const QString& from, const QString& to);
  Result<void> remove(const QString& name);

  /// The layout that was chosen last; empty if none was.
  QString current() const { return settings_["current"].toString(); }
  void setCurrent(const QString& name);
  /// The layout of a scene; empty if it has none.
  QString ofScene(const QString& scene) const { return settings_["scenes"][scene].toString(); }
  /// Gives a scene a layout; empty: none of its own.
  void setOfScene(const QString& scene, const QString& name);
  /// Other things to remember, by their names.
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
