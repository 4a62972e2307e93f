#include "workbench/LayoutStore.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QUrl>
#include <utility>

#include "base/File.h"

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
  if (const QString before = path + "~"; readObject(path)) {
    QFile::remove(before);
    QFile::copy(path, before);
  }
  // Not by QSaveFile, which does not notice a full disk when it writes its buffer at the end.
  return writeFile(path.toStdString(), QJsonDocument{object}.toJson().toStdString());
}

}  // namespace

LayoutStore::LayoutStore(QString folder, QString shipped)
    : folder_{std::move(folder)}, shipped_{std::move(shipped)} {
  QDir{}.mkpath(folder_);
  const QString settings = folder_ + "/settings.json";
  if (QFile::exists(settings)) {
    if (auto known = readGood(settings))
      settings_ = std::move(*known);
    else
      fault_ = known.error();
  }
}

/// A broken file's last good state instead, if there is one; then the fault is remembered.
Result<QJsonObject> LayoutStore::readGood(const QString& path) {
  auto read = readObject(path);
  if (read) return read;
  auto before = readObject(path + "~");
  if (!before) return read;
  Error fault = read.error();
  fault.what += "; its last good state is used";
  fault_ = fault;
  return before;
}

QString LayoutStore::path(const QString& name) const {
  return folder_ + "/" + QString::fromUtf8(QUrl::toPercentEncoding(name, " ")) + extension;
}

QStringList LayoutStore::names() const {
  QStringList names;
  for (const QString& folder : {folder_, shipped_})
    for (const QString& file : QDir{folder}.entryList({QString{"*"} + extension}, QDir::Files))
      names << QUrl::fromPercentEncoding(file.chopped(QString{extension}.size()).toUtf8());
  names.removeDuplicates();
  names.sort();
  return names;
}

bool LayoutStore::isOwn(const QString& name) const {
  return QFile::exists(path(name));
}

Result<QJsonObject> LayoutStore::load(const QString& name) {
  if (!isOwn(name) && names().contains(name))
    return readObject(shipped_ + path(name).sliced(folder_.size()));
  return readGood(path(name));
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
  QFile::remove(path(from) + "~");
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
  QFile::remove(path(name) + "~");
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

/// Writes the settings. Errors are ignored, since the window works without saved settings.
void LayoutStore::write() {
  static_cast<void>(writeObject(folder_ + "/settings.json", settings_));
}

}  // namespace gt
