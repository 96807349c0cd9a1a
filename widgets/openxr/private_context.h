#pragma once

#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace glissade {

/// Handles of an OpenGL context of X, with the types of Xlib and GLX but without their headers.
struct GlxHandles {
  void* display = nullptr;
  unsigned long visual = 0;
  void* framebufferConfig = nullptr;
  unsigned long drawable = 0;
  void* context = nullptr;
};

/// An OpenGL context for one thread, with its own connection to the display. It draws into framebuffer objects.
class PrivateContext {
 public:
  /// Makes the context current. Throws HeadsetFailure: NoDisplay.
  PrivateContext();
  /// May run on any thread, if the context is not current on another one.
  ~PrivateContext();
  PrivateContext(const PrivateContext&) = delete;
  PrivateContext& operator=(const PrivateContext&) = delete;

  void makeCurrent();
  /// Releases the context; another thread may then make it current.
  void release();
  osg::GraphicsContext& osgContext() { return *context_; }
  const GlxHandles& handles() const { return handles_; }

 private:
  osg::ref_ptr<osg::GraphicsContext> context_;
  GlxHandles handles_;
};

}  // namespace glissade
