#pragma once
#include <QOpenGLWidget>
#include <functional>
#include <memory>
#include <optional>

#include "workbench/space/GlScene.h"
#include "workbench/space/OrbitCamera.h"

class QMenu;

namespace gt {

/// Draws a scene in space by OpenGL and MuJoCo. Dragging turns the camera around the scene,
/// dragging with the right button moves it along the ground, the wheel moves it nearer.
class GlView : public QOpenGLWidget {
 public:
  /// Whether this machine and display have the OpenGL that is needed here.
  static bool works();

  explicit GlView(QWidget* parent = nullptr);
  ~GlView() override;

  void show(std::shared_ptr<GlScene> scene);
  const std::shared_ptr<GlScene>& scene() const { return scene_; }
  /// Shows a text at the upper left.
  void showText(const QString& text);

  /// Time that drawing the last frame took (ms).
  double drawTime() const { return drawTime_; }

  OrbitCamera& camera() { return camera_; }
  /// Sets the smallest elevation of the camera (degrees) that dragging allows.
  void setLowest(double degrees) { lowest_ = degrees; }
  /// The ray through a point of the widget.
  Ray ray(const QPointF& point) const;
  /// The point of the scene's model under a point of the widget; empty if there is none.
  std::optional<Picked> pick(const QPointF& point) const;

  /// Called when the left button is pressed; returns true if it drags a thing, not the camera.
  std::function<bool(const QPointF&)> grabbed;
  /// Called when the grabbed thing is dragged.
  std::function<void(const QPointF&)> dragged;
  /// Called when the grabbed thing is released.
  std::function<void(const QPointF&, Qt::KeyboardModifiers)> dropped;
  /// Called when the left button was pressed and released at one place.
  std::function<void(const QPointF&)> clicked;
  std::function<void(const QPointF&)> doubleClicked;
  std::function<void(QMenu&, const QPointF&)> addActions;

 protected:
  void paintGL() override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void prepare();
  void release();
  void render();
  void showMenu(const QPointF& at);

  std::shared_ptr<GlScene> scene_;
  std::shared_ptr<const mjModel> model_;  ///< For which the context was made.
  struct Context;
  std::unique_ptr<Context> context_;
  OrbitCamera camera_;
  double lowest_ = 3;
  QString text_;
  double drawTime_ = 0;
  std::optional<QPointF> pressed_, last_;
  bool grabs_ = false, moved_ = false;
};

}  // namespace gt
