#pragma once

#include <QObject>
#include <QPointF>

#include "engine/scenario/assembly_edits.h"
#include "widgets/bridge/session_bridge.h"
#include "widgets/scene3d/pose_drag.h"
#include "widgets/scene3d/scene_widget.h"

namespace glissade {

/// While it is on, a person takes bodies, and the object's ghosts at its start and its goal, with the mouse:
/// drag moves them in the plane of the view, Ctrl+drag turns them. Bodies and ghosts are only drawn elsewhere
/// until they are dropped.
class ArrangeTool final : public QObject {
  Q_OBJECT

 public:
  ArrangeTool(SceneWidget& scene, QObject* parent);

  void setScenario(const ScenarioPtr& scenario);
  void setOn(bool on);
  /// What is selected is gripped also behind other bodies.
  void setSelected(const std::optional<AssemblyItem>& item) { selected_ = item; }

 signals:
  void gripped(const glissade::AssemblyItem& item);
  void dropped(const glissade::AssemblyItem& item, const glissade::Pose& X_WB);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool grip(const QPointF& position);
  void follow(const QPointF& position, bool turning);
  void drop();
  void draw(const Pose& X_WB);

  struct InHand {
    AssemblyItem item;
    Pose before;
    PoseDrag drag;
  };

  SceneWidget& scene_;
  ScenarioPtr scenario_;
  bool on_ = false;
  std::optional<AssemblyItem> selected_;
  std::optional<InHand> inHand_;
  QPointF last_;
};

}  // namespace glissade
