#include "widgets/openxr/private_context.h"

#include "widgets/openxr/headset_failure.h"

// This header comes last, because its macros are common words.
#include <GL/glx.h>

namespace glissade {
namespace {

/// The handles of the current context.
GlxHandles currentHandles() {
  Display* display = glXGetCurrentDisplay();
  GLXContext context = glXGetCurrentContext();
  int id = 0;
  glXQueryContext(display, context, GLX_FBCONFIG_ID, &id);
  const int wanted[] = {GLX_FBCONFIG_ID, id, 0};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  if (configs == nullptr || count == 0) throw HeadsetFailure(HeadsetTrouble::NoDisplay, "no framebuffer configuration");
  GLXFBConfig config = configs[0];
  XFree(configs);
  int visual = 0;
  glXGetFBConfigAttrib(display, config, GLX_VISUAL_ID, &visual);
  return {display, static_cast<unsigned long>(visual), config, glXGetCurrentDrawable(), context};
}

}  // namespace

PrivateContext::PrivateContext() {
  osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
  traits->readDISPLAY();
  traits->width = 16;
  traits->height = 16;
  traits->red = traits->green = traits->blue = traits->alpha = 8;
  traits->depth = 24;
  traits->pbuffer = true;
  traits->doubleBuffer = false;
  traits->vsync = false;
  context_ = osg::GraphicsContext::createGraphicsContext(traits);
  if (!context_ || !context_->realize() || !context_->makeCurrent()) {
    throw HeadsetFailure(HeadsetTrouble::NoDisplay, "no OpenGL context");
  }
  handles_ = currentHandles();
}

PrivateContext::~PrivateContext() { context_->close(); }

void PrivateContext::makeCurrent() {
  if (!context_->makeCurrent()) throw HeadsetFailure(HeadsetTrouble::NoDisplay, "the OpenGL context is not available");
}

void PrivateContext::release() { context_->releaseContext(); }

}  // namespace glissade
