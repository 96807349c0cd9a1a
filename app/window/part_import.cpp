#include "app/window/part_import.h"

#include "engine/scenario/scenario_io.h"

namespace glissade {

PartImport::PartImport(AssemblyDocument& document, WorkController& work, QWidget* window)
    : QObject(window), document_(document), work_(work), window_(window) {}

void PartImport::ask(PartsDialog::Purpose purpose, const QStringList& files) {
  PartsDialog dialog(purpose, files, false, window_);
  if (dialog.exec() == QDialog::Accepted) take(purpose, dialog.parts(), dialog.read());
}

void PartImport::take(PartsDialog::Purpose purpose, const std::vector<PartFile>& parts, const GeometryCache& read) {
  if (purpose == PartsDialog::Purpose::NewScenario) {
    work_.run(tr("Reading the parts"), [=](const WorkWatch& watch) { return makeScenario(parts, read, watch.stop); });
    return;
  }
  const Scenario scenario = document_.current();
  const std::string file = document_.scenario()->file;
  work_.run(tr("Reading the parts"), [=, known = document_.read()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    GeometryCache all = known;
    all.insert(read.begin(), read.end());
    const auto more = withParts(scenario, file, parts, &all, watch.stop);
    if (!more) return [this, why = more.error()] { emit failed(why); };
    return [this, parts, all] { add(parts, all); };
  });
}

/// On the worker's thread.
BackgroundTask::Delivery PartImport::makeScenario(const std::vector<PartFile>& parts, GeometryCache read,
                                                  const StopToken& stop) {
  auto scenario = scenarioOfParts(parts, &read, stop);
  if (!scenario) return [this, why = scenario.error()] { emit failed(why); };
  auto loaded = realiseScenario(std::move(*scenario), ".", "", read, stop);
  if (!loaded) return [this, why = loaded.error()] { emit failed(why); };
  const ScenarioPtr made = std::make_shared<LoadedScenario>(std::move(*loaded));
  return [this, made] { emit this->made(made); };
}

/// To the scenario as it is now: it may have been edited while the files were read.
void PartImport::add(const std::vector<PartFile>& parts, const GeometryCache& read) {
  GeometryCache known = read;
  document_.learn(read);
  auto more = withParts(document_.current(), document_.scenario()->file, parts, &known);
  const Outcome added = more ? document_.edit(tr("Add parts"), std::move(*more)) : Outcome(more.error());
  if (!added) emit failed(added.error());
}

}  // namespace glissade
