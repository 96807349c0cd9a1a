#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>

#include <memory>
#include <optional>

#include "engine/files/scenario.h"
#include "engine/planning/path_examination.h"
#include "engine/planning/path_spacing.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/author_bar.h"
#include "widgets/controls/quantity_box.h"
#include "widgets/controls/way_slider.h"
#include "widgets/paths/clearance_curve.h"

namespace glissade {

/// Spacing of the ghosts of the object along the path: none, a number of them, or a distance in millimetres.
class GhostRow final : public QWidget {
  Q_OBJECT

 public:
  explicit GhostRow(QWidget* parent);

  const PathSpacing& spacing() const { return spacing_; }
  /// Sets and announces the spacing.
  void setSpacing(const PathSpacing& spacing);

 signals:
  void changed(const glissade::PathSpacing& spacing);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void connectWidgets();
  void showUnit();
  void showSpacing();

  PathSpacing spacing_;
  double perMetre_ = 1e3;
  QComboBox* by_;
  QSpinBox* number_;
  QuantityBox* distance_;
};

/// The present path: its certificate or its obstruction, its figures, its clearance as a curve, and a slider that moves
/// the object along it.
class PathPanel final : public QWidget {
  Q_OBJECT

 public:
  PathPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  GhostRow& ghosts() { return *ghosts_; }
  /// Null pointers: there is no path.
  void setPath(const std::shared_ptr<const Path>& path, const std::shared_ptr<const PathExamination>& refused,
               const LoadedScenario& scenario);
  /// Writes all texts again.
  void showTexts(const LoadedScenario& scenario);
  /// The clearance along the path that is shown; null: not known yet.
  void setProfile(const std::shared_ptr<const ClearanceProfile>& profile, const LoadedScenario& scenario);
  void setPlaying(bool playing);
  /// The slider that plays the path, for films.
  const WaySlider& slider() const { return *slider_; }
  void showAt(double share) { slider_->showAt(share); }
  void showFirstBlocked();
  /// Shows the object at the place of the smallest clearance.
  void showTightest();

 signals:
  /// The unit of lengths has changed, so that the texts have to be written again.
  void lengthUnitChanged();
  /// The pose to show, or nothing when playback is over and the operator's pose is shown again.
  void poseShown(const std::optional<glissade::Pose>& pose);
  void playbackEnded();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showFigures(const Path& path, const Se3Metric& metric);
  QHBoxLayout* makePlaybackRow(const ActionCatalogue& actions);

  std::shared_ptr<const Path> path_;
  std::shared_ptr<const PathExamination> refused_;
  QLabel* certificate_;
  QLabel* figures_;
  QWidget* sharesTitle_;
  AuthorBar* shares_;
  ClearanceCurve* curve_;
  WaySlider* slider_;
  QComboBox* speed_;
  GhostRow* ghosts_;
};

}  // namespace glissade
