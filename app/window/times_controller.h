#pragma once

#include "app/window/sequence_controller.h"
#include "app/window/workbench.h"

namespace glissade {

class TimesView;

/// How long the plan that is shown takes people, in a window of its own. It follows the plan while it is open; the
/// division over stations is found in the background.
class TimesController final : public QObject {
  Q_OBJECT

 public:
  TimesController(const Workbench& bench, const SequenceController& sequence);

 private:
  void show();
  void update();
  void divide(const PlanPtr& plan, const ProductPtr& product);
  void enableAction();
  void addCommands();

  const Workbench& bench_;
  const SequenceController& sequence_;
  TimesView* view_ = nullptr;
  BackgroundTask task_;
  bool isOutdated_ = false;  ///< something else was asked for while the task was busy
};

}  // namespace glissade
