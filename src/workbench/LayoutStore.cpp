#include "workbench/LayoutStore.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QSaveFile>
#include <QUrl>
#include <utility>

namespace gt {
namespace {

const char* const extension = ".layout.json";

Result<QJsonObject> readObject(const QString& path) {
  QFile file{path};
  if (!file.open(QIODevice::ReadOnly))
    return Error{.file = path.toStdString(), .what = file.errorString().toStdString()};
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &error);
  if (!document.isObject())
    return Error{.file = path.toStdString(),
                 .what = error.error == QJsonParseError::NoError
                             ? "is no JSON object"
                             : error.errorString().toStdString()};
  return document.object();
}

Result<void> writeObject(const QString& path, const QJsonObject& object) {
  // Written beside and moved: a full disk leaves the old file.
  QSaveFile file{path};
  if (file.open(QIODevice::WriteOnly)) file.write(QJsonDocument{object}.toJson());
  if (file.isOpen() && file.commit()) return {};
  return Error{.file = path.toStdString(), .what = file.errorString().toStdString()};
}

}  // namespace

LayoutStore::LayoutStore(QString folder) : folder_{std::move(folder)} {
  QDir{}.mkpath(folder_);
  if (auto known = readObject(folder_ + "/settings.json")) settings_ = std::move(*known);
}

QString LayoutStore::path(const QString& name) const {
  return folder_ + "/" + QString::fromUtf8(QUrl::toPercentEncoding(name, " ")) + extension;
}

QStringList LayoutStore::names() const {
  QStringList names;
  for (const QString& file :
       QDir{folder_}.entryList({QString{"*"} + extension}, QDir::Files, QDir::Name))
    names << QUrl::fromPercentEncoding(file.chopped(QString{extension}.size()).toUtf8());
  return names;
}

Result<QJsonObject> LayoutStore::load(const QString& name) const {
  return readObject(path(name));
}

Result<void> LayoutStore::save(const QString& name, const QJsonObject& layout) {
  if (name.trimmed().isEmpty()) return Error{.field = "layout", .what = "has no name"};
  return writeObject(path(name), layout);
}

Result<void> LayoutStore::rename(const QString& from, const QString& to) {
  if (from == to) return {};
  if (to.trimmed().isEmpty()) return Error{.field = "layout", .what = "has no name"};
  if (names().contains(to))
    return Error{.field = to.toStdString(), .what = "there is already a layout of this name"};
  if (!QFile::rename(path(from), path(to)))
    return Error{.field = from.toStdString(), .what = "cannot be renamed"};
  QJsonObject scenes = settings_.value("scenes").toObject();
  for (auto scene = scenes.begin(); scene != scenes.end(); ++scene)
    if (scene.value().toString() == from) scene.value() = to;
  settings_["scenes"] = scenes;
  if (current() == from) settings_["current"] = to;
  write();
  return {};
}

Result<void> LayoutStore::remove(const QString& name) {
  if (!QFile::remove(path(name)))
    return Error{.field = name.toStdString(), .what = "cannot be deleted"};
  QJsonObject scenes = settings_.value("scenes").toObject();
  for (auto scene = scenes.begin(); scene != scenes.end();)
    scene = scene.value().toString() == name ? scenes.erase(scene) : scene + 1;
  settings_["scenes"] = scenes;
  if (current() == name) settings_.remove("current");
  write();
  return {};
}

void LayoutStore::setCurrent(const QString& name) {
  set("current", name);
}

void LayoutStore::setOfScene(const QString& scene, const QString& name) {
  QJsonObject scenes = settings_.value("scenes").toObject();
  if (name.isEmpty())
    scenes.remove(scene);
  else
    scenes[scene] = name;
  set("scenes", scenes);
}

void LayoutStore::set(const QString& name, const QJsonValue& value) {
  settings_[name] = value;
  write();
}

/// What cannot be remembered is not: the window works all the same.
void LayoutStore::write() {
  static_cast<void>(writeObject(folder_ + "/settings.json", settings_));
}

}  // namespace gt
