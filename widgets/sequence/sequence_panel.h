#pragma once

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSet>
#include <QWidget>

#include <optional>
#include <vector>

#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/play_slider.h"
#include "widgets/product/part_pictures.h"
#include "widgets/sequence/step_table.h"

namespace glissade {

/// The assembly plan: a table of its steps and of the stuck parts, a slider that plays the whole, a slider for the
/// exploded view, and a person's demands.
class SequencePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit SequencePanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  void setPlan(const ShownPlan& shown);
  /// The bodies whose motions are tried now, while the plan grows.
  void setTried(const std::vector<BodyId>& bodies);
  /// The cost of a step, as in SequenceDemands.
  void setCost(const std::string& cost);
  /// Pictures of parts are drawn before setPlan() returns, if set. It is off by default.
  void setAtOnce(bool atOnce) { atOnce_ = atOnce; }
  const ShownPlan& shown() const { return shown_; }
  void setOrder(PlanOrder order);
  PlanOrder order() const { return order_; }
  void setPlaying(bool playing);
  /// Time of removal, from 0 to the number of steps.
  double time() const { return timeAt(play_->share()); }
  /// The time at a share of the slider's range.
  double timeAt(double share) const;
  void showTime(double time);
  /// The slider that plays the sequence, for films.
  const PlaySlider& slider() const { return *play_; }
  double exploded() const { return explode_->share(); }
  void showExploded(double share) { explode_->showAt(share); }
  /// Makes the step's row the current one and shows the step; its index in the plan counts from 0. False if there is
  /// none.
  bool chooseStep(std::size_t step);
  /// Calls chooseStep() for the step this many rows below the shown one, if there is one.
  void stepBy(int rows);
  /// The place of the scene in the sequence: "Step 3 of 17: cover". Empty if there are no steps.
  QString placeText() const;
  /// How many parts leave, and how many are stuck.
  QString resultText() const;
  /// The names of the bodies that move in a step of the plan.
  QString partsText(std::size_t step) const {
    return QString::fromStdString(nameOfStep(shown_.plan->steps[step], *shown_.product));
  }
  /// The step, or the stuck part (its id), of the current row.
  std::optional<std::size_t> chosenStep() const { return StepTable::stepOf(table_->currentItem()); }
  BodyId chosenStuck() const { return StepTable::stuckOf(table_->currentItem()); }
  /// The first body of the current row; empty if there is none.
  BodyId chosenBody() const;
  /// Makes the row of the step in which the body leaves, or of the stuck body, the current one.
  void chooseBody(const BodyId& id);
  /// Goes to the first row about one of these bodies, which were selected elsewhere. The scene stays at its step.
  void showBodies(const QSet<QString>& ids);
  /// All selected steps, in the order of removal.
  std::vector<std::size_t> selectedSteps() const { return table_->selectedSteps(); }
  bool selectSteps(const std::vector<std::size_t>& steps);
  QString rowText(std::size_t step) const { return table_->textOf(step); }
  /// The menu of demands, which others fill before it opens.
  QMenu& demandsMenu() { return *demands_; }

 signals:
  /// A slider has moved: the scene has to show time() and exploded().
  void sceneChanged();
  void playbackEnded();
  /// The current row is that of a stuck part; this and the bodies that block it have to be shown.
  void stuckChosen(const QString& bodyId);
  /// A person has selected the row of this step (its index in the plan), which is shown.
  void stepChosen(int step);
  void selectionChanged();
  /// A person moves a step to the place of another one; indices in the plan.
  void stepMoved(int from, int to);
  /// The parts of the selected row must not leave in this direction: -x is "-x".
  void directionForbidden(const QString& axis);
  void costChosen(const QString& cost);

 private:
  void addEditing(const ActionCatalogue& actions);
  QLayout* makePlanningRow(const ActionCatalogue& actions);
  QLayout* makePlayingRow(const ActionCatalogue& actions);
  QLayout* makeExplodingRow();
  void chooseCost();
  void showRow(const QTreeWidgetItem* row);
  /// The row of the step that is shown; -1 before the first one.
  int shownRow() const;
  void markRow();
  QString leaving(const AssemblyPlan& plan) const;
  static QString stuckText(const AssemblyPlan& plan);
  QString summary() const;
  QString baseText() const;
  QString planningText() const;

  ShownPlan shown_;
  std::vector<BodyId> tried_;  ///< see setTried()
  PlanOrder order_ = PlanOrder::Assembly;
  QLabel* summary_;
  PartPictures pictures_;
  StepTable* table_;
  PlaySlider* play_;
  PlaySlider* explode_;
  QLabel* place_;
  QComboBox* cost_;
  QMenu* edits_;
  QMenu* demands_;
  bool atOnce_ = false;
};

}  // namespace glissade
