#pragma once

#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <optional>

#include "app/window/film_job.h"
#include "app/window/workbench.h"
#include "engine/base/file_save.h"
#include "engine/planning/clearance_profile.h"
#include "engine/study/study_report.h"
#include "widgets/bridge/background_task.h"
#include "widgets/panels/path_panel.h"

namespace glissade {

class WindowMemory;

/// Writes the report of a path as HTML or PDF, by the ending of the file: with a picture of the scene as it is seen,
/// and one of the place with the smallest clearance. Pictures are taken at once; the file is written in the
/// background.
class PathReportJob final : public QObject {
  Q_OBJECT

 public:
  PathReportJob(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {}

  using Finished = std::function<void(const SaveResult&)>;
  /// `profile`: along the path; null: the report has no curve and one picture. `shownPose`: of the playback, which is
  /// shown again afterwards. Errors: those of writing; Usage for another ending.
  void start(const RunResults& results, const std::shared_ptr<const ClearanceProfile>& profile,
             const std::optional<Pose>& shownPose, const QString& file, const Finished& finished);

 private:
  SaveResult takeTightest(const ClearanceSample& sample, const std::string& file) const;

  const Workbench& bench_;
  std::optional<Pose> shownPose_;
};

/// The path that was found or given: shown, played, smoothed, read from files and written into them.
class PathController final : public QObject {
  Q_OBJECT

 public:
  explicit PathController(const Workbench& bench);

  PathPanel* panel() const { return panel_; }
  /// Takes the spacing of ghosts that is remembered; from now on it is kept there.
  void remember(WindowMemory& memory);
  /// Reads a path of the open scenario, which is then examined; nothing on success.
  std::optional<Diagnostic> open(const QString& file);
  /// The same; an error is shown in a dialog.
  void openOrShowError(const QString& file);
  /// Saves the path in the format of the file's ending; nothing on success.
  SaveResult exportTo(const QString& file);
  /// Writes the report of the path: HTML or PDF, by the ending.
  void reportTo(const QString& file, const PathReportJob::Finished& finished);
  /// Films the path as it is played: MP4, WebM or a series of pictures, by the ending.
  void filmTo(const QString& file, const FilmJob::Finished& finished);
  /// "none", "certified", or the id of the body that blocks it first ("-": its ends do not fit, or none is near).
  std::string verdict() const;

 private:
  void connectActions();
  /// Shows the results of the run that is shown.
  void show();
  void bringToFront();
  void showError(const Diagnostic& why);
  /// Measures the clearance along the path that is shown, in the background.
  void measureClearance();
  void chooseFile();
  void chooseExport();
  void chooseReport();
  void chooseFilm();
  void enableActions();

  const Workbench& bench_;
  PathPanel* panel_;
  RunResults results_;                               ///< that are shown
  std::shared_ptr<const ClearanceProfile> profile_;  ///< of the path that is shown; null: not measured yet
  std::optional<Pose> shownPose_;                    ///< of the playback; nothing: the object is where the hand has it
  BackgroundTask measuring_;
  PathReportJob report_;
  FilmJob film_;
};

}  // namespace glissade
