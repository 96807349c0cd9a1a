#pragma once

#include "engine/sequence/demand_edits.h"
#include "widgets/scene3d/scene_view.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// The shown names of these bodies, separated by commas.
QString joinedNames(const std::vector<BodyId>& bodies, const AssembledProduct& product);

/// Edits of the steps of a plan: moves them, locks them, forbids directions. Each edit is an undoable change of the
/// document's demands, and the sequence is planned again.
class SequenceEdits final : public QObject {
  Q_OBJECT

 public:
  SequenceEdits(const Workbench& bench, SequenceController& sequence);

  /// Cones of the directions that are forbidden to bodies of the selected steps, or to the stuck body. `bodies`: their
  /// drawn poses; empty: their assembled poses.
  std::vector<ForbiddenCone> forbiddenCones(const std::vector<SequenceBody>& bodies) const;

 private:
  void connectActions();
  void addScriptCommands();
  void move(std::size_t from, std::size_t to);
  void moveBy(int rows);
  std::size_t rowOf(std::size_t place) const;
  void lock(bool locked);
  void forbid(const Vector3& direction);
  void forbidWay();
  void keepOrder();
  void freeSteps();
  /// Bodies of the selected steps, or the stuck body.
  std::vector<BodyId> chosenBodies() const;
  void fillDemandsMenu();
  void set(const QString& text, const SequenceDemands& demands);
  void enableActions();

  const Workbench& bench_;
  SequenceController& sequence_;
};

}  // namespace glissade
