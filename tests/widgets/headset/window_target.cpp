#include "tests/widgets/headset/window_target.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include "widgets/openxr/private_context.h"
#include "widgets/scene3d/scene_renderer.h"

namespace glissade::test {
namespace {

constexpr int kSamples = 4;

/// Makes and binds a framebuffer with colour and depth.
unsigned makeFramebuffer(int width, int height, int samples) {
  unsigned framebuffer = 0;
  unsigned buffers[2];
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
  glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
  return framebuffer;
}

}  // namespace

struct WindowTarget::Impl {
  Impl(int wide, int high) : width(wide), height(high) {}

  int width;
  int height;
  PrivateContext context;
  unsigned smooth = makeFramebuffer(width, height, kSamples);
  unsigned plain = makeFramebuffer(width, height, 0);
  SceneView* drawn = nullptr;
  std::unique_ptr<SceneRenderer> renderer;
};

WindowTarget::WindowTarget(int width, int height) : impl_(std::make_unique<Impl>(width, height)) {}

WindowTarget::~WindowTarget() = default;

void WindowTarget::draw(SceneView& view) {
  if (impl_->drawn != &view) {
    impl_->renderer = std::make_unique<SceneRenderer>(view);
    impl_->drawn = &view;
  }
  impl_->renderer->resize(impl_->width, impl_->height);
  glBindFramebuffer(GL_FRAMEBUFFER, impl_->smooth);
  impl_->renderer->render(impl_->smooth);
  glFinish();
}

QImage WindowTarget::picture(SceneView& view) {
  draw(view);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->smooth);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, impl_->plain);
  glBlitFramebuffer(0, 0, impl_->width, impl_->height, 0, 0, impl_->width, impl_->height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->plain);
  QImage image(impl_->width, impl_->height, QImage::Format_RGBX8888);
  glReadPixels(0, 0, impl_->width, impl_->height, GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
  return image.mirrored();
}

}  // namespace glissade::test
