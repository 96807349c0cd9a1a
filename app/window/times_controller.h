#pragma once

#include "app/window/sequence_controller.h"
#include "app/window/workbench.h"

namespace glissade {

class TimesView;
class WindowMemory;

/// How long the plan that is shown takes people, in a window of its own, by a table of times that is edited there. The
/// window follows the plan and the table while it is open; the division over stations is found in the background.
class TimesController final : public QObject {
  Q_OBJECT

 public:
  TimesController(const Workbench& bench, SequenceController& sequence);

  void show();
  /// Made when it is asked for first.
  TimesView& view();
  WorkTimesStore& table() { return sequence_.workTimes(); }
  /// Takes the table from a file, or writes it; nothing on success.
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
  bool isOutdated_ = false;  ///< something else was asked for while the task was busy
};

}  // namespace glissade
