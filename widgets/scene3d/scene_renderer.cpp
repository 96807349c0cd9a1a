#include "widgets/scene3d/scene_renderer.h"

#include "widgets/scene3d/camera_controller.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {

SceneRenderer::SceneRenderer(SceneView& view) : view_(view), viewer_(new osgViewer::Viewer) {
  viewer_->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
  window_ = viewer_->setUpViewerAsEmbeddedInWindow(0, 0, 64, 64);
  viewer_->setKeyEventSetsDone(0);
  viewer_->setQuitEventSetsDone(false);
  viewer_->setLightingMode(osg::View::HEADLIGHT);
  viewer_->getLight()->setAmbient(osg::Vec4(0.35F, 0.35F, 0.35F, 1.0F));
  viewer_->getLight()->setDiffuse(osg::Vec4(0.75F, 0.75F, 0.75F, 1.0F));
  viewer_->getLight()->setSpecular(osg::Vec4(0.0F, 0.0F, 0.0F, 1.0F));
  viewer_->getCamera()->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
  viewer_->setSceneData(view.root());
}

void SceneRenderer::resize(int width, int height) {
  window_->resized(0, 0, width, height);
  window_->getEventQueue()->windowResize(0, 0, width, height);
  viewer_->getCamera()->setViewport(0, 0, width, height);
  view_.camera().setAspect(static_cast<double>(width) / height);
}

void SceneRenderer::render(unsigned int target) {
  window_->setDefaultFboId(target);
  const CameraController& controller = view_.camera();
  osg::Camera* camera = viewer_->getCamera();
  const Pose X_WV{controller.eye(), controller.R_WV()};
  camera->setViewMatrix(toOsg(inverse(X_WV)));
  camera->setProjectionMatrixAsPerspective(controller.verticalFieldOfView() * 180.0 / std::acos(-1.0),
                                           controller.aspect(), controller.nearPlane(), controller.farPlane());
  camera->setClearColor(toOsg(view_.background()));
  viewer_->frame();
}

}  // namespace glissade
