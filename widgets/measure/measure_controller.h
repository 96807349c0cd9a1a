#pragma once

#include <vector>

#include "widgets/scene3d/scene_pick.h"
#include "widgets/workbench/feature_store.h"
#include "widgets/workbench/left_click.h"
#include "widgets/workbench/scene_hint.h"

namespace glissade {

/// Measures items clicked in the scene: distances and angles between vertices, edges and faces, radii, clearances of
/// bodies. The result stays in the scene until the next one. Esc or the action end measuring. It also picks the plane
/// or the cylinder by which a body is placed, and the face of a section.
class MeasureController final : public QObject {
  Q_OBJECT

 public:
  enum class Kind { None, Distance, Angle, Radius, Clearance, Frame, Section };

  explicit MeasureController(const Workbench& bench);

  FeatureStore& features() { return store_; }
  /// Measures the distance between the two points where two rays of a hand first meet a body. The first call takes the
  /// first point.
  void measureAlong(const Ray& ray);

 signals:
  /// A face for a section was picked; its coordinates are in the world.
  void facePicked(const glissade::MeasureFeature& face);
  /// A frame of a body was picked, in the frame of its mesh (MeasurableMesh::frameAt()).
  void framePicked(const glissade::RigidBody& body, const glissade::Pose& X_BF);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Picked {
    RigidBody body;  ///< as it is drawn
    BodyHit hit;
    Vector3 p_W;
    double snap;  ///< metres
  };

  void connectActions();
  void setKind(Kind kind);
  void clear();
  std::optional<Picked> pick(const Ray& ray) const;
  void click(const QPointF& position);
  /// Picks a feature. Unknown planes, cylinders and edges of the body are found first, in the background.
  void takeFeature(const Picked& picked);
  void takeFrame(const Picked& picked, const MeasurableMesh& mesh);
  void addFeature(const MeasureFeature& feature);
  void addBody(const RigidBody& body);
  void measureFeatures();
  void measureClearance();
  void showDistance(const QString& text, const MeasuredDistance& distance);
  void show(const QString& text, MeasurePicture picture);
  void showHint();
  void addCommands();

  const Workbench& bench_;
  Kind kind_ = Kind::None;
  FeatureStore store_;
  SceneHint* hint_;
  QString result_;
  std::vector<MeasureFeature> features_;  ///< clicked features in the world
  std::vector<RigidBody> bodies_;         ///< clicked bodies
  BackgroundTask measuring_;
  LeftClick clicks_;
};

}  // namespace glissade
