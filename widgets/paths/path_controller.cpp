#include "widgets/paths/path_controller.h"

#include <cmath>
#include <utility>

#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "engine/documents/path_report.h"
#include "engine/files/path_exporter.h"
#include "engine/files/path_reader.h"
#include "engine/planning/clearance_profile.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "widgets/controls/length_text.h"
#include "widgets/controls/window_language.h"
#include "widgets/film/film_dialog.h"
#include "widgets/instruction/report_file.h"
#include "widgets/paths/export_dialog.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/workbench/proposed_file.h"
#include "widgets/workbench/script_commands.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {
namespace {

/// Half side of the box that the picture of the tightest place shows, in radii of the object.
constexpr double kTightestSurroundings = 1.2;

/// Share of the width of a page.
constexpr double kPictureShare = 0.75;

std::string lengthWords(double metres) { return lengthText(metres).toStdString(); }

/// Sets the ghosts from "none", a number, or a length with its unit.
Outcome setGhosts(PathController& path, const std::string& word) {
  PathSpacing spacing = path.panel()->ghosts().spacing();
  const auto number = toNumber(word);
  const auto distance = toMetres(word, 1e-3);
  if (word == "none") {
    spacing.by = PathSpacing::By::None;
  } else if (number && *number >= 1 && *number <= kMostPathPoses && *number == std::floor(*number)) {
    spacing.by = PathSpacing::By::Number;
    spacing.number = static_cast<int>(*number);
  } else if (!number && distance && *distance > 0.0) {
    spacing.by = PathSpacing::By::Distance;
    spacing.distance = *distance;
  } else {
    return wrongCommand("these are no ghosts", "Say none, a number, or a length such as 25mm.");
  }
  path.panel()->ghosts().setSpacing(spacing);
  return Done{};
}

/// Adds the script commands about the path that was found or given.
void addPathCommands(ScriptCommands& scripts, PathController& path) {
  using Words = ScriptCommands::Words;
  scripts.add("export", 1,
              [&path](const Words& words) { return outcomeOf(path.exportTo(QString::fromStdString(words[0]))); });
  scripts.add("report-path", 1, [&path](const Words& words) -> Outcome {
    SaveResult result;
    path.reportTo(QString::fromStdString(words[0]), [&result](const SaveResult& saved) { result = saved; });
    return outcomeOf(result);
  });
  scripts.add("film-path", 1, [&path](const Words& words) -> Outcome {
    SaveResult result;
    path.filmTo(QString::fromStdString(words[0]), [&result](const SaveResult& saved) { result = saved; });
    return outcomeOf(result);
  });
  scripts.add("open-path", 1,
              [&path](const Words& words) { return outcomeOf(path.open(QString::fromStdString(words[0]))); });
  scripts.add("expect-path", 1, [&path](const Words& words) -> Outcome {
    const std::string found = path.verdict();
    if (found == words[0]) return Done{};
    return unmetExpectation("the path is '" + found + "', not '" + words[0] + "'");
  });
  scripts.add("ghosts", 1, [&path](const Words& words) { return setGhosts(path, words[0]); });
}

/// Number of samples of the path's clearance for the curve.
constexpr std::size_t kProfileSamples = 400;

/// "*.csv *.json"
QString readablePatterns() {
  QStringList patterns;
  const PathExporterRegistry formats = makePathExporterRegistry();
  for (const PathExporter& format : formats.entries()) {
    if (format.readBackError) patterns << patternsOf(format);
  }
  return patterns.join(QLatin1Char(' '));
}

}  // namespace

