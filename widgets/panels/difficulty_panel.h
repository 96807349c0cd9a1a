#pragma once

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/planning/difficulty/difficulty.h"
#include "engine/planning/difficulty/help_places.h"
#include "engine/scenario/scenario.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/way_slider.h"

namespace glissade {

using DifficultyPtr = std::shared_ptr<const Difficulty>;
using HelpPlacesPtr = std::shared_ptr<const std::vector<HelpPlace>>;

/// Why no path was found: where the trees came nearest, the tightest passage that they reached, the
/// way of least penetration, and the places where a hand helps. A row shows the object at that place, the slider moves
/// it along the way.
class DifficultyPanel final : public QWidget {
  Q_OBJECT

 public:
  DifficultyPanel(const ActionCatalogue& actions, QWidget* parent);

  /// Null: nothing is known yet.
  void setDifficulty(const DifficultyPtr& difficulty, const HelpPlacesPtr& help, const LoadedScenario& scenario);
  /// Chooses the row "least", "tightest", "frontier" or "help-1", the first place to help. False: there is none.
  bool showPart(const QString& id);
  void setPlaying(bool playing) { slider_->setPlaying(playing); }

 signals:
  /// Lengths have another unit: what is shown has to be written again.
  void lengthUnitChanged();
  /// The pose to show the object at; nothing: the hand is shown again.
  void poseShown(const std::optional<glissade::Pose>& pose);
  void playbackEnded();
  /// The row of this place to help was chosen.
  void helpChosen(std::size_t place);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void addRow(const char* id, const QString& what, const QString& amount, int body, const Pose& q,
              const LoadedScenario& scenario);
  void describe(const Difficulty& difficulty, const LoadedScenario& scenario);
  void offer(const std::vector<HelpPlace>& help, const LoadedScenario& scenario);
  void choose(int row);

  std::vector<Pose> places_;  ///< of the rows
  int firstHelp_ = 0;         ///< row of the first place to help
  QLabel* summary_;
  QTreeWidget* rows_;
  WaySlider* slider_;
};

}  // namespace glissade
