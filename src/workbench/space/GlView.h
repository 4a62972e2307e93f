#pragma once
#include <QOpenGLWidget>
#include <functional>
#include <memory>
#include <optional>

#include "workbench/space/GlScene.h"
#include "workbench/space/OrbitCamera.h"

class QMenu;

namespace gt {

/// Draws a scene in space by OpenGL and MuJoCo. Dragging goes round, dragging with the right button
/// moves along the ground, the wheel goes nearer.
class GlView : public QOpenGLWidget {
 public:
  /// Whether this machine and display have OpenGL as it is needed here.
  static bool works();

  explicit GlView(QWidget* parent = nullptr);
  ~GlView() override;

  void show(std::shared_ptr<GlScene> scene);
  const std::shared_ptr<GlScene>& scene() const { return scene_; }
  /// A text at the upper left.
  void showText(const QString& text);

  /// How long the last frame took (ms).
  double drawTime() const { return drawTime_; }

  OrbitCamera& camera() { return camera_; }
  /// Smallest elevation that dragging leaves, in degrees.
  void setLowest(double degrees) { lowest_ = degrees; }
  /// The ray through a point of the widget.
  Ray ray(const QPointF& point) const;
  /// What of the scene's model lies under a point of the widget.
  std::optional<Picked> pick(const QPointF& point) const;

  /// Called when the left button goes down; true: it drags something, and not the camera.
  std::function<bool(const QPointF&)> grabbed;
  /// What was grabbed is dragged.
  std::function<void(const QPointF&)> dragged;
  /// It is let go.
  std::function<void(const QPointF&, Qt::KeyboardModifiers)> dropped;
  /// The left button went down and up at one place.
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
  std::shared_ptr<const mjModel> model_;  ///< That the context was made for.
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