void PathReportJob::start(const RunResults& results, const std::shared_ptr<const ClearanceProfile>& profile,
                          const std::optional<Pose>& shownPose, const QString& file, const Finished& finished) {
  shownPose_ = shownPose;
  if (!file.endsWith(QLatin1String(".html"), Qt::CaseInsensitive) &&
      !file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive)) {
    finished(notSaved({ErrorKind::Usage, file.toStdString(), "",
                       GLISSADE_TEXT("the report of a path is written as .html or .pdf"),
                       GLISSADE_TEXT("Give a file name with one of these endings.")}));
    return;
  }
  const auto folder = std::make_shared<QTemporaryDir>();
  const DocumentWords words(windowLanguage());
  ReportPicture overview{folder->filePath(QStringLiteral("path.png")).toStdString(), words(GLISSADE_TEXT("The path")),
                         kPictureShare};
  if (!saveScenePicture(bench_.scene, QString::fromStdString(overview.file))) overview = {};
  ReportPicture tightest{folder->filePath(QStringLiteral("tightest.png")).toStdString(),
                         words(GLISSADE_TEXT("The place with the smallest clearance")), kPictureShare};
  const auto place = profile ? profile->tightest() : std::nullopt;
  if (!place || !takeTightest(profile->samples[*place], tightest.file)) tightest = {};
  const ScenarioPtr scenario = bench_.document.scenario();
  bench_.work.run(tr("Writing the report"),
                  [results, profile, scenario, folder, overview, tightest, words, file,
                   finished](const WorkWatch&) -> BackgroundTask::Delivery {
                    const Report report =
                        pathReport({*results.path, *scenario, results.provenance, profile.get(), overview, tightest},
                                   words, lengthWords);
                    const SaveResult written = saveReport(report, file);
                    return [finished, written] { finished(written); };
                  });
}

/// Takes the picture of the tightest place, and restores the camera and the object's pose.
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

PathController::PathController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      panel_(new PathPanel(bench.actions, &bench.window)),
      report_(bench, nullptr),
      film_(
          bench.work, [&bench] { return bench.scene.picture(kFilmPicture); }, bench.scene.view().camera()) {
  connect(panel_, &PathPanel::poseShown, this, [this](const std::optional<Pose>& pose) {
    if (pose && bench_.actions["path.follow"]->isChecked()) {
      bench_.scene.view().camera().follow(bench_.scene.view().objectPose().position, pose->position);
    }
    shownPose_ = pose;
    bench_.scene.view().setPlaybackPose(pose);
    bench_.scene.refresh();
  });
  connect(panel_, &PathPanel::playbackEnded, this, [this] { bench_.actions["path.play"]->setChecked(false); });
  connect(panel_, &PathPanel::lengthUnitChanged, this, [this] {
    if (bench_.document.scenario()) panel_->showTexts(*bench_.document.scenario());
  });
  connect(&measuring_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(&bench.run, &ShownRun::changed, this, &PathController::show);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & (Change::Results | Change::Arrangement)) show();
    if ((what & Change::Arrangement) && bench_.run.snapshot()) showNames();
  });
  connect(&panel_->ghosts(), &GhostRow::changed, this, [this](const PathSpacing& spacing) {
    bench_.scene.view().setGhosts(spacing);
    bench_.scene.refresh();
  });
  connectActions();
  enableActions();
  addPathCommands(bench.scripts, *this);
}

void PathController::remember(WindowMemory& memory) {
  panel_->ghosts().setSpacing(memory.ghosts());
  connect(&panel_->ghosts(), &GhostRow::changed, this,
          [&memory](const PathSpacing& spacing) { memory.saveGhosts(spacing); });
}

void PathController::connectActions() {
  connect(bench_.actions["path.play"], &QAction::toggled, panel_, &PathPanel::setPlaying);
  bench_.onAction("path.smooth", this,
                  [this](bool smooth) { bench_.session.post(command::SmoothPath{smooth ? kUsualShortcuts : 0}); });
  bench_.onAction("path.first-blocked", this, [this] {
    bringToFront();
    panel_->showFirstBlocked();
  });
  bench_.onAction("path.tightest", this, [this] {
    bringToFront();
    panel_->showTightest();
  });
  bench_.onAction("file.open-path", this, [this] { chooseFile(); });
  bench_.onAction("file.export", this, [this] { chooseExport(); });
  bench_.onAction("path.report", this, [this] { chooseReport(); });
  bench_.onAction("path.film", this, [this] { chooseFilm(); });
}

