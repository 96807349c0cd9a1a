#pragma once

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSet>
#include <QWidget>

#include <optional>
#include <vector>

#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/part_pictures.h"
#include "widgets/panels/play_slider.h"
#include "widgets/panels/step_table.h"

namespace glissade {

/// The assembly plan: its steps and the parts that are stuck as a table, a slider that plays the whole, and a slider
/// for the exploded view, and what a person demands of it.
class SequencePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit SequencePanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  void setPlan(const ShownPlan& shown);
  /// Shown in place of the summary; empty: the summary.
  void setNotice(const QString& notice);
  /// What a step costs, as in SequenceDemands.
  void setCost(const std::string& cost);
  /// Pictures of parts are drawn before setPlan() returns. At first they are not.
  void setAtOnce(bool atOnce) { atOnce_ = atOnce; }
  const ShownPlan& shown() const { return shown_; }
  void setOrder(PlanOrder order);
  PlanOrder order() const { return order_; }
  void setPlaying(bool playing);
  /// Of removal: from 0 to the number of steps.
  double time() const { return timeAt(play_->share()); }
  /// Of a share of the slider's way.
  double timeAt(double share) const;
  void showTime(double time);
  /// For films: what playing shows (PlaySlider).
  const PlaySlider& slider() const { return *play_; }
  double exploded() const { return explode_->share(); }
  void showExploded(double share) { explode_->showAt(share); }
  /// Makes the step's row the current one and shows the step; counted in the plan, from 0. False: there is none.
  bool chooseStep(std::size_t step);
  /// The same for the step so many rows below what is shown, where there is one.
  void stepBy(int rows);
  /// Where the scene is in the sequence: "Step 3 of 17: cover". Empty where there are no steps.
  QString placeText() const;
  /// The names of what moves in a step of the plan.
  QString partsText(std::size_t step) const { return table_->shortNames(shown_.plan->steps[step].bodies()); }
  /// The step, or the stuck part (its id), of the current row.
  std::optional<std::size_t> chosenStep() const { return StepTable::stepOf(table_->currentItem()); }
  std::string chosenStuck() const { return StepTable::stuckOf(table_->currentItem()); }
  /// Of the current row, the first one of a step; empty where there is none.
  std::string chosenBody() const;
  /// Makes the row of the step that the body leaves in, or of the stuck body, the current one.
  void chooseBody(const std::string& id);
  /// Goes to the first row about one of these bodies, which were chosen elsewhere. The scene stays at its step.
  void showBodies(const QSet<QString>& ids);
  /// All that are selected, in the order of removal.
  std::vector<std::size_t> selectedSteps() const { return table_->selectedSteps(); }
  bool selectSteps(const std::vector<std::size_t>& steps);
  QString rowText(std::size_t step) const { return table_->textOf(step); }
  /// What is demanded: filled by others before it opens.
  QMenu& demandsMenu() { return *demands_; }

 signals:
  /// The sliders have moved: time() and exploded() are what is to be shown.
  void sceneChanged();
  void playbackEnded();
  /// The current row is another one; a stuck part and who blocks it are to be shown.
  void stuckChosen(const QString& bodyId);
  /// A person has chosen the row of this step (its index in the plan); it is shown.
  void stepChosen(int step);
  void selectionChanged();
  /// A person wants the step where the other one is; indices in the plan.
  void stepMoved(int from, int to);
  /// The parts of the chosen row are not to leave in this direction: -x is "-x".
  void directionForbidden(const QString& axis);
  void costChosen(const QString& cost);

 private:
  void addEditing(const ActionCatalogue& actions);
  QLayout* makePlanningRow(const ActionCatalogue& actions);
  QLayout* makePlayingRow(const ActionCatalogue& actions);
  QLayout* makeExplodingRow();
  void chooseCost();
  void showRow(const QTreeWidgetItem* row);
  /// Of the step that is shown; -1 before the first one.
  int shownRow() const;
  void markRow();
  static QString leaving(const AssemblyPlan& plan);
  QString summary() const;

  ShownPlan shown_;
  PlanOrder order_ = PlanOrder::Removal;
  QLabel* summary_;
  PartPictures pictures_;
  StepTable* table_;
  PlaySlider* play_;
  PlaySlider* explode_;
  QLabel* place_;
  QComboBox* cost_;
  QMenu* edits_;
  QMenu* demands_;
  QString notice_;
  bool atOnce_ = false;
};

}  // namespace glissade
