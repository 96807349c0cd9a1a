#include "widgets/scene3d/quad_buffer.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions_1_1>
#include <QPointer>
#include <QWindow>

namespace glissade {
namespace {

QSurfaceFormat stereoFormat() {
  QSurfaceFormat format;
  format.setProfile(QSurfaceFormat::CompatibilityProfile);
  format.setStereo(true);
  return format;
}

class QuadBufferWindow final : public QuadBuffer {
 public:
  QuadBufferWindow() : window_(new QWindow) {
    window_->setSurfaceType(QSurface::OpenGLSurface);
    window_->setFormat(stereoFormat());
    window_->setFlag(Qt::WindowTransparentForInput);
    context_.setFormat(stereoFormat());
  }
  ~QuadBufferWindow() override {
    delete container_;
    delete window_;
  }
  QuadBufferWindow(const QuadBufferWindow&) = delete;
  QuadBufferWindow& operator=(const QuadBufferWindow&) = delete;

  bool create(QWidget* parent) {
    if (!context_.create() || !context_.format().stereo()) return false;
    container_ = QWidget::createWindowContainer(window_, parent);
    container_->setFocusPolicy(Qt::NoFocus);
    return true;
  }

  QWidget* widget() override { return container_; }

  void show(const QImage& left, const QImage& right) override {
    if (!window_->isExposed() || !context_.makeCurrent(window_)) return;
    if (auto* gl = context_.versionFunctions<QOpenGLFunctions_1_1>()) {
      draw(*gl, GL_BACK_LEFT, left);
      draw(*gl, GL_BACK_RIGHT, right);
    }
    context_.swapBuffers(window_);
    context_.doneCurrent();
  }

 private:
  void draw(QOpenGLFunctions_1_1& gl, GLenum buffer, const QImage& picture) const {
    const QImage pixels = picture.convertToFormat(QImage::Format_RGB32);
    gl.glDrawBuffer(buffer);
    gl.glViewport(0, 0, pixels.width(), pixels.height());
    gl.glRasterPos2f(-1.0F, 1.0F);
    gl.glPixelZoom(1.0F, -1.0F);
    gl.glDrawPixels(pixels.width(), pixels.height(), GL_BGRA, GL_UNSIGNED_BYTE, pixels.constBits());
  }

  QPointer<QWindow> window_;  ///< the container's, once it exists
  QPointer<QWidget> container_;
  QOpenGLContext context_;
};

}  // namespace

std::unique_ptr<QuadBuffer> makeQuadBufferWindow(QWidget* parent) {
  auto window = std::make_unique<QuadBufferWindow>();
  return window->create(parent) ? std::move(window) : nullptr;
}

}  // namespace glissade
