#pragma once

#include <QTreeWidget>

#include "engine/scenario/scenario.h"

namespace glissade {

/// What is in the scene: bodies with their colour, mobility and triangles, the object, its ends.
class ScenePanel final : public QTreeWidget {
  Q_OBJECT

 public:
  explicit ScenePanel(QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);

 private:
  QTreeWidgetItem* addGroup(const QString& title);
  static void addBody(QTreeWidgetItem& group, const RigidBody& body, const QString& kind);
};

}  // namespace glissade
