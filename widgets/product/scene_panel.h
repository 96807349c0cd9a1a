#pragma once

#include <QSet>
#include <QTreeWidget>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/files/assembly_edits.h"

namespace glissade {

/// The content of the scene: the object's bodies, its ends, the obstacles with their colour, mobility and triangles,
/// and the bodies that are left out. Obstacles stand under the assemblies of the product. Selecting, hiding or showing
/// an assembly applies to all of its bodies.
class ScenePanel final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit ScenePanel(QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  /// Keeps only the obstacles whose names contain this text visible; empty: all.
  void setFilter(const QString& text);
  /// Unchecks the boxes of these obstacles, by id. Emits no signal.
  void setHiddenBodies(const std::set<BodyId>& bodyIds);
  /// Shows the selection: rigid bodies by id, or the start or the goal. Emits no signal.
  void showSelection(const QSet<QString>& bodyIds, const std::optional<AssemblyItem>& chosen);
  /// Selects only the row of this body that is left out. False if there is none.
  bool chooseLeftOut(const BodyId& bodyId);
  /// Edits the name of the first selected body.
  void editName();
  /// Ids of the selected bodies that are left out.
  std::vector<BodyId> chosenLeftOut() const;

 signals:
  /// The user has given a body another name.
  void bodyRenamed(const QString& bodyId, const QString& name);
  /// The user shows or hides an obstacle.
  void bodyChecked(const QString& bodyId, bool visible);
  /// The user has selected these rigid bodies, which may be the object's.
  void bodiesChosen(const QSet<QString>& bodyIds);
  void endChosen(glissade::AssemblyItem::Kind end);
  void lengthUnitChanged();

 protected:
  /// A narrow list leaves the numbers of triangles out, so that the names can be read.
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QTreeWidgetItem* addGroup(const QString& title);
  static QTreeWidgetItem* addBody(QTreeWidgetItem& group, const RigidBody& body, const QString& kind);

  void addObstacles(const LoadedScenario& scenario);
  static QTreeWidgetItem* addObstacle(QTreeWidgetItem& parent, const RigidBody& body, const QString& name);
  static QTreeWidgetItem* addAssembly(QTreeWidgetItem& parent, const QString& name, const QString& path);
  QTreeWidgetItem* addEnd(QTreeWidgetItem& group, const QString& text, AssemblyItem::Kind end);
  void addLeftOut(const Scenario& scenario);
  void showDeflections(const LoadedScenario& scenario);
  void takeSelection();

  /// The items of the obstacles, in their order.
  std::vector<QTreeWidgetItem*> obstacleItems() const;

  QTreeWidgetItem* obstacles_ = nullptr;
};

}  // namespace glissade
