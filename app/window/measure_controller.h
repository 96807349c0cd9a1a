#pragma once

#include <QLabel>

#include <map>
#include <memory>
#include <vector>

#include "app/window/workbench.h"
#include "engine/product/alignment.h"
#include "engine/scenario/assembly_edits.h"
#include "widgets/bridge/background_task.h"
#include "widgets/scene3d/scene_pick.h"

namespace glissade {

/// Measures what is clicked in the scene: distances and angles between vertices, edges and faces, radii, clearances of
/// bodies. The result stays in the scene until the next one. Esc, or the action again, ends measuring. Also picks the
/// plane or the cylinder that a body is placed by, the face of a section, and the two that are put onto each other.
class MeasureController final : public QObject {
  Q_OBJECT

 public:
  enum class Kind { None, Distance, Angle, Radius, Clearance, Frame, Align, Section };

  explicit MeasureController(const Workbench& bench);

  /// What is selected: the first click of an alignment means it also behind other bodies.
  void setSelected(const std::optional<AssemblyItem>& item) { selected_ = item; }

 signals:
  /// The face that a section lies along, world frame.
  void facePicked(const glissade::MeasureFeature& face);
  /// A frame of a body, in the frame of its mesh (MeasurableMesh::frameAt()).
  void framePicked(const glissade::RigidBody& body, const glissade::Pose& X_BF);
  /// The first of the two that are put onto each other was clicked: this is what moves.
  void movingPicked(const glissade::AssemblyItem& item);
  /// Both were clicked, which canAlign(); in the world.
  void alignmentPicked(const glissade::AssemblyItem& item, const glissade::MeasureFeature& moving,
                       const glissade::MeasureFeature& fixed);
  /// Esc, before both were clicked.
  void alignmentLeft();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Picked {
    RigidBody body;  ///< where it is drawn
    BodyHit hit;
    Vector3 p_W;
    double snap;                       ///< metres
    std::optional<AssemblyItem> item;  ///< of Kind::Align
  };

  void connectActions();
  void setKind(Kind kind);
  void clear();
  std::optional<Picked> pick(const QPointF& position) const;
  std::optional<Picked> pickItem(const QPointF& position) const;
  void click(const QPointF& position);
  /// Finds planes, cylinders and edges of the body first, in the background, where they are not known yet.
  void takeFeature(const Picked& picked);
  void takeFrame(const Picked& picked, const MeasurableMesh& mesh);
  void takeAlignment(const AssemblyItem& item, const MeasureFeature& feature);
  void addFeature(const MeasureFeature& feature);
  void addBody(const RigidBody& body);
  void measureFeatures();
  void measureClearance();
  void showDistance(const QString& text, const MeasuredDistance& distance);
  void show(const QString& text, MeasurePicture picture);
  void showHint();
  void writeHint(const QString& text);
  void placeHint();
  void addCommands();

  const Workbench& bench_;
  Kind kind_ = Kind::None;
  QLabel* hint_;
  QString result_;
  std::vector<MeasureFeature> features_;  ///< that were clicked, world frame
  std::optional<AssemblyItem> selected_;
  AssemblyItem moving_;            ///< of Kind::Align: whose feature was clicked first
  std::vector<RigidBody> bodies_;  ///< likewise
  std::map<MeshPtr, std::shared_ptr<const MeasurableMesh>> prepared_;
  BackgroundTask preparation_;
  QPointF pressed_;
};

}  // namespace glissade
