#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "workbench/Dialog.h"
#include "workbench/DrawingHints.h"
#include "workbench/SheetWidget.h"

class QLabel;
class QMenu;

namespace gt {

/// A dialog that shows a view (views/View.h) of the connected robot, or of one that is chosen by
/// the context menu, and repaints it when the session changes. The view's sheet is made on the
/// session's thread, and painted on the window's.
class ViewDialog : public Dialog {
 public:
  ViewDialog(SessionThread& session, std::shared_ptr<const View> view);

  QJsonObject settings() const override;
  void restore(const QJsonObject& settings) override;
  void refresh() override;

  SheetWidget& sheet() const { return *sheet_; }
  /// The robot that is always shown; empty: the connected one.
  const std::string& robot() const { return robot_; }
  void setRobot(const std::string& robot);

 protected:
  void setView(std::shared_ptr<const View> view);
  /// The view's own parameters.
  void setNumbers(std::vector<double> numbers);
  /// Sets the debug keys that are switched on for the robot that is shown.
  void setKeys(std::vector<std::string> keys);
  void showKey(const std::string& key, bool on);
  const std::vector<std::string>& keys() const { return keys_; }
  /// Adds to the context menu of a place on the sheet.
  virtual void addActions(QMenu&, const QPointF&) {}
  /// The debug keys of the drawings that can be requested from the robot that is shown.
  const std::vector<std::string>& knownKeys() const { return knownKeys_; }

 private:
  /// The robot and keys that were switched on, and the reasons for missing drawings. Used by the
  /// session's thread only.
  struct Prepared {
    const void* robot = nullptr;
    std::uint64_t beginnings = 0;
    std::vector<std::string> keys, known;
    std::vector<std::shared_ptr<const void>> shown;  ///< Keeps the keys on.
    std::vector<DrawingHint> hints;
    QElapsedTimer looked;  ///< Since `hints` were updated.
  };
  struct Answer {
    std::shared_ptr<const Sheet> sheet{};
    std::string error{};
    std::vector<std::string> knownKeys{};
    std::vector<DrawingHint> hints{};
    std::string robot{};
  };

  void askAgain();
  void take(Answer answer);
  void showNext();
  void showHints(const Answer& answer);

  SheetWidget* sheet_;
  QLabel* hint_;                    ///< Shows why drawings are missing.
  std::vector<DrawingHint> hints_;  ///< That `hint_` shows.
  std::string hinted_;              ///< The robot of `hints_`.
  std::shared_ptr<const View> view_;
  std::vector<double> numbers_;
  std::vector<std::string> keys_, knownKeys_;
  std::string robot_;
  std::shared_ptr<Prepared> prepared_ = std::make_shared<Prepared>();
  std::shared_ptr<SessionThread::Supply> supply_;  ///< Null if it has to be requested anew.
  std::deque<Answer> waiting_;                     ///< Wait until the previous one is painted.
  QTimer next_;                                    ///< Shows the next one of `waiting_`.
};

/// A built-in view by its name.
std::shared_ptr<const View> builtInView(std::string_view name);

}  // namespace gt
