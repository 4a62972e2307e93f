#pragma once
#include <QJsonObject>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "workbench/SessionThread.h"
#include "workbench/Unsaved.h"

namespace gt {

/// Where a dialog appears at first.
enum class DialogPlace { left, right, bottom, center, toolbar };

class Dialog;

/// What there is to know of a dialog or toolbar before it is opened. Its file registers it in one
/// line; nothing else names it:
///
///     const RegisterDialog<FieldDialog> registeredFieldDialog{{.id = "field", ...}};
struct DialogType {
  const char* id;           ///< In layouts.
  const char* title;        ///< In menus and as its heading.
  const char* group;        ///< The part of the menu View.
  const char* help;         ///< What it is for, in one sentence.
  const char* report = "";  ///< The report's section about it.
  DialogPlace place = DialogPlace::right;
  bool several = false;  ///< Whether more than one may be open.
  bool atFirst = false;  ///< Whether it is open when the program starts for the first time.
  /// Makes it. Registering sets it, unless there is a choice between several classes.
  Dialog* (*make)(SessionThread& session) = nullptr;
};

/// A dialog or toolbar of the workbench. It knows the session only, and no other dialog.
class Dialog : public QWidget {
 public:
  explicit Dialog(SessionThread& session) : session_{session} {}

  /// What a layout keeps of it beside its place, and the reverse. What is not understood is left
  /// as it is.
  virtual QJsonObject settings() const { return {}; }
  virtual void restore(const QJsonObject&) {}
  /// What the dialog holds that no file does; empty if there is nothing to lose.
  virtual std::optional<Unsaved> unsaved() { return std::nullopt; }
  /// Called 25 times a second while the dialog can be seen.
  virtual void refresh() = 0;

  /// All types, sorted by group and title.
  static std::vector<DialogType> types();
  /// The type of a dialog by its key, such as image#2; null if there is none.
  static const DialogType* typeOf(const QString& key);
  static void add(const DialogType& type);

 protected:
  SessionThread& session() const { return session_; }

 private:
  SessionThread& session_;
};

template <typename T>
struct RegisterDialog {
  explicit RegisterDialog(DialogType type) {
    if (!type.make) type.make = [](SessionThread& session) -> Dialog* { return new T{session}; };
    Dialog::add(type);
  }
};

}  // namespace gt
