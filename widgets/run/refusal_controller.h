#pragma once

#include "engine/files/end_conflicts.h"
#include "widgets/controls/background_task.h"
#include "widgets/controls/notice_bar.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Shows over the scene why a run was refused or ended without a path, or why a path does not hold: the reason, the
/// bodies (marked in the scene) with their overlap, and possible actions.
class RefusalController final : public QObject {
  Q_OBJECT

 public:
  explicit RefusalController(const Workbench& bench);

  const NoticeBar& bar() const { return *bar_; }
  /// The conflicts marked in the scene; null: none.
  const std::shared_ptr<const EndConflicts>& conflicts() const { return conflicts_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connectActions();
  void showAgain();
  void followRun(const SnapshotPtr& snapshot);
  void followDocument(Changes what);
  /// Finds all bodies that the object meets at its ends, in the background.
  void examineEnds();
  void takeConflicts(const std::optional<EndConflicts>& found);
  void showProblem(const SessionSnapshot& snapshot);
  void showConflicts();
  void showRefusedPath(const PathExamination& refused);
  void mark(std::shared_ptr<const EndConflicts> conflicts);
  void zoomToConflicts();
  void allowAsFits();
  void close();
  void enableActions();
  void addCommands();

  const Workbench& bench_;
  NoticeBar* bar_;
  std::shared_ptr<const EndConflicts> conflicts_;
  BackgroundTask examination_;
  QString noticed_;  ///< text of the snapshot's last problem, so that it is shown only once
};

}  // namespace glissade
