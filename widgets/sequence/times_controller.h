#pragma once

#include "widgets/sequence/sequence_controller.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class TimesView;
class WindowMemory;

/// Shows how long the shown plan takes people, in its own window, by a table of times that can be edited there. The
/// open window follows the plan and the table; the division over stations is computed in the background.
class TimesController final : public QObject {
  Q_OBJECT

 public:
  TimesController(const Workbench& bench, SequenceController& sequence);

  void show();
  /// The window, which the first call makes.
  TimesView& view();
  WorkTimesStore& table() { return sequence_.workTimes(); }
  /// Reads the table from a file, or writes it; both return nothing on success.
  std::optional<Diagnostic> openTable(const QString& file);
  std::optional<Diagnostic> saveTable(const QString& file);

 private:
  void makeView();
  void update();
  void divide(const PlanPtr& plan, const ProductPtr& product);
  void enableAction();
  void chooseFile();
  void chooseTarget();

  const Workbench& bench_;
  SequenceController& sequence_;
  TimesView* view_ = nullptr;
  BackgroundTask task_;
  bool isOutdated_ = false;  ///< a later request came while the task was busy
};

}  // namespace glissade
