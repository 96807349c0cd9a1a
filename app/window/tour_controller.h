#pragma once

#include <QDir>
#include <QShortcut>
#include <QTemporaryDir>

#include <optional>

#include "app/window/tour_panel.h"
#include "app/window/tour_steps.h"

namespace glissade {

/// Leads through the steps of the tour: shows what to do, marks where, and goes on when a step was done, whoever did
/// it.
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
  /// Goes on where the step has become done.
  void check();
  Outcome doStep();
  void markTarget();
  void addCommands();

  const Workbench& bench_;
  TourPanel* panel_;
  TourFrame* frame_;
  QShortcut* escape_;
  std::optional<std::size_t> current_;  ///< none: no tour
  bool isDone_ = false;                 ///< the current step
  QDir samples_;
  QTemporaryDir folder_;  ///< of what the tour writes
};

/// The part of the window that stands for an action (its button, or the menu that holds it) or that a widget of this
/// object name covers; empty where it is not to be seen.
QRect partOf(const QMainWindow& window, const ActionCatalogue& actions, const QString& target);

}  // namespace glissade
