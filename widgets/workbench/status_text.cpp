#include "widgets/workbench/status_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "engine/planning/fine/coarse_preview.h"
#include "widgets/controls/diagnostic_text.h"

namespace glissade {
namespace {

QString say(const char* text) { return QCoreApplication::translate("Status", text); }

/// The present phase of a multi-layer planner.
QString layersText(const CoarsePlanPtr& plan) {
  if (!plan) return say(QT_TRANSLATE_NOOP("Status", "Planning: finding the places"));
  for (std::size_t i = 0; i < plan->steps.size(); ++i) {
    const TopologicalStep& step = plan->steps[i];
    if (step.result != StepResult::Running) continue;
    if (step.place == TopologicalStep::kWholeWorkspace) {
      return say(QT_TRANSLATE_NOOP("Status", "Planning: searching the whole workspace"));
    }
    return say(QT_TRANSLATE_NOOP("Status", "Planning: step %1 of %2, place %3 is crossed"))
        .arg(i + 1)
        .arg(plan->steps.size())
        .arg(QString::fromStdString(step.placeName));
  }
  return say(QT_TRANSLATE_NOOP("Status", "Planning: milestones in the borders"));
}

}  // namespace

QString statusText(const SessionSnapshot& snapshot) {
  if (snapshot.problem) {
    const Diagnostic& why = *snapshot.problem;
    if (toString(why.location) == "start") {
      return say(QT_TRANSLATE_NOOP("Status", "The start pose cannot be used: see the message over the scene."));
    }
    if (toString(why.location) == "goal") {
      return say(QT_TRANSLATE_NOOP("Status", "The goal pose cannot be used: see the message over the scene."));
    }
    const QString place = why.location.empty() ? QString() : engineText(why.location) + QStringLiteral(": ");
    return place + diagnosticText(why);
  }
  switch (snapshot.state) {
    case SessionState::Idle:
      if (snapshot.refused) {
        return say(
            QT_TRANSLATE_NOOP("Status", "The path is no longer valid: see Path. Find path (F5) looks for another."));
      }
      return say(QT_TRANSLATE_NOOP("Status", "Ready. Press Find path (F5), or steer with the keys."));
    case SessionState::Planning:
      if (snapshot.waitsForHand) {
        return say(QT_TRANSLATE_NOOP("Status", "At the start: the run begins when you move the object."));
      }
      if (snapshot.contactMode) {
        return say(QT_TRANSLATE_NOOP("Status", "Planning: sampling on the nearest obstacle's tangent plane"));
      }
      return isMultiLayer(snapshot.plannerId) ? layersText(snapshot.coarsePlan)
                                              : say(QT_TRANSLATE_NOOP("Status", "Planning: growing two trees"));
    case SessionState::Paused: return say(QT_TRANSLATE_NOOP("Status", "Paused"));
    case SessionState::Solved:
      if (snapshot.run == 0)
        return say(QT_TRANSLATE_NOOP("Status", "The path is valid: certified free of penetration"));
      return say(QT_TRANSLATE_NOOP("Status", "✓ Path found: certified free of penetration. Play shows it."));
    case SessionState::Stopped: return say(QT_TRANSLATE_NOOP("Status", "Stopped. Results kept."));
    case SessionState::Failed: return say(QT_TRANSLATE_NOOP("Status", "Failed"));
  }
  return {};
}

QString elapsedText(const SessionSnapshot& snapshot) {
  const QString seconds = QLocale().toString(snapshot.virtualSeconds, 'f', 1);
  const double limit = snapshot.parameters[ParameterId::TimeLimit];
  if (limit <= 0.0) return seconds + QStringLiteral(" s");
  return say(QT_TRANSLATE_NOOP("Status", "%1 s of %2 s")).arg(seconds, QLocale().toString(limit, 'g', 6));
}

}  // namespace glissade
