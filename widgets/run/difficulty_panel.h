#pragma once

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/files/scenario.h"
#include "engine/planning/difficulty/difficulty.h"
#include "engine/planning/difficulty/help_places.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/way_slider.h"

namespace glissade {

using DifficultyPtr = std::shared_ptr<const Difficulty>;
using HelpPlacesPtr = std::shared_ptr<const std::vector<HelpPlace>>;

/// The reasons why no path was found: the place where the trees came nearest, the tightest passage that they reached,
/// the path of least penetration, and the places where a hand helps. A row shows the object at its place, the slider
/// moves it along the path of least penetration.
class DifficultyPanel final : public QWidget {
  Q_OBJECT

 public:
  DifficultyPanel(const ActionCatalogue& actions, QWidget* parent);

  /// Null: no difficulty is known yet.
  void setDifficulty(const DifficultyPtr& difficulty, const HelpPlacesPtr& help, const LoadedScenario& scenario);
  /// Selects the row "least", "tightest", "frontier" or "help-1", the first place to help. False if there is none.
  bool showPart(const QString& id);
  void setPlaying(bool playing) { slider_->setPlaying(playing); }

 signals:
  /// The unit of lengths has changed, so that the texts have to be written again.
  void lengthUnitChanged();
  /// The pose to show the object at; nothing: the operator's pose is shown again.
  void poseShown(const std::optional<glissade::Pose>& pose);
  void playbackEnded();
  /// The row of this place to help was selected.
  void helpChosen(std::size_t place);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void addRow(const char* id, const QString& what, const QString& amount, int body, const Pose& q,
              const LoadedScenario& scenario);
  void describe(const Difficulty& difficulty, const LoadedScenario& scenario);
  void offer(const std::vector<HelpPlace>& help, const LoadedScenario& scenario);
  void choose(int row);

  std::vector<Pose> places_;  ///< poses of the rows
  int firstHelp_ = 0;         ///< row of the first place to help
  QLabel* summary_;
  QTreeWidget* rows_;
  WaySlider* slider_;
};

}  // namespace glissade