/// The path of a step by hand belongs to the sequence, which stays in front.
void PathController::bringToFront() {
  if (!bench_.document.isTemporary()) bench_.bringToFront(Workspace::Planning, "panel.path");
}

void PathController::showError(const Diagnostic& why) {
  bench_.messages.showError(tr("Not possible with this path"), why);
}

void PathController::chooseFile() {
  const QString file = bench_.dialogs.open(FilePurpose::Path, tr("Open a path of this scenario"),
                                           tr("Paths (%1);;All files (*)").arg(readablePatterns()));
  if (!file.isEmpty()) openOrShowError(file);
}

void PathController::openOrShowError(const QString& file) {
  if (const auto why = open(file)) showError(*why);
}

std::optional<Diagnostic> PathController::open(const QString& file) {
  const std::string name = file.toStdString();
  const SnapshotPtr live = bench_.session.snapshot();
  if (!live) {
    return Diagnostic{ErrorKind::Usage, name, "", GLISSADE_TEXT("no scenario is open"),
                      GLISSADE_TEXT("Open its scenario first.")};
  }
  if (isRunning(*live)) {
    return Diagnostic{ErrorKind::Usage, name, "", GLISSADE_TEXT("a run is going on"),
                      GLISSADE_TEXT("Stop the run first.")};
  }
  if (!bench_.run.isLive()) {
    return Diagnostic{ErrorKind::Usage, name, "", GLISSADE_TEXT("a recording is shown"),
                      GLISSADE_TEXT("Close the replay first.")};
  }
  auto points = readPath(name);
  if (!points) return points.error();
  bench_.document.whenArranged([this, given = withUnitRotations(std::move(*points))] {
    bench_.session.givePath({given, {}});
    bringToFront();
  });
  return std::nullopt;
}

void PathController::show() {
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  if (!snapshot) return;
  const RunResults replayed{snapshot->path, snapshot->refused, snapshot->provenance, snapshot->smoothed};
  const RunResults results = bench_.run.isLive() ? bench_.document.results() : replayed;
  const bool isOther = results.path != results_.path;
  const bool isNew = results.path && isOther;
  if (isOther) film_.cancel();
  results_ = results;
  panel_->setPath(results.path, results.refused, *bench_.document.scenario());
  enableActions();
  if (isOther) measureClearance();
  if (isNew && snapshot->run > 0 && !snapshot->coarsePlan) bringToFront();
}

/// Shows the names that bodies have now. The path is one of the present arrangement.
void PathController::showNames() {
  panel_->showTexts(*bench_.document.scenario());
  if (profile_) panel_->setProfile(profile_, *bench_.document.scenario());
}

void PathController::measureClearance() {
  measuring_.cancel();
  profile_.reset();
  bench_.scene.view().setPathProfile(nullptr);
  if (!results_.path) return;
  const ScenarioPtr scenario = bench_.document.scenario();
  const auto measure = [this, scenario, path = results_.path](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const auto query = scenario->problem.world->makeQuery();
    auto profile = std::make_shared<const ClearanceProfile>(
        clearanceProfile(*query, path->configurations(), scenario->problem.metric(), kProfileSamples, watch));
    return [this, scenario, profile] {
      profile_ = profile;
      panel_->setProfile(profile, *scenario);
      bench_.scene.view().setPathProfile(profile);
      bench_.scene.refresh();
    };
  };
  measuring_.start(GLISSADE_TEXT("measuring the clearance along the path"), measure, bench_.work.isAtOnce());
}

void PathController::chooseExport() {
  ExportDialog dialog(makePathExporterRegistry(), &bench_.window);
  dialog.propose(proposedFile(*bench_.document.scenario(), QStringLiteral("path")));
  dialog.setDirectory(bench_.dialogs.folderOf(FilePurpose::Export));
  if (dialog.exec() != QDialog::Accepted) return;
  const QString file = dialog.selectedFiles().front();
  bench_.dialogs.noteFile(FilePurpose::Export, file);
  const SaveResult saved = exportTo(file);
  if (!saved) {
    showError(saved.why);
  } else if (!saved.warnings.empty()) {
    bench_.messages.showError(tr("The path was saved, with a warning"), saved.warnings.front());
  } else {
    bench_.messages.showSaved(tr("The path was saved as %1").arg(file), file);
  }
}

