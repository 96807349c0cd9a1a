#pragma once

#include <QLabel>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/planning/path.h"
#include "engine/scenario/scenario.h"
#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/author_bar.h"
#include "widgets/panels/way_slider.h"

namespace glissade {

/// The path found: its certificate and figures, and a slider that moves the object along it.
class PathPanel final : public QWidget {
  Q_OBJECT

 public:
  PathPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Null: there is no path.
  void setPath(const std::shared_ptr<const Path>& path, const LoadedScenario& scenario);
  void setPlaying(bool playing);

 signals:
  /// The pose to show, or nothing when playback is over and the hand is shown again.
  void poseShown(const std::optional<glissade::Pose>& pose);
  void playbackEnded();

 private:
  std::shared_ptr<const Path> path_;
  QLabel* certificate_;
  QLabel* figures_;
  QWidget* sharesTitle_;
  AuthorBar* shares_;
  WaySlider* slider_;
};

}  // namespace glissade
