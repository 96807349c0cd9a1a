#include "widgets/openxr/hand_models.h"

#include "engine/geometry/primitives.h"
#include "widgets/openxr/panel_model.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Sizes in metres of the room.
const Vector3 kHandle(0.028, 0.036, 0.11);
constexpr double kGuardRadius = 0.03;
constexpr double kGuardLength = 0.012;
constexpr double kHitRadius = 0.004;
constexpr double kTargetRadius = 0.2;
constexpr double kTargetHeight = 0.005;  ///< above the floor
constexpr float kRayWidth = 2.0F;        ///< pixels

/// Colours of Okabe and Ito's palette (2008).
const osg::Vec4 kOpen(0.34F, 0.71F, 0.91F, 1.0F);
const osg::Vec4 kClosed(0.90F, 0.62F, 0.0F, 1.0F);

/// A handle with a guard at its front, which is at -z.
osg::ref_ptr<osg::Node> makeHandle(const osg::Vec4& colour) {
  TriangleMesh mesh = makeBox(kHandle);
  append(mesh,
         transformed(makeCylinder(kGuardRadius, kGuardLength), Pose::translation({0.0, 0.0, -0.5 * kHandle.z()})));
  osg::ref_ptr<osg::Geode> handle = new osg::Geode;
  handle->addDrawable(makeSurface(makeBodyShape(mesh), colour));
  return handle;
}

/// A ray of length 1 along -z.
osg::ref_ptr<osg::Node> makeRay() {
  const osg::ref_ptr<osg::Geometry> line =
      makeLines({Vector3::Zero(), -Vector3::UnitZ()}, LineKind::Strip, kOpen, kRayWidth);
  makeUnlit(*line);
  return line;
}

osg::ref_ptr<osg::Node> makeHit() { return makeFlatSurface(makeSphere(kHitRadius, 2), kOpen); }

/// The pose with lengths multiplied by `length`.
osg::Matrixd scaled(double length, const Pose& X_WP) {
  return osg::Matrixd::scale(length, length, length) * toOsg(X_WP);
}

void setShown(osg::Node& node, bool shown) { node.setNodeMask(shown ? ~0U : 0U); }

}  // namespace

HandModels::HandModels()
    : group_(new osg::Group), models_{makeModel(), makeModel()}, target_(new osg::MatrixTransform) {
  for (const Model& model : models_) {
    for (osg::Node* part : {model.grip.get(), model.ray.get(), model.hit.get()}) {
      group_->addChild(part);
      setShown(*part, false);
    }
  }
  const osg::ref_ptr<osg::Geometry> disc =
      makeDisc(Vector3(0.0, 0.0, kTargetHeight), Vector3::UnitZ(), kTargetRadius, kOpen);
  makeUnlit(*disc);
  target_->addChild(disc);
  setShown(*target_, false);
  group_->addChild(target_);
}

HandModels::Model HandModels::makeModel() {
  Model model{new osg::MatrixTransform, makeHandle(kOpen), makeHandle(kClosed), new osg::MatrixTransform,
              new osg::MatrixTransform};
  model.grip->addChild(model.open);
  model.grip->addChild(model.closed);
  model.ray->addChild(makeRay());
  model.hit->addChild(makeHit());
  // Normals need normalizing, because the models are scaled with the room.
  for (osg::Node* part : {model.grip.get(), model.hit.get()}) part->getOrCreateStateSet()->setMode(GL_NORMALIZE, 1);
  for (osg::Node* part : {model.grip.get(), model.ray.get(), model.hit.get()}) {
    part->getOrCreateStateSet()->setRenderBinDetails(PanelModel::kBin + 1, "RenderBin");  // after the panel
  }
  return model;
}

void HandModels::show(const ShownHands& hands) {
  for (std::size_t i = 0; i < models_.size(); ++i) show(models_[i], hands.controllers[i]);
  setShown(*target_, hands.p_WT.has_value());
  if (hands.p_WT) target_->setMatrix(scaled(1.0 / hands.scale, Pose::translation(*hands.p_WT)));
}

void HandModels::show(const Model& model, const ShownController& controller) {
  const auto& [reading, feedback] = controller;
  const double metre = 1.0 / reading.scale;
  setShown(*model.grip, reading.X_WG.has_value());
  setShown(*model.open, !feedback.holds);
  setShown(*model.closed, feedback.holds);
  if (reading.X_WG) model.grip->setMatrix(scaled(metre, *reading.X_WG));
  const bool hasRay = reading.X_WA && !feedback.holds;
  setShown(*model.ray, hasRay);
  setShown(*model.hit, hasRay && feedback.pointsAt);
  if (!hasRay) return;
  const double length = feedback.pointsAt.value_or(kRayLength * metre);
  model.ray->setMatrix(scaled(length, *reading.X_WA));
  model.hit->setMatrix(scaled(metre, *reading.X_WA * Pose::translation({0.0, 0.0, -length})));
}

}  // namespace glissade
