#pragma once

#include <QTimer>

#include "engine/fits/alignment.h"
#include "widgets/workbench/arranged_item.h"
#include "widgets/workbench/feature_store.h"
#include "widgets/workbench/left_click.h"
#include "widgets/workbench/scene_hint.h"

namespace glissade {

/// While the tool is on, a person clicks a vertex, an edge, a plane or a cylinder of the moving item, and then a
/// feature of another item that it is aligned with. The feature under the pointer is marked. Before the second click
/// the moving item is drawn where it would lie. Esc ends the tool.
class AlignTool final : public QObject {
  Q_OBJECT

 public:
  AlignTool(const Workbench& bench, FeatureStore& features);

  void setOn(bool on);
  /// The first click prefers the selected item, also behind other bodies.
  void setSelected(const std::optional<AssemblyItem>& item) { selected_ = item; }
  /// The text over the scene.
  QString hint() const { return hint_->text(); }

 signals:
  /// The first feature was clicked; its item is the one that moves.
  void movingPicked(const glissade::AssemblyItem& item);
  /// Both features were clicked and canAlign() accepts them. Their coordinates are in the world.
  void picked(const glissade::AssemblyItem& item, const glissade::MeasureFeature& moving,
              const glissade::MeasureFeature& fixed);
  /// Esc was pressed.
  void left();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The hit of a point of the scene.
  struct Target {
    AssemblyItem item;
    RigidBody body;  ///< the body at the pose at which it is drawn
    std::size_t triangle;
    Vector3 p_W;
    double snap;  ///< metres
  };
  struct Pointed {
    AssemblyItem item;
    MeasureFeature feature;          ///< world
    std::vector<Vector3> outline{};  ///< of a face, world: two points for each segment
  };

  bool followMouse(const QMouseEvent& event);
  std::optional<Target> targetAt(const QPointF& position) const;
  Pointed pointedAt(const Target& target, const MeasurableMesh& mesh) const;
  void hover();
  void click(const QPointF& position);
  void take(const Target& target);
  void takePointed(const Pointed& pointed);
  void mark(const std::optional<Pointed>& hovered);
  void preview(const std::optional<Pointed>& onto);
  QString hintFor(const std::optional<Pointed>& hovered) const;
  bool fits(const Pointed& onto) const;

  const Workbench& bench_;
  FeatureStore& features_;
  SceneHint* hint_;
  bool on_ = false;
  std::optional<AssemblyItem> selected_;
  std::optional<Pointed> first_;
  bool previewed_ = false;
  LeftClick clicks_;
  QPointF pointer_;
  QTimer hovering_;  ///< limits the hit tests, because the pointer moves faster than bodies are hit
};

}  // namespace glissade
