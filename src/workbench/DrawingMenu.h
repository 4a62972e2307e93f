#pragma once
#include <QJsonArray>
#include <QMenu>
#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gt {

/// Adds a part to a context menu where drawings are switched on and off by their debug keys,
/// grouped by the modules that draw them.
inline void addDrawingMenu(QMenu& menu, const std::vector<std::string>& known,
                           const std::vector<std::string>& shown,
                           const std::function<void(const std::string& key, bool on)>& change) {
  QMenu* drawings = menu.addMenu("Drawings");
  std::map<QString, QMenu*> parts;
  for (const std::string& name : known) {
    const QString key = QString::fromStdString(name);
    QMenu*& part = parts[key.section('/', 0, 0)];
    if (!part) part = drawings->addMenu(key.section('/', 0, 0));
    QAction* action = part->addAction(key.section('/', 1));
    action->setCheckable(true);
    action->setChecked(std::find(shown.begin(), shown.end(), name) != shown.end());
    QObject::connect(action, &QAction::toggled, drawings,
                     [change, name](bool on) { change(name, on); });
  }
  drawings->setEnabled(!known.empty());
}

inline QJsonArray arrayOf(const std::vector<std::string>& names) {
  QJsonArray array;
  for (const std::string& name : names) array.append(QString::fromStdString(name));
  return array;
}

inline std::vector<std::string> namesOf(const QJsonValue& array) {
  std::vector<std::string> names;
  for (const QJsonValue name : array.toArray()) names.push_back(name.toString().toStdString());
  return names;
}

}  // namespace gt