SaveResult PathController::exportTo(const QString& file) {
  if (!results_.path) {
    return notSaved({ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("there is no path to export"),
                     GLISSADE_TEXT("Solve first.")});
  }
  SaveResult saved = writePath(*results_.path, *bench_.document.scenario(), results_.provenance, file.toStdString());
  if (saved) bench_.document.noteExported(results_.path);
  return saved;
}

void PathController::chooseReport() {
  const QString file =
      bench_.dialogs.save(FilePurpose::Report, tr("Write the report of the path"),
                          proposedFile(*bench_.document.scenario(), QStringLiteral("path-report.html")),
                          tr("Web page (*.html);;PDF (*.pdf)"));
  if (file.isEmpty()) return;
  reportTo(file, [this, file](const SaveResult& saved) {
    if (!saved) return showError(saved.why);
    bench_.messages.showSaved(tr("The report was saved as %1").arg(file), file);
  });
}

void PathController::reportTo(const QString& file, const PathReportJob::Finished& finished) {
  if (!results_.path) {
    finished(notSaved({ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("there is no path to report"),
                       GLISSADE_TEXT("Solve first.")}));
    return;
  }
  report_.start(results_, profile_, shownPose_, file, finished);
}

void PathController::chooseFilm() {
  const QString file = chooseFilmFile(bench_, tr("Film the path"), QStringLiteral("path"));
  if (file.isEmpty()) return;
  filmTo(file, [this, file](const SaveResult& saved) {
    if (saved) return bench_.messages.showSaved(tr("The film was saved as %1").arg(file), file);
    if (saved.why.kind != ErrorKind::Interrupted) return showError(saved.why);
    bench_.messages.showStatus(tr("The film was cancelled"));
  });
}

void PathController::filmTo(const QString& file, const FilmJob::Finished& finished) {
  if (!results_.path) {
    finished(notSaved({ErrorKind::Usage, file.toStdString(), "", GLISSADE_TEXT("there is no path to film"),
                       GLISSADE_TEXT("Solve first.")}));
    return;
  }
  bench_.actions["path.play"]->setChecked(false);
  SceneView& view = bench_.scene.view();
  FilmSubject subject;
  subject.seconds = panel_->slider().playedSeconds();
  subject.show = [this, &view, before = view.objectPose()](double share) mutable {
    const WaySlider& slider = panel_->slider();
    const std::optional<Pose> pose = slider.poseAt(slider.playedShare(share));
    if (!pose) return;
    if (bench_.actions["path.follow"]->isChecked()) view.camera().follow(before.position, pose->position);
    view.setPlaybackPose(pose);
    before = *pose;
  };
  subject.restore = [this, &view] { view.setPlaybackPose(shownPose_); };
  film_.start(std::move(subject), file, finished);
}

std::string PathController::verdict() const {
  if (results_.path) return "certified";
  if (!results_.refused) return "none";
  const std::vector<BlockedEdge>& blocked = results_.refused->blocked;
  const int body = blocked.empty() ? -1 : blocked.front().nearest.body;
  return body < 0 ? "-" : bench_.document.scenario()->obstacles[static_cast<std::size_t>(body)].id.text();
}

void PathController::enableActions() {
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  const bool live = snapshot && bench_.run.isLive();
  const bool path = results_.path != nullptr;
  const bool refused = results_.refused != nullptr;
  bench_.enable("path.play", path || refused);
  bench_.enable("path.smooth", live && path && !snapshot->pathWork);
  bench_.actions["path.smooth"]->setChecked(results_.smoothed);
  bench_.enable("path.tightest", path);
  bench_.enable("path.first-blocked", refused && !results_.refused->blocked.empty());
  bench_.enable("file.export", path);
  bench_.enable("path.report", path);
  bench_.enable("path.film", path);
  bench_.enable("file.open-path", live && !isRunning(*snapshot));
}

}  // namespace glissade
