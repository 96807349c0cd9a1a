#include "widgets/arrange/arrange_snapping.h"

#include <QCoreApplication>
#include <QStringList>

namespace glissade {
namespace {

using Part = AssemblyItem::Kind;

void addOutline(const SnapFeature& feature, const MeasurableMesh& mesh, const Pose& X_WB, MeasurePicture& picture) {
  for (const Vector3& p : mesh.outlineAt(feature.triangle)) picture.segments.push_back(X_WB * p);
}

/// Adds the axis of two features, as long as both together.
void addAxis(const SnapFeature& moving, const SnapFeature& fixed, MeasurePicture& picture) {
  const Box3 both = moving.box.merged(fixed.box);
  const double half = 0.5 * both.diagonal().norm();
  const double middle = (Vector3(both.center()) - fixed.point).dot(fixed.direction);
  for (const double end : {middle - half, middle + half}) {
    picture.segments.push_back(fixed.point + end * fixed.direction);
  }
}

}  // namespace

void ArrangeSnapping::Side::add(const QString& name, const MeshFeaturesPtr& found, const Pose& X_WB) {
  if (!found) return;
  for (const SnapFeature& feature : found->snap) {
    features.push_back(placed(feature, X_WB));
    owners.push_back({name, found, X_WB});
  }
}

void ArrangeSnapping::begin(const AssemblyItem& item) {
  end();
  if (!on_) return;
  moving_ = {};
  fixed_ = {};
  const LoadedScenario& scenario = *document_.scenario();
  for (const RigidBody& body : scenario.obstacles) {
    const MeshFeaturesPtr found = features_.find(body.mesh);
    if (item.kind == Part::Body && bodyIdOf(body.id) == item.bodyId) {
      moving_.add(QString::fromStdString(body.shown()), found, body.X_WB);
    } else if (view_.layerVisible(SceneLayer::Bodies) && view_.hiddenBodies().count(body.id) == 0) {
      fixed_.add(QString::fromStdString(body.shown()), found, body.X_WB);
    }
  }
  const MeshFeaturesPtr object = features_.find(scenario.object.mesh);
  const QString name = QString::fromStdString(scenario.object.shown());
  Side& side = item.kind == Part::Body ? fixed_ : moving_;
  const Pose* goal = std::get_if<Pose>(&scenario.problem.goal);
  side.add(name, object, item.kind == Part::Goal && goal != nullptr ? *goal : scenario.problem.start);
  Box3 box;
  for (const SnapFeature& feature : moving_.features) box.extend(feature.box);
  if (box.isEmpty()) return;
  snapper_ = std::make_unique<const FeatureSnapper>(moving_.features, fixed_.features, box.diagonal().norm());
}

FeatureSnap ArrangeSnapping::snap(const Vector3& shift, const std::vector<Vector3>& freedom, double reach) const {
  return snapper_ ? snapper_->snap(shift, freedom, reach) : FeatureSnap{shift, {}};
}

MeasurePicture ArrangeSnapping::pictureOf(const FeatureSnap& snap) const {
  MeasurePicture picture;
  const Pose shift = Pose::translation(snap.shift);
  for (const FeatureSnap::Pair& pair : snap.pairs) {
    const SnapFeature moving = placed(moving_.features[pair.moving], shift);
    const SnapFeature& fixed = fixed_.features[pair.fixed];
    const Owner& mover = moving_.owners[pair.moving];
    const Owner& other = fixed_.owners[pair.fixed];
    addOutline(moving, mover.features->measurable, shift * mover.X_WB, picture);
    addOutline(fixed, other.features->measurable, other.X_WB, picture);
    if (fixed.kind == SnapFeature::Kind::Axis) addAxis(moving, fixed, picture);
  }
  return picture;
}

QString ArrangeSnapping::textOf(const FeatureSnap& snap) const {
  QStringList texts;
  for (const FeatureSnap::Pair& pair : snap.pairs) {
    const SnapFeature& fixed = fixed_.features[pair.fixed];
    const QString& name = fixed_.owners[pair.fixed].name;
    if (fixed.kind == SnapFeature::Kind::Axis) {
      texts << QCoreApplication::translate("Arranging", "on the axis of %1").arg(name);
    } else if (moving_.features[pair.moving].direction.dot(fixed.direction) < 0.0) {
      texts << QCoreApplication::translate("Arranging", "on the face of %1").arg(name);
    } else {
      texts << QCoreApplication::translate("Arranging", "level with the face of %1").arg(name);
    }
  }
  return texts.join(QStringLiteral(", "));
}

}  // namespace glissade
