#pragma once

#include <QTreeWidget>
#include <set>
#include <string>

#include "engine/scenario/scenario.h"

namespace glissade {

/// What is in the scene: bodies with their colour, mobility and triangles, the object, its ends.
class ScenePanel final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit ScenePanel(QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  /// The obstacles, by id, whose boxes are not checked. Announces nothing.
  void setHiddenBodies(const std::set<std::string>& bodyIds);

 signals:
  /// The user wants an obstacle to be shown, or not.
  void bodyChecked(const QString& bodyId, bool visible);

 private:
  QTreeWidgetItem* addGroup(const QString& title);
  static QTreeWidgetItem* addBody(QTreeWidgetItem& group, const RigidBody& body, const QString& kind);

  QTreeWidgetItem* obstacles_ = nullptr;
};

}  // namespace glissade
