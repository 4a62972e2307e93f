#pragma once
#include <QJsonObject>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "workbench/SessionThread.h"
#include "workbench/Unsaved.h"

namespace gt {

/// The place at which a dialog first appears.
enum class DialogPlace { left, right, bottom, center, toolbar };

class Dialog;

/// The description of a type of dialog or toolbar. Its file registers it in one line; nothing else
/// names it:
///
///     const RegisterDialog<FieldDialog> registeredFieldDialog{{.id = "field", ...}};
struct DialogType {
  const char* id;           ///< In layouts.
  const char* title;        ///< In menus and as its heading.
  const char* group;        ///< The part of the menu View.
  const char* help;         ///< Its purpose, in one sentence.
  const char* report = "";  ///< The report's section about it.
  DialogPlace place = DialogPlace::right;
  bool several = false;  ///< Whether more than one may be open.
  bool atFirst = false;  ///< Whether it is open when the program starts for the first time.
  /// Makes a dialog. Set by the registration, unless there is a choice between several classes.
  Dialog* (*make)(SessionThread& session) = nullptr;
};

/// A dialog or toolbar of the workbench. It knows the session only, and no other dialog.
class Dialog : public QWidget {
 public:
  explicit Dialog(SessionThread& session) : session_{session} {}

  /// The settings that a layout stores beside the dialog's place. `restore` applies them; invalid
  /// settings change nothing.
  virtual QJsonObject settings() const { return {}; }
  virtual void restore(const QJsonObject&) {}
  /// The dialog's unsaved changes; empty if there are none.
  virtual std::optional<Unsaved> unsaved() { return std::nullopt; }
  /// Called 25 times a second while the dialog is visible.
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
