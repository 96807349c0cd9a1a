#pragma once

#include <QSet>
#include <QTreeWidget>
#include <optional>
#include <set>
#include <string>

#include "engine/scenario/assembly_edits.h"

namespace glissade {

/// What is in the scene: bodies with their colour, mobility and triangles, the object, its ends.
class ScenePanel final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit ScenePanel(QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  /// The obstacles, by id, whose boxes are not checked. Announces nothing.
  void setHiddenBodies(const std::set<std::string>& bodyIds);
  /// What is selected: rigid bodies by id, or the start or the goal. Announces nothing.
  void showSelection(const QSet<QString>& bodyIds, const std::optional<AssemblyItem>& chosen);

 signals:
  /// The user wants an obstacle to be shown, or not.
  void bodyChecked(const QString& bodyId, bool visible);
  /// The user has selected these rigid bodies, the object among them or not.
  void bodiesChosen(const QSet<QString>& bodyIds);
  void endChosen(glissade::AssemblyItem::Kind end);

 private:
  QTreeWidgetItem* addGroup(const QString& title);
  static QTreeWidgetItem* addBody(QTreeWidgetItem& group, const RigidBody& body, const QString& kind);

  QTreeWidgetItem* addEnd(QTreeWidgetItem& group, const QString& text, AssemblyItem::Kind end);
  void showDeflections(const LoadedScenario& scenario);
  void takeSelection();

  QTreeWidgetItem* obstacles_ = nullptr;
};

}  // namespace glissade
