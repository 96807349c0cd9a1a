#pragma once

#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <optional>

#include "app/window/workbench.h"
#include "engine/base/file_save.h"
#include "engine/planning/clearance_profile.h"
#include "engine/study/study_report.h"

namespace glissade {

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

}  // namespace glissade
