#include "workbench/space/GlView.h"

#include <QApplication>
#include <QClipboard>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "workbench/SaveImage.h"

namespace gt {
namespace {

constexpr double nearPlane = 0.02, farPlane = 40;  // meters

/// MuJoCo draws by functions of OpenGL 1 and 2.
QSurfaceFormat format() {
  QSurfaceFormat wanted;
  wanted.setRenderableType(QSurfaceFormat::OpenGL);
  wanted.setProfile(QSurfaceFormat::CompatibilityProfile);
  wanted.setDepthBufferSize(24);
  wanted.setStencilBufferSize(8);
  wanted.setAlphaBufferSize(0);
  return wanted;
}

bool contextWorks() {
  // Where an X server is this platform has contexts, but Qt cannot show on it what they draw, and
  // ends.
  if (QGuiApplication::platformName() == "offscreen") return false;
  QOpenGLContext context;
  context.setFormat(format());
  if (!context.create()) return false;
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return false;
  const bool works = !context.isOpenGLES() && context.hasExtension("GL_ARB_framebuffer_object") &&
                     context.hasExtension("GL_ARB_vertex_buffer_object");
  context.doneCurrent();
  return works;
}

}  // namespace

/// MuJoCo's objects in OpenGL. What MuJoCo takes for its offscreen buffer is the widget's.
struct GlView::Context {
  explicit Context(const mjModel& model) {
    mjr_defaultContext(&context);
    mjr_makeContext(&model, &context, mjFONTSCALE_100);
    own = context.offFBO;
  }
  ~Context() {
    context.offFBO = own;
    mjr_freeContext(&context);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void drawTo(unsigned framebuffer) {
    context.offFBO = framebuffer;
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
  }

  mjrContext context;
  unsigned own = 0;
};

bool GlView::works() {
  static const bool works = contextWorks();
  return works;
}

GlView::GlView(QWidget* parent) : QOpenGLWidget{parent} {
  setFormat(gt::format());
  setMinimumSize(80, 60);
  setFocusPolicy(Qt::ClickFocus);
}

GlView::~GlView() {
  release();
}

void GlView::release() {
  if (!context_) return;
  makeCurrent();
  context_.reset();
  model_.reset();
  doneCurrent();
}

void GlView::show(std::shared_ptr<GlScene> scene) {
  scene_ = std::move(scene);
  update();
}

void GlView::showText(const QString& text) {
  text_ = text;
  update();
}

/// Makes MuJoCo's objects for the scene's model, if they are not there. A widget that moves to
/// another window gets another context of OpenGL.
void GlView::prepare() {
  if (context_ && model_ == scene_->model()) return;
  context_.reset();
  context_ = std::make_unique<Context>(*scene_->model());
  model_ = scene_->model();
  QObject::connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
}

void GlView::render() {
  mjvScene& scene = scene_->geoms();
  mjvGLCamera& view = scene.camera[0];
  const Vector3d from = 1e-3 * camera_.from(), ahead = camera_.ahead(), up = camera_.up();
  const double half = nearPlane * std::tan(fromDegrees(camera_.openingAngle) / 2);
  for (int i = 0; i < 3; ++i) {
    view.pos[i] = static_cast<float>(from[i]);
    view.forward[i] = static_cast<float>(ahead[i]);
    view.up[i] = static_cast<float>(up[i]);
  }
  view.frustum_center = 0;
  view.frustum_bottom = static_cast<float>(-half);
  view.frustum_top = static_cast<float>(half);
  view.frustum_near = static_cast<float>(nearPlane);
  view.frustum_far = static_cast<float>(farPlane);
  scene.camera[1] = view;
  for (mjvLight& light : std::span{scene.lights, static_cast<std::size_t>(scene.nlight)}) {
    if (!light.headlight) continue;
    std::ranges::copy(view.pos, light.pos);
    std::ranges::copy(view.forward, light.dir);
  }
  context_->drawTo(defaultFramebufferObject());
  const double ratio = devicePixelRatioF();
  mjr_render({0, 0, static_cast<int>(width() * ratio), static_cast<int>(height() * ratio)}, &scene,
             &context_->context);
}

void GlView::paintGL() {
  QElapsedTimer clock;
  clock.start();
  if (scene_) {
    prepare();
    render();
  }
  if (!scene_ || !text_.isEmpty()) {
    QPainter painter{this};
    if (!scene_) painter.fillRect(rect(), palette().window());
    const QRect place = painter.boundingRect(rect().adjusted(10, 6, -10, -6),
                                             Qt::AlignTop | Qt::TextWordWrap, text_);
    painter.fillRect(place.adjusted(-4, -2, 4, 2), QColor{0, 0, 0, 120});
    painter.setPen(Qt::white);
    painter.drawText(place, Qt::AlignTop | Qt::TextWordWrap, text_);
  }
  drawTime_ = static_cast<double>(clock.nsecsElapsed()) / 1e6;
}

Ray GlView::ray(const QPointF& point) const {
  return camera_.ray(2 * point.x() / width() - 1, 1 - 2 * point.y() / height(),
                     static_cast<double>(width()) / height());
}

std::optional<Picked> GlView::pick(const QPointF& point) const {
  return scene_ ? scene_->pick(ray(point)) : std::nullopt;
}

void GlView::wheelEvent(QWheelEvent* event) {
  camera_.approach(event->angleDelta().y() / 120.0);
  update();
}

void GlView::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  moved_ = false;
  grabs_ = event->button() == Qt::LeftButton && grabbed && grabbed(event->position());
}

void GlView::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  const QPointF by = event->position() - std::exchange(*last_, event->position());
  const QPointF whole = event->position() - *pressed_;
  if (whole.manhattanLength() >= QApplication::startDragDistance()) moved_ = true;
  if (grabs_) {
    if (moved_ && dragged) dragged(event->position());
    return;
  }
  if (event->buttons() & Qt::RightButton)
    camera_.move(by.x(), by.y(), height());
  else
    camera_.turn(by.x(), by.y());
  camera_.elevation = std::max(camera_.elevation, lowest_);
  update();
}

void GlView::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_) return;
  pressed_.reset();
  if (grabs_ && moved_ && dropped) dropped(event->position(), event->modifiers());
  grabs_ = false;
  if (event->button() == Qt::LeftButton && !moved_ && clicked) clicked(event->position());
  if (event->button() == Qt::RightButton && !moved_) showMenu(event->position());
}

void GlView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (doubleClicked) doubleClicked(event->position());
}

void GlView::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy))
    return QApplication::clipboard()->setImage(grabFramebuffer());
  QOpenGLWidget::keyPressEvent(event);
}

void GlView::showMenu(const QPointF& at) {
  QMenu menu;
  if (addActions) addActions(menu, at);
  menu.addSeparator();
  menu.addAction("Copy image", this,
                 [this] { QApplication::clipboard()->setImage(grabFramebuffer()); });
  menu.addAction("Save as…", this, [this] {
    const QString file =
        QFileDialog::getSaveFileName(this, "Save the view", "view.png", "Images (*.png)");
    if (file.isEmpty()) return;
    if (const auto done = saveImage(grabFramebuffer(), file); !done)
      QMessageBox::warning(this, "Save", QString::fromStdString(done.error().text()));
  });
  menu.exec(mapToGlobal(at.toPoint()));
}

}  // namespace gt
