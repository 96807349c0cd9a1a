#pragma once

#include "app/window/workbench.h"
#include "engine/sequence/demand_edits.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

class SequenceController;

/// What people see of the names of these bodies, with commas.
QString joinedNames(const std::vector<std::string>& bodies, const AssembledProduct& product);

/// What a person does to the steps of a plan: puts them elsewhere, locks them, forbids directions. Each is an undoable
/// change of the document's demands, after which the sequence is planned anew.
class SequenceEdits final : public QObject {
  Q_OBJECT

 public:
  SequenceEdits(const Workbench& bench, SequenceController& sequence);

  /// Cones of the directions that are forbidden to bodies of the selected steps, or to the stuck one. `bodies`: where
  /// they are drawn; empty: where they are assembled.
  std::vector<ForbiddenCone> forbiddenCones(const std::vector<SequenceBody>& bodies) const;

 private:
  void connectActions();
  void addScriptCommands();
  void move(std::size_t from, std::size_t to);
  void moveBy(int rows);
  void lock(bool locked);
  void forbid(const Vector3& direction);
  void forbidWay();
  void keepOrder();
  void freeSteps();
  /// Bodies of the selected steps, or the stuck one.
  std::vector<std::string> chosenBodies() const;
  void fillDemandsMenu();
  void set(const QString& text, const SequenceDemands& demands);
  void enableActions();

  const Workbench& bench_;
  SequenceController& sequence_;
};

}  // namespace glissade
