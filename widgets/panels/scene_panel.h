#pragma once

#include <QSet>
#include <QTreeWidget>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/scenario/assembly_edits.h"

namespace glissade {

/// What is in the scene: the object's bodies, its ends, the obstacles with their colour, mobility and triangles, and
/// what is left out. Obstacles stand under the assemblies of the product. To select, hide or show an assembly is to do
/// so with all of its bodies.
class ScenePanel final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit ScenePanel(QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  /// Leaves the obstacles whose names contain this text; empty: all.
  void setFilter(const QString& text);
  /// The obstacles, by id, whose boxes are not checked. Announces nothing.
  void setHiddenBodies(const std::set<std::string>& bodyIds);
  /// What is selected: rigid bodies by id, or the start or the goal. Announces nothing.
  void showSelection(const QSet<QString>& bodyIds, const std::optional<AssemblyItem>& chosen);
  /// Selects this row of what is left out alone. False: there is none.
  bool chooseLeftOut(const std::string& bodyId);
  /// Ids of the selected rows of what is left out.
  std::vector<std::string> chosenLeftOut() const;

 signals:
  /// The user wants an obstacle to be shown, or not.
  void bodyChecked(const QString& bodyId, bool visible);
  /// The user has selected these rigid bodies, the object among them or not.
  void bodiesChosen(const QSet<QString>& bodyIds);
  void endChosen(glissade::AssemblyItem::Kind end);

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
