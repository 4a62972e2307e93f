#pragma once
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "base/Result.h"

namespace gt {

/// The layouts of a window, which dialogs are open where, by their names, and which of them belongs
/// to which scene; a file each in a folder. What is chosen is remembered at once.
class LayoutStore {
 public:
  explicit LayoutStore(QString folder);

  QStringList names() const;
  /// Returns an error if there is none of this name, or its file is broken.
  Result<QJsonObject> load(const QString& name) const;
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
  void write();

  QString folder_;
  QJsonObject settings_;
};

}  // namespace gt
