#pragma once

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

#include <optional>
#include <vector>

#include "engine/study/plan_words.h"
#include "widgets/bridge/sequence_planner.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/play_slider.h"

namespace glissade {

/// What the panel shows of an assembly plan.
struct ShownPlan {
  ProductPtr product;  ///< null: there is none
  PlanPtr plan;        ///< null: not planned yet
  bool growing = false;
  std::vector<std::optional<double>> foundAfter;  ///< seconds, of each step; nothing: not found here
  std::vector<StepCheck> checks;                  ///< of each step; empty: not asked
};

/// The assembly plan: its steps and the parts that are stuck as a table, a slider that plays the whole, and a slider
/// for the exploded view.
class SequencePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit SequencePanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  void setPlan(const ShownPlan& shown);
  const ShownPlan& shown() const { return shown_; }
  void setOrder(PlanOrder order);
  PlanOrder order() const { return order_; }
  void setPlaying(bool playing);
  /// Of removal: from 0 to the number of steps.
  double time() const;
  void showTime(double time);
  /// For films: what playing shows (PlaySlider).
  const PlaySlider& slider() const { return *play_; }
  void showPlayed(double share) { play_->showPlayed(share); }
  double exploded() const { return explode_->share(); }
  void showExploded(double share) { explode_->showAt(share); }
  /// Makes the step's row the current one and shows the step; counted in the plan, from 0. False: there is none.
  bool chooseStep(std::size_t step);
  /// The step, or the stuck part (its id), of the current row.
  std::optional<std::size_t> chosenStep() const;
  std::string chosenStuck() const;

 signals:
  /// The sliders have moved: time() and exploded() are what is to be shown.
  void sceneChanged();
  void playbackEnded();
  /// The current row is another one; a stuck part and who blocks it are to be shown.
  void stuckChosen(const QString& bodyId);

 private:
  void addSteps();
  void addStuck();
  void showRow(QTreeWidgetItem* row);
  void markRow();
  QString summary() const;
  QString nameOf(const std::string& id) const;
  QString allNames(const std::vector<std::string>& ids) const;
  QString shortNames(const std::vector<std::string>& ids) const;
  PlanWords planWords() const;

  ShownPlan shown_;
  PlanOrder order_ = PlanOrder::Removal;
  QLabel* summary_;
  QTreeWidget* table_;
  PlaySlider* play_;
  PlaySlider* explode_;
  QLabel* place_;
};

/// The language that the window has been opened in.
Language windowLanguage();

}  // namespace glissade
