#pragma once

#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <optional>

#include "engine/base/file_save.h"
#include "engine/documents/report.h"
#include "engine/planning/clearance_profile.h"
#include "widgets/controls/background_task.h"
#include "widgets/film/film_job.h"
#include "widgets/paths/path_panel.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class WindowMemory;

/// Writes the report of a path as HTML or PDF, by the ending of the file. It has a picture of the scene with the
/// present camera, and one of the place with the smallest clearance. Pictures are taken at once; the file is written in
/// the background.
class PathReportJob final : public QObject {
  Q_OBJECT

 public:
  PathReportJob(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {}

  using Finished = std::function<void(const SaveResult&)>;
  /// `profile`: clearances along the path; null: the report has no curve and only one picture. `shownPose`: pose of the
  /// playback, which is restored afterwards. Errors: those of writing; Usage for another ending.
  void start(const RunResults& results, const std::shared_ptr<const ClearanceProfile>& profile,
             const std::optional<Pose>& shownPose, const QString& file, const Finished& finished);

 private:
  SaveResult takeTightest(const ClearanceSample& sample, const std::string& file) const;

  const Workbench& bench_;
  std::optional<Pose> shownPose_;
};

/// The path that was found or given: shows, plays, smooths, reads and writes it.
class PathController final : public QObject {
  Q_OBJECT

 public:
  explicit PathController(const Workbench& bench);

  PathPanel* panel() const { return panel_; }
  /// Restores the remembered spacing of ghosts, and remembers later choices.
  void remember(WindowMemory& memory);
  /// Reads a path of the open scenario, which the session then examines; returns nothing on success.
  std::optional<Diagnostic> open(const QString& file);
  /// Opens a path as open() does, and shows errors in a dialog.
  void openOrShowError(const QString& file);
  /// Saves the path in the format of the file's ending; the result holds no error on success.
  SaveResult exportTo(const QString& file);
  /// Writes the report of the path as HTML or PDF, by the ending.
  void reportTo(const QString& file, const PathReportJob::Finished& finished);
  /// Films the playback of the path as MP4, WebM or a series of pictures, by the ending.
  void filmTo(const QString& file, const FilmJob::Finished& finished);
  /// "none", "certified", or the id of the body that blocks the path first ("-": the path's ends do not fit, or no body
  /// is near).
  std::string verdict() const;

 private:
  void connectActions();
  /// Shows the results of the shown run.
  void show();
  void bringToFront();
  void showError(const Diagnostic& why);
  /// Measures the clearance along the shown path, in the background.
  void showNames();
  void measureClearance();
  void chooseFile();
  void chooseExport();
  void chooseReport();
  void chooseFilm();
  void enableActions();

  const Workbench& bench_;
  PathPanel* panel_;
  RunResults results_;                               ///< the shown results
  std::shared_ptr<const ClearanceProfile> profile_;  ///< clearances along the shown path; null: not measured yet
  std::optional<Pose> shownPose_;  ///< pose of the playback; nothing: the object is at its present pose
  BackgroundTask measuring_;
  PathReportJob report_;
  FilmJob film_;
};

}  // namespace glissade
