#include "widgets/paths/sweep_controller.h"

#include <QLocale>

#include "engine/base/volume_unit.h"
#include "engine/files/swept_volume_file.h"
#include "engine/sweep/swept_bodies.h"
#include "widgets/controls/length_text.h"
#include "widgets/workbench/proposed_file.h"

namespace glissade {
namespace {

constexpr double kLargeExcess =
    0.10;  ///< share of the volume; the usual swept volume has less excess unless memory is too small

}  // namespace

SweepController::SweepController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  connect(&bench.run, &ShownRun::changed, this, &SweepController::followPath);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & (Change::Results | Change::Scenario | Change::Arrangement)) followPath();
  });
  bench_.onAction("path.sweep", this, [this](bool wanted) { show(wanted); });
  bench_.onAction("path.export-sweep", this, [this] { chooseExport(); });
  enableActions();
  addCommands();
}

std::shared_ptr<const Path> SweepController::path() const {
  if (bench_.run.isLive()) return bench_.document.results().path;
  const SnapshotPtr& snapshot = bench_.run.snapshot();
  return snapshot ? snapshot->path : nullptr;
}

void SweepController::followPath() {
  if (path() == followed_) return;
  followed_ = path();
  shown_ = {};
  show(false);
  enableActions();
}

void SweepController::compute(const std::function<void()>& then) {
  const auto path = this->path();
  const ScenarioPtr scenario = bench_.document.scenario();
  if (!path || !scenario) return;
  if (shown_.path == path) {
    then();
    return;
  }
  const auto work = [this, path, scenario, then](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const TriangleMesh& object = *scenario->object.mesh;
    const std::vector<Pose> poses = path->configurations();
    auto sweep = std::make_shared<Result<SweptVolume>>(usualSweptVolume(object, poses, watch));
    QStringList bodies;
    if (*sweep) {
      for (const std::size_t body : bodiesWithin(**sweep, scenario->obstacles, watch.stop)) {
        bodies << QString::fromStdString(scenario->obstacles[body].shown());
      }
    }
    return [this, path, sweep, bodies, then] {
      if (path != this->path()) return;
      if (!*sweep) {
        bench_.messages.showError(tr("The swept volume cannot be computed"), sweep->error());
        show(false);
        return;
      }
      shown_ = {path, std::make_shared<const SweptVolume>(std::move(**sweep)), bodies};
      then();
    };
  };
  bench_.work.run(tr("Computing the swept volume"), work);
}

void SweepController::show(bool shown) {
  bench_.actions["path.sweep"]->setChecked(shown);
  if (!shown) {
    bench_.scene.view().setSweep(nullptr);
    bench_.scene.refresh();
    return;
  }
  compute([this] {
    bench_.scene.view().setSweep(shown_.sweep);
    bench_.scene.refresh();
    tell();
  });
}

void SweepController::tell() {
  const SweptVolume& sweep = *shown_.sweep;
  const VolumeUnit unit = volumeUnitFor(sweep.volume);
  QString text = tr("Swept volume: %1 %2; its surface is at most %3 away from the object")
                     .arg(QLocale().toString(sweep.volume * unit.perCubicMetre, 'g', 3), QString::fromUtf8(unit.name),
                          lengthText(sweep.bound));
  if (sweep.excess > kLargeExcess) {
    text += tr("; a closer surface takes too much memory: the volume may be more than %1 % too large")
                .arg(static_cast<int>(1e2 * kLargeExcess));
  }
  if (!shown_.bodies.empty()) {
    text += tr("; within it or at its surface: %1").arg(shown_.bodies.join(QStringLiteral(", ")));
  }
  bench_.messages.showStatus(text);
}

void SweepController::chooseExport() {
  compute([this] {
    const QString file = bench_.dialogs.save(
        FilePurpose::Export, tr("Export the swept volume"),
        proposedFile(*bench_.document.scenario(), QStringLiteral("swept-volume.stl")),
        tr("Triangles in millimetres (%1);;3D viewers (%2)").arg(QStringLiteral("*.stl"), QStringLiteral("*.glb")));
    if (file.isEmpty()) return;
    if (const Outcome saved = exportTo(file); !saved) {
      bench_.messages.showError(tr("The swept volume was not saved"), saved.error());
    }
  });
}

Outcome SweepController::exportTo(const QString& file) {
  const RigidBody& object = bench_.document.scenario()->object;
  Warnings warnings;
  const Outcome saved =
      saveSweptVolume(*shown_.sweep, "Swept volume of " + object.name, object.colour, file.toStdString(), warnings);
  if (!saved) return saved;
  if (warnings.empty()) {
    bench_.messages.showSaved(tr("The swept volume was saved as %1").arg(file), file);
  } else {
    bench_.messages.showError(tr("The swept volume was saved, with a warning"), warnings.front());
  }
  return saved;
}

void SweepController::enableActions() {
  const bool hasPath = path() != nullptr;
  bench_.enable("path.sweep", hasPath);
  bench_.enable("path.export-sweep", hasPath);
}

void SweepController::addCommands() {
  bench_.scripts.add("export-sweep", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    if (!path()) return wrongCommand("there is no path whose swept volume could be exported", "Solve first.");
    compute([] {});
    if (!shown_.sweep) return unmetExpectation("the swept volume was not computed");
    return exportTo(QString::fromStdString(words[0]));
  });
}

}  // namespace glissade
