#pragma once

#include <QString>

#include <memory>
#include <optional>

#include "app/window/workbench.h"
#include "engine/access/placed_hand.h"
#include "engine/access/plan_access.h"

namespace glissade {

class PathPanel;
class SequenceController;

/// Whether a person's hand gets to the steps of the sequence, or to the path: asked in the background, drawn at what
/// moves, and marked in the table of the sequence.
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
  /// Of the run, or of the replay that is shown; may be null.
  std::shared_ptr<const Path> path() const;
  void followPath();
  /// The sequence is what is shown.
  bool showsSteps() const;
  void showNextUnreached();
  /// Draws the hand where what moves is drawn.
  void updateHand();
  ReachPicture pictureOfStep() const;
  ReachPicture pictureOnPath() const;
  void enableActions();
  Outcome expectAccess(const ScriptCommands::Words& words) const;

  const Workbench& bench_;
  SequenceController& sequence_;
  PathPanel& pathPanel_;
  Person person_;
  std::shared_ptr<const Path> checkedPath_;  ///< null: no path was checked
  PathAccess pathAccess_;                    ///< of that path
  bool isDrawn_ = false;                     ///< a hand was drawn last
};

}  // namespace glissade
