#pragma once

#include <QString>

#include <memory>
#include <optional>

#include "engine/access/placed_hand.h"
#include "engine/access/plan_access.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class PathPanel;
class SequenceController;

/// Checks whether a person's hand reaches the parts of the sequence's steps, or the object along the path. It checks in
/// the background, draws the hand at the moving bodies, and marks the steps in the table of the sequence.
class AccessController final : public QObject {
  Q_OBJECT

 public:
  AccessController(const Workbench& bench, SequenceController& sequence, PathPanel& pathPanel);

 private:
  void addSizes();
  void addCommands();
  void setSize(HandSize size);
  void checkSequence();
  void checkPath();
  void takePath(const std::shared_ptr<const Path>& path, const PathAccess& access);
  /// Path of the run or of the replay that is shown; may be null.
  std::shared_ptr<const Path> path() const;
  void followPath();
  /// Whether the steps of the sequence are shown, not the path.
  bool showsSteps() const;
  void showNextUnreached();
  /// Draws the hand at the moving bodies.
  void updateHand();
  void fitWithHand(const ReachPicture& picture);
  ReachPicture pictureOfStep() const;
  ReachPicture pictureOnPath() const;
  void enableActions();
  Outcome expectAccess(const ScriptCommands::Words& words) const;

  const Workbench& bench_;
  SequenceController& sequence_;
  PathPanel& pathPanel_;
  Person person_;
  std::shared_ptr<const Path> checkedPath_;  ///< null: no path was checked
  PathAccess pathAccess_;                    ///< access to checkedPath_
  bool isDrawn_ = false;                     ///< whether the last update drew a hand
};

}  // namespace glissade
