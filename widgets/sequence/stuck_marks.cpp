#include "widgets/sequence/stuck_marks.h"

#include "widgets/controls/body_id_text.h"

namespace glissade {

StuckMarks::StuckMarks(SemanticDocument& semantics, SequencePanel& panel)
    : QObject(&panel), semantics_(semantics), panel_(panel) {
  connect(&panel, &SequencePanel::stuckChosen, this, &StuckMarks::show);
  connect(&panel, &SequencePanel::stepChosen, this, &StuckMarks::clear);
}

void StuckMarks::show(const QString& bodyId) {
  const AssemblyPlan& plan = *panel_.shown().plan;
  marked_ = {};
  marked_.bodies.insert(bodyId);
  for (const StuckBody& stuck : plan.stuck) {
    if (stuck.body != toBodyId(bodyId)) continue;
    for (const BodyId& other : stuck.blockedBy) marked_.bodies.insert(toQString(other));
  }
  panel_.showTime(static_cast<double>(plan.steps.size()));
  semantics_.select(marked_);
}

/// Clears the selection, unless a person has changed it.
void StuckMarks::clear() {
  if (!marked_.bodies.isEmpty() && semantics_.selection() == marked_) semantics_.select({});
  marked_ = {};
}

}  // namespace glissade
