#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/window/workbench.h"
#include "widgets/panels/step_table.h"

namespace glissade {

class SequenceController;

/// A step by hand: what leaves in a step, a part or a group, in the hand, among the parts that are there at that step,
/// as a run like any other. The scenario of the run is a temporary one; its first certified path is smoothed, because a
/// fitter makes no detours, and becomes the motion of the step, and the temporary scenario ends.
class SequenceHand final : public QObject {
  Q_OBJECT

 public:
  SequenceHand(const Workbench& bench, SequenceController& sequence);

  bool isActive() const { return run_.has_value(); }
  /// The document has the scenario of the run, or is about to have it.
  bool isAway() const { return run_.has_value() && !goingBack_; }

 private:
  struct Run {
    ShownPlan plan;                   ///< that the parts are moved in
    std::vector<std::string> bodies;  ///< ids; the first one names the step
    std::optional<std::size_t> step;  ///< of the plan; nothing: the part was stuck
    bool begun = false;               ///< the document has the run's scenario
    bool smoothing = false;           ///< its path is smoothed
  };

  void begin();
  void noteBegun();
  void followDocument(Changes what);
  void followPath();
  void followUndo();
  void takePath();
  /// Ends the scenario of the run; then `then` is called.
  void goBack(const std::function<void()>& then);
  void enableActions();

  const Workbench& bench_;
  SequenceController& sequence_;
  /// What moves, for people.
  QString nameOf(const Run& run) const;
  /// The document has the bodies of the run as its object.
  bool hasObject() const;

  std::optional<Run> run_;
  bool goingBack_ = false;
};

}  // namespace glissade
