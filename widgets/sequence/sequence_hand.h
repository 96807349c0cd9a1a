#pragma once

#include <optional>
#include <string>
#include <vector>

#include "widgets/controls/notice_bar.h"
#include "widgets/sequence/step_table.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class SequenceController;

/// Moves the bodies of a step by hand, among the parts present at that step, as an ordinary run. The scenario of the
/// run is temporary. The first certified path is smoothed, because an assembler makes no detours. It then becomes the
/// motion of the step, and the temporary scenario ends.
class SequenceHand final : public QObject {
  Q_OBJECT

 public:
  SequenceHand(const Workbench& bench, SequenceController& sequence);

  bool isActive() const { return run_.has_value(); }
  /// Whether the document has the scenario of the run, or will get it.
  bool isAway() const { return run_.has_value() && !goingBack_; }

 signals:
  /// A run by hand has begun or ended.
  void activityChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Run {
    ShownPlan plan;                   ///< the plan of the moved parts
    std::vector<BodyId> bodies;       ///< the first one names the step
    std::optional<std::size_t> step;  ///< index in the plan; nothing: the part was stuck
    bool begun = false;               ///< the document has the scenario of the run
    bool smoothing = false;           ///< the path is being smoothed
    std::string strategy{};           ///< before the run
  };

  void begin();
  void noteBegun();
  void followDocument(Changes what);
  void followPath();
  void followUndo();
  void takePath();
  /// Ends the scenario of the run and then calls `then`.
  void goBack(const std::function<void()>& then);
  void enableActions();

  /// Takes the part in the person's hand, with a strategy that uses it.
  void takeInHand();
  void showBanner();
  /// Ends the run, whose scenario has ended.
  void end();
  /// Name of the moved bodies for people.
  QString nameOf(const Run& run) const;
  /// Whether the document's object consists of the bodies of the run.
  bool hasObject() const;

  const Workbench& bench_;
  SequenceController& sequence_;
  NoticeBar* banner_;
  std::optional<Run> run_;
  bool goingBack_ = false;
};

}  // namespace glissade
