#include "widgets/product/part_import.h"

#include "engine/files/scenario_io.h"

namespace glissade {

PartImport::PartImport(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  connect(this, &PartImport::importFailed, this,
          [this](const Diagnostic& why) { bench_.messages.showError(tr("The parts cannot be added"), why); });
  bench.onAction("assembly.add", this, [this] { ask(PartsDialog::Purpose::AddParts); });
}

void PartImport::ask(PartsDialog::Purpose purpose, const QStringList& files) {
  PartsDialog dialog(purpose, files, false, &bench_.window);
  dialog.setFolder(bench_.dialogs.folderOf(FilePurpose::Parts));
  if (dialog.exec() != QDialog::Accepted) return;
  const std::vector<PartFile> parts = dialog.parts();
  if (!parts.empty()) bench_.dialogs.noteFile(FilePurpose::Parts, QString::fromStdString(parts.back().path));
  take(purpose, parts, dialog.read());
}

void PartImport::take(PartsDialog::Purpose purpose, const std::vector<PartFile>& parts, const GeometryCache& read) {
  if (purpose == PartsDialog::Purpose::NewScenario) {
    bench_.work.run(tr("Reading the parts"),
                    [=, this](const WorkWatch& watch) { return makeScenario(parts, read, watch.stop); });
    return;
  }
  const Scenario scenario = bench_.document.current();
  const std::string file = bench_.document.scenario()->file;
  bench_.work.run(tr("Reading the parts"),
                  [=, this, known = bench_.document.geometry()](const WorkWatch& watch) -> BackgroundTask::Delivery {
                    GeometryCache all = known;
                    all.insert(read.begin(), read.end());
                    const auto more = withParts(scenario, file, parts, &all, watch.stop);
                    if (!more) return [this, why = more.error()] { emit importFailed(why); };
                    return [this, parts, all] { add(parts, all); };
                  });
}

/// Reads the parts on the worker's thread.
BackgroundTask::Delivery PartImport::makeScenario(const std::vector<PartFile>& parts, GeometryCache read,
                                                  const StopToken& stop) {
  auto scenario = scenarioOfParts(parts, &read, stop);
  if (!scenario) return [this, why = scenario.error()] { emit importFailed(why); };
  auto loaded = loadGeometry(std::move(*scenario), ".", "", read, stop, nullptr, FindFits::LaterIfLarge);
  if (!loaded) return [this, why = loaded.error()] { emit importFailed(why); };
  const ScenarioPtr made = std::make_shared<LoadedScenario>(std::move(*loaded));
  return [this, made] { emit scenarioMade(made); };
}

/// Adds parts to the present scenario, which may have been edited while the files were read.
void PartImport::add(const std::vector<PartFile>& parts, const GeometryCache& read) {
  bench_.document.addGeometry(read);
  const auto addParts = [this, parts, known = read](Scenario& scenario) mutable -> Outcome {
    auto more = withParts(scenario, bench_.document.scenario()->file, parts, &known);
    if (!more) return more.error();
    scenario = std::move(*more);
    return Done{};
  };
  const Outcome added = bench_.document.edit(tr("Add parts"), addParts);
  if (!added) emit importFailed(added.error());
}

}  // namespace glissade
