#pragma once

#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace glissade {

/// What a runtime is told about an OpenGL context of X: handles as Xlib and GLX have them, without their headers.
struct GlxHandles {
  void* display = nullptr;
  unsigned long visual = 0;
  void* framebufferConfig = nullptr;
  unsigned long drawable = 0;
  void* context = nullptr;
};

/// An OpenGL context of a thread's own, with a connection to the display of its own. It draws into framebuffer objects.
class PrivateContext {
 public:
  /// Makes the context current. Throws HeadsetFailure: NoDisplay.
  PrivateContext();
  /// On any thread, where it is not current on another one.
  ~PrivateContext();
  PrivateContext(const PrivateContext&) = delete;
  PrivateContext& operator=(const PrivateContext&) = delete;

  void makeCurrent();
  /// Another thread may make it current then.
  void release();
  osg::GraphicsContext& osgContext() { return *context_; }
  const GlxHandles& handles() const { return handles_; }

 private:
  osg::ref_ptr<osg::GraphicsContext> context_;
  GlxHandles handles_;
};

}  // namespace glissade
