#include "widgets/openxr/eye_painter.h"

#include <osg/FrameBufferObject>
#include <osg/GLExtensions>
#include <osgUtil/Statistics>

#include <chrono>

#include "widgets/openxr/headset_failure.h"
#include "widgets/scene3d/osg_convert.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSamples = 4;              ///< samples of a pixel, as in the window
constexpr double kLongestFree = 0.0005;  ///< s

const osg::GLExtensions& functionsOf(osg::GraphicsContext& context) {
  return *context.getState()->get<osg::GLExtensions>();
}

osg::ref_ptr<osgUtil::SceneView> makeView(osg::GraphicsContext& context, osg::Node* scene) {
  osg::ref_ptr<osgUtil::SceneView> view = new osgUtil::SceneView;
  view->setDefaults(osgUtil::SceneView::NO_SCENEVIEW_LIGHT);
  view->setState(context.getState());
  view->setFrameStamp(new osg::FrameStamp);
  view->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
  view->setCullMask(~kWindowOnly);
  view->getCamera()->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  // The draw buffer is one of a framebuffer object; OSG's default is an error there.
  view->setDrawBufferValue(GL_COLOR_ATTACHMENT0_EXT);
  view->setSceneData(scene);
  return view;
}

}  // namespace

EyePainter::EyePainter(osg::GraphicsContext& context, osg::Node* scene)
    : context_(&context), view_(makeView(context, scene)) {}

EyePainter::~EyePainter() { removeBuffers(); }

void EyePainter::removeBuffers() {
  if (smooth_ == 0) return;
  const osg::GLExtensions& gl = functionsOf(*context_);
  gl.glDeleteFramebuffers(1, &smooth_);
  gl.glDeleteFramebuffers(1, &copied_);
  gl.glDeleteRenderbuffers(1, &colour_);
  gl.glDeleteRenderbuffers(1, &depth_);
  smooth_ = 0;
}

void EyePainter::setTarget(int width, int height, std::int64_t format) {
  removeBuffers();
  width_ = width;
  height_ = height;
  view_->setViewport(0, 0, width, height);
  const osg::GLExtensions& gl = functionsOf(*context_);
  gl.glGenFramebuffers(1, &smooth_);
  gl.glGenFramebuffers(1, &copied_);
  gl.glGenRenderbuffers(1, &colour_);
  gl.glGenRenderbuffers(1, &depth_);
  gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, smooth_);
  gl.glBindRenderbuffer(GL_RENDERBUFFER_EXT, colour_);
  gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER_EXT, kSamples, static_cast<GLenum>(format), width, height);
  gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_RENDERBUFFER_EXT, colour_);
  gl.glBindRenderbuffer(GL_RENDERBUFFER_EXT, depth_);
  gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER_EXT, kSamples, GL_DEPTH24_STENCIL8_EXT, width, height);
  gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER_EXT, depth_);
  if (gl.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) != GL_FRAMEBUFFER_COMPLETE_EXT) {
    throw HeadsetFailure(HeadsetTrouble::Failed, "no framebuffer for the eyes");
  }
}

void EyePainter::draw(const EyeSight& sight, const EyeDetail& detail) {
  freeDeleted();
  view_->setLODScale(static_cast<float>(detail.tolerance));
  view_->setSmallFeatureCullingPixelSize(static_cast<float>(detail.leastBody));
  const osg::GLExtensions& gl = functionsOf(*context_);
  gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, smooth_);
  const double distance = sight.nearPlane;
  view_->setViewMatrix(toOsg(inverse(sight.X_WE)));
  view_->setProjectionMatrixAsFrustum(sight.sides.left * distance, sight.sides.right * distance,
                                      sight.sides.down * distance, sight.sides.up * distance, distance, sight.farPlane);
  const auto begin = Clock::now();
  view_->cull();
  const auto culled = Clock::now();
  view_->draw();
  cullSeconds_ = std::chrono::duration<double>(culled - begin).count();
  drawSeconds_ = std::chrono::duration<double>(Clock::now() - culled).count();
}

/// Frees objects of OpenGL whose parts of the scene are gone.
void EyePainter::freeDeleted() {
  double seconds = kLongestFree;
  view_->flushDeletedGLObjects(seconds);
}

EyeFigures EyePainter::figures() {
  osgUtil::Statistics found;
  view_->getStats(found);
  EyeFigures figures{found.numDrawables + found.numFastDrawables, 0, cullSeconds_, drawSeconds_};
  for (const auto& [mode, number] : found.getPrimitiveCountMap()) {
    if (mode >= GL_TRIANGLES && mode <= GL_POLYGON) figures.triangles += number;
  }
  return figures;
}

void EyePainter::copyTo(unsigned texture) {
  const auto begin = Clock::now();
  const osg::GLExtensions& gl = functionsOf(*context_);
  gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, smooth_);
  gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, copied_);
  gl.glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, texture, 0);
  gl.glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, 0, 0);
  gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, 0);
  drawSeconds_ += std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace glissade
