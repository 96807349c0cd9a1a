#include "app/window/path_report_job.h"

#include "app/window/report_file.h"
#include "engine/study/path_report.h"
#include "widgets/commands/length_text.h"
#include "widgets/commands/window_language.h"
#include "widgets/panels/sequence_panel.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// What is seen of the tightest place: a box with this half side, in radii of the object.
constexpr double kTightestSurroundings = 1.2;

/// Of the width of a page of paper.
constexpr double kPictureShare = 0.75;

std::string lengthWords(double metres) { return lengthText(metres).toStdString(); }

}  // namespace

void PathReportJob::start(const RunResults& results, const std::shared_ptr<const ClearanceProfile>& profile,
                          const std::optional<Pose>& shownPose, const QString& file, const Finished& finished) {
  shownPose_ = shownPose;
  if (!file.endsWith(QLatin1String(".html"), Qt::CaseInsensitive) &&
      !file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)) {
    finished(notSaved({ErrorKind::Usage, file.toStdString(), "", "the report of a path is written as .html or .pdf",
                       "Give a file name with one of these endings."}));
    return;
  }
  const auto folder = std::make_shared<QTemporaryDir>();
  const StudyWords words(windowLanguage());
  ReportPicture overview{folder->filePath(QStringLiteral("path.png")).toStdString(), words("The path"), kPictureShare};
  if (!saveScenePicture(bench_.scene, QString::fromStdString(overview.file))) overview = {};
  ReportPicture tightest{folder->filePath(QStringLiteral("tightest.png")).toStdString(),
                         words("The place with the smallest clearance"), kPictureShare};
  const auto place = profile ? profile->tightest() : std::nullopt;
  if (!place || !takeTightest(profile->samples[*place], tightest.file)) tightest = {};
  const ScenarioPtr scenario = bench_.document.scenario();
  bench_.work.run(tr("Writing the report"),
                  [results, profile, scenario, folder, overview, tightest, words, file,
                   finished](const WorkWatch&) -> BackgroundTask::Delivery {
                    const StudyReport report =
                        pathReport({*results.path, *scenario, results.provenance, profile.get(), overview, tightest},
                                   words, lengthWords);
                    const SaveResult written = saveReport(report, file);
                    return [finished, written] { finished(written); };
                  });
}

/// The camera and the object are as before afterwards.
SaveResult PathReportJob::takeTightest(const ClearanceSample& sample, const std::string& file) const {
  SceneView& view = bench_.scene.view();
  const CameraController before = view.camera();
  const double radius = kTightestSurroundings * bench_.document.scenario()->problem.world->objectRadius();
  view.setPlaybackPose(sample.q);
  view.camera().zoomTo(
      Box3(sample.q.position - Vector3::Constant(radius), sample.q.position + Vector3::Constant(radius)));
  const SaveResult taken = saveScenePicture(bench_.scene, QString::fromStdString(file));
  view.setPlaybackPose(shownPose_);
  view.camera() = before;
  bench_.scene.refresh();
  return taken;
}

}  // namespace glissade
