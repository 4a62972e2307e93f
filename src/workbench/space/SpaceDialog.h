#pragma once
#include <QElapsedTimer>
#include <functional>
#include <memory>
#include <string>

#include "workbench/Dialog.h"
#include "workbench/space/GlView.h"

namespace gt {

/// A dialog that draws a scene in space by OpenGL, and redraws it when the session changes. The
/// scene is made on the session's thread, and drawn on the window's.
class SpaceDialog : public Dialog {
 public:
  explicit SpaceDialog(SessionThread& session);

  QJsonObject settings() const override;
  void restore(const QJsonObject& settings) override;
  void refresh() override;

  GlView& view() const { return *view_; }
  /// The robot that is always shown; empty: the connected one.
  const std::string& robot() const { return robot_; }
  void setRobot(const std::string& robot);

 protected:
  /// The input of drawing on the session's thread, and the scene that it draws.
  struct Canvas {
    Console& console;
    ConsoleRobot* robot;  ///< The robot that is shown; null if there is none.
    GlScene& scene;
  };
  /// Draws on the session's thread. Returns a text to show above the scene; if the scene stays
  /// empty, only the text is shown.
  using Draw = std::function<std::string(const Canvas&)>;
  /// Returns the function that draws the scene now. It must not use the dialog.
  virtual Draw drawing() const = 0;
  /// Adds to the context menu of a point.
  virtual void addActions(QMenu&, const QPointF&) {}
  void drawAgain() { shown_ = 0; }

 private:
  /// Used by the session's thread only.
  struct Prepared {
    std::uint64_t beginnings = 0;
    std::shared_ptr<const mjModel> model;
    std::shared_ptr<GlScene> spare;
  };

  GlView* view_;
  std::shared_ptr<Prepared> prepared_ = std::make_shared<Prepared>();
  std::string robot_;
  bool asked_ = false;
  std::uint64_t shown_ = 0;  ///< Version of the session that is shown.
  QElapsedTimer answered_;
};

/// Replaces a dialog in space where there is no OpenGL.
class NoOpenGl : public Dialog {
 public:
  explicit NoOpenGl(SessionThread& session);
  void refresh() override {}
};

/// Makes a dialog in space, or its replacement where there is no OpenGL.
template <typename InSpace, typename Otherwise = NoOpenGl>
Dialog* makeInSpace(SessionThread& session) {
  if (GlView::works()) return new InSpace{session};
  return new Otherwise{session};
}

}  // namespace gt
