#pragma once

#include <QDir>
#include <QShortcut>
#include <QTemporaryDir>

#include <optional>

#include "widgets/help/tour_panel.h"
#include "widgets/help/tour_steps.h"

namespace glissade {

/// Leads through the steps of the tour: shows the action of a step, marks its place, and goes on when the step is done,
/// by the person or by the tour.
class TourController final : public QObject {
  Q_OBJECT

 public:
  explicit TourController(const Workbench& bench);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const TourStep& step() const { return tourSteps()[*current_]; }
  void start();
  void go(std::optional<std::size_t> to);
  void next();
  void noteAction(const QString& id);
  /// Goes on if the step is done.
  void check();
  Outcome doStep();
  void markTarget();
  void addCommands();

  const Workbench& bench_;
  TourPanel* panel_;
  TourFrame* frame_;
  QShortcut* escape_;
  std::optional<std::size_t> current_;  ///< nothing: no tour
  bool isDone_ = false;                 ///< whether the current step is done
  QDir samples_;
  QTemporaryDir folder_;  ///< for files that the tour writes
};

/// The part of the window for an action (its button, or the menu that holds it) or for the widget with this object
/// name; empty if it is not visible.
QRect partOf(const QMainWindow& window, const ActionCatalogue& actions, const QString& target);

}  // namespace glissade
