#include "widgets/scene3d/scene_renderer.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/osg_convert.h"
#include "widgets/scene3d/scene_lights.h"

namespace glissade {
namespace {

/// Size in device pixels (OSG's measure and default), or share of the tolerance, below which bodies are not drawn.
constexpr double kLeastBody = 2.0;
constexpr double kLeastBodyShare = 0.5;

}  // namespace

SceneRenderer::SceneRenderer(SceneView& view) : view_(view), viewer_(new osgViewer::Viewer) {
  viewer_->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
  window_ = viewer_->setUpViewerAsEmbeddedInWindow(0, 0, 64, 64);
  viewer_->setKeyEventSetsDone(0);
  viewer_->setQuitEventSetsDone(false);
  viewer_->setLightingMode(osg::View::NO_LIGHT);
  viewer_->getCamera()->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
  viewer_->getCamera()->setCullMask(~kHeadsetOnly);
  viewer_->getCamera()->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  const osg::ref_ptr<osg::Group> lit = makeLights();
  lit->addChild(view.root());
  viewer_->setSceneData(lit);
}

void SceneRenderer::resize(int width, int height) {
  width_ = width;
  height_ = height;
  view_.camera().setAspect(static_cast<double>(width) / height);
}

void SceneRenderer::render(unsigned int target) { render(target, width_, height_, PictureDetail()); }

void SceneRenderer::render(unsigned int target, int width, int height, const PictureDetail& detail) {
  window_->resized(0, 0, width, height);
  window_->getEventQueue()->windowResize(0, 0, width, height);
  window_->setDefaultFboId(target);
  osg::Camera* camera = viewer_->getCamera();
  camera->setViewport(0, 0, width, height);
  const CameraController& controller = view_.camera();
  const std::lock_guard lock(*view_.graphMutex());
  camera->setViewMatrix(toOsg(inverse(Pose{controller.eye(), controller.R_WV()})));
  setProjection();
  view_.beginPicture(width, height, detail);
  const double tolerance = detail.tolerance * view_.pixelScale() * height / height_;
  camera->setLODScale(static_cast<float>(tolerance));
  camera->setSmallFeatureCullingPixelSize(static_cast<float>(std::max(kLeastBody, kLeastBodyShare * tolerance)));
  camera->setClearColor(toOsg(view_.background()));
  viewer_->frame();
}

void SceneRenderer::setProjection() {
  const CameraController& controller = view_.camera();
  osg::Camera* camera = viewer_->getCamera();
  if (controller.isOrthographic()) {
    const double top = 0.5 * controller.viewHeight();
    const double right = top * controller.aspect();
    camera->setProjectionMatrixAsOrtho(-right, right, -top, top, controller.nearPlane(), controller.farPlane());
  } else {
    camera->setProjectionMatrixAsPerspective(controller.verticalFieldOfView() * 180.0 / std::acos(-1.0),
                                             controller.aspect(), controller.nearPlane(), controller.farPlane());
  }
  osg::Matrixd projection = camera->getProjectionMatrix();
  projection(0, 0) *= controller.magnification();
  projection(1, 1) *= controller.magnification();
  projection(2, 0) -= 2.0 * controller.shift().x() / controller.aspect();
  projection(2, 1) -= 2.0 * controller.shift().y();
  camera->setProjectionMatrix(projection);
}

}  // namespace glissade
