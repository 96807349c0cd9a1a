#include "app/window/path_controller.h"

#include <QFileDialog>

#include <utility>

#include "app/window/export_dialog.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "engine/scenario/path_exporter.h"
#include "engine/scenario/path_reader.h"

namespace glissade {
namespace {

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

PathController::PathController(SessionBridge& bridge, const ActionCatalogue& actions, SceneWidget& scene,
                               QWidget* window)
    : QObject(window), bridge_(bridge), actions_(actions), panel_(new PathPanel(actions, window)) {
  connect(panel_, &PathPanel::poseShown, this, [&scene](const std::optional<Pose>& pose) {
    scene.view().setPlaybackPose(pose);
    scene.refresh();
  });
  connect(panel_, &PathPanel::playbackEnded, this,
          [this] { actions_[QStringLiteral("path.play")]->setChecked(false); });
  connectActions();
  enableActions();
}

void PathController::connectActions() {
  connect(actions_[QStringLiteral("path.play")], &QAction::toggled, panel_, &PathPanel::setPlaying);
  connect(actions_[QStringLiteral("path.smooth")], &QAction::triggered, this,
          [this](bool smooth) { bridge_.post(command::SmoothPath{smooth ? kUsualShortcuts : 0}); });
  connect(actions_[QStringLiteral("path.first-blocked")], &QAction::triggered, this, [this] {
    emit found();
    panel_->showFirstBlocked();
  });
  connect(actions_[QStringLiteral("file.open-path")], &QAction::triggered, this, &PathController::chooseFile);
  connect(actions_[QStringLiteral("file.export")], &QAction::triggered, this, &PathController::chooseExport);
}

void PathController::chooseFile() {
  const QString file =
      QFileDialog::getOpenFileName(qobject_cast<QWidget*>(parent()), tr("Open a path of this scenario"), QString(),
                                   tr("Paths (%1);;All files (*)").arg(readablePatterns()));
  if (file.isEmpty()) return;
  if (const auto why = open(file)) emit failed(*why);
}

std::optional<Diagnostic> PathController::open(const QString& file) {
  const std::string name = file.toStdString();
  if (!bridge_.snapshot()) {
    return Diagnostic{ErrorKind::Usage, name, "", "there is no scenario that the path could be of",
                      "Open its scenario first."};
  }
  if (isRunning(*bridge_.snapshot())) {
    return Diagnostic{ErrorKind::Usage, name, "", "a path is being looked for", "Stop the run first."};
  }
  if (!live_) return Diagnostic{ErrorKind::Usage, name, "", "a recording is shown", "Close the replay first."};
  auto points = readPath(name);
  if (!points) return points.error();
  bridge_.givePath({withUnitRotations(std::move(*points)), {}});
  emit found();
  return std::nullopt;
}

void PathController::showSnapshot(const SnapshotPtr& snapshot, const ScenarioPtr& scenario, bool live) {
  const bool another = snapshot->path && (!snapshot_ || snapshot_->path != snapshot->path);
  const bool ofRun = snapshot->run > 0;
  snapshot_ = snapshot;
  scenario_ = scenario;
  live_ = live;
  panel_->setPath(snapshot->path, snapshot->refused, *scenario);
  enableActions();
  if (another && ofRun && !snapshot->coarsePlan) emit found();
}

void PathController::chooseExport() {
  ExportDialog dialog(makePathExporterRegistry(), qobject_cast<QWidget*>(parent()));
  if (dialog.exec() != QDialog::Accepted) return;
  const QString file = dialog.selectedFiles().front();
  if (const auto why = exportTo(file)) {
    emit failed(*why);
  } else {
    emit told(tr("The path was saved as %1").arg(file));
  }
}

std::optional<Diagnostic> PathController::exportTo(const QString& file) {
  if (!snapshot_ || !snapshot_->path) {
    return Diagnostic{ErrorKind::Usage, file.toStdString(), "", "there is no path to export", "Solve first."};
  }
  const Outcome written = writePath(*snapshot_->path, *scenario_, snapshot_->provenance, file.toStdString());
  if (!written) return written.error();
  return std::nullopt;
}

std::string PathController::verdict() const {
  if (snapshot_ && snapshot_->path) return "certified";
  if (!snapshot_ || !snapshot_->refused) return "none";
  const std::vector<BlockedEdge>& blocked = snapshot_->refused->blocked;
  const int body = blocked.empty() ? -1 : blocked.front().nearest.body;
  return body < 0 ? "-" : scenario_->obstacles[static_cast<std::size_t>(body)].id;
}

void PathController::enableActions() {
  const bool open = snapshot_ != nullptr;
  const bool path = open && snapshot_->path;
  const bool refused = open && snapshot_->refused;
  actions_[QStringLiteral("path.play")]->setEnabled(path || refused);
  actions_[QStringLiteral("path.smooth")]->setEnabled(live_ && path && !snapshot_->pathWork);
  actions_[QStringLiteral("path.smooth")]->setChecked(open && snapshot_->smoothed);
  actions_[QStringLiteral("path.first-blocked")]->setEnabled(refused && !snapshot_->refused->blocked.empty());
  actions_[QStringLiteral("file.export")]->setEnabled(path);
  actions_[QStringLiteral("file.open-path")]->setEnabled(live_ && !isRunning(*snapshot_));
}

}  // namespace glissade
