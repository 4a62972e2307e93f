// The same images by MuJoCo's own renderer, which is OpenGL: in software, by Mesa's llvmpipe.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "benchmarks/CameraField.h"
#include "benchmarks/Parts.h"
#include "representations/infrastructure/Image.h"
#include "simulation/camera/CameraScene.h"

namespace gt {
namespace {

/// Renders what robots see with one thread, without shadows, reflections and smoothed edges, as the
/// simulator's own renderer does.
class OpenGlCamera {
 public:
  explicit OpenGlCamera(const CameraField& field)
      : field_{field}, model_{mj_copyModel(nullptr, &field.model())} {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("LP_NUM_THREADS", "0", 1);  // all work in the thread that draws
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API) ||
        !(context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr)) ||
        !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw std::runtime_error("OpenGL cannot draw without a window");
    model_->vis.global.offwidth = info_.width;
    model_->vis.global.offheight = info_.height;
    model_->vis.quality.offsamples = 0;
    mjr_defaultContext(&renderer_);
    mjr_makeContext(model_.get(), &renderer_, mjFONTSCALE_50);
    mjr_setBuffer(mjFB_OFFSCREEN, &renderer_);
    mjv_defaultScene(&scene_);
    mjv_makeScene(model_.get(), &scene_, model_->ngeom + 100);
    for (const int effect : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_FOG, mjRND_HAZE})
      scene_.flags[effect] = 0;
    mjv_defaultOption(&options_);
    for (int group = 0; group < mjNGROUP; ++group) options_.geomgroup[group] = group != 5;
  }
  ~OpenGlCamera() {
    mjv_freeScene(&scene_);
    mjr_freeContext(&renderer_);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }
  OpenGlCamera(const OpenGlCamera&) = delete;
  OpenGlCamera& operator=(const OpenGlCamera&) = delete;

  void take(const CameraView& view, Image& image) {
    mjv_updateScene(model_.get(), &field_.data(), &options_, nullptr, &camera_, mjCAT_ALL, &scene_);
    hide(view.hiddenBody);
    look(view.last);
    const mjrRect all{0, 0, info_.width, info_.height};
    mjr_render(all, &scene_, &renderer_);
    mjr_readPixels(rgb_.data(), nullptr, all, &renderer_);
    copyTo(image);
  }

 private:
  std::size_t pixels() const {
    return static_cast<std::size_t>(info_.width) * static_cast<std::size_t>(info_.height);
  }

  void hide(int body) {
    int shown = 0;
    for (int i = 0; i < scene_.ngeom; ++i) {
      const mjvGeom& geom = scene_.geoms[i];
      if (geom.objtype == mjOBJ_GEOM && model_->geom_bodyid[geom.objid] == body) continue;
      scene_.geoms[shown++] = geom;
    }
    scene_.ngeom = shown;
  }

  void look(const Pose3D& pose) {
    const float top = near * static_cast<float>(info_.centerY / info_.focalY);
    for (mjvGLCamera& eye : scene_.camera) {
      for (int i = 0; i < 3; ++i) {
        eye.pos[i] = static_cast<float>(pose.translation[i] / 1000);
        eye.forward[i] = static_cast<float>(pose.rotation(i, 0));
        eye.up[i] = static_cast<float>(pose.rotation(i, 2));
      }
      eye.frustum_center = 0;
      eye.frustum_top = top;
      eye.frustum_bottom = -top;
      eye.frustum_near = near;
      eye.frustum_far = 30;
    }
  }

  /// OpenGL's images are red, green and blue, the lowest row first.
  void copyTo(Image& image) const {
    image.info = info_;
    image.allocate();
    const auto width = static_cast<std::size_t>(info_.width);
    for (std::size_t y = 0; y < pixels() / width; ++y) {
      const unsigned char* from = rgb_.data() + 3 * (pixels() - (y + 1) * width);
      Pixel* to = image.pixels.data() + y * width;
      for (std::size_t x = 0; x < width; ++x, from += 3) {
        const int r = from[0], g = from[1], b = from[2];
        to[x].y = static_cast<std::uint8_t>((77 * r + 150 * g + 29 * b) >> 8);
        to[x].cb = static_cast<std::uint8_t>((32768 - 43 * r - 85 * g + 128 * b) >> 8);
        to[x].cr = static_cast<std::uint8_t>((32768 + 128 * r - 107 * g - 21 * b) >> 8);
      }
    }
  }

  static constexpr float near = 0.01f;

  const CameraField& field_;
  Model model_;  ///< Its settings of the image are the renderer's.
  CameraInfo info_;
  EGLDisplay display_;
  EGLContext context_;
  std::vector<unsigned char> rgb_ = std::vector<unsigned char>(3 * pixels());
  mjrContext renderer_;
  mjvScene scene_;
  mjvOption options_;
  mjvCamera camera_{};
};

void cameraOpenGl(benchmark::State& state) {
  const CameraField& field = CameraField::get();
  OpenGlCamera camera{field};
  Image image;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    camera.take(field.views()[i++ % field.views().size()], image);
    benchmark::DoNotOptimize(image.pixels.data());
  }
}

BENCHMARK(cameraOpenGl)->Name("speed.camera.openGl")->Apply(inMicroseconds);

}  // namespace
}  // namespace gt
