// What the main window takes from files, and what it writes into them.
#include <QDragEnterEvent>
#include <QMimeData>

#include "app/window/assembly_controller.h"
#include "app/window/environment_controller.h"
#include "app/window/main_window.h"
#include "app/window/part_import.h"
#include "app/window/path_controller.h"
#include "app/window/window_memory.h"
#include "app/window/work_controller.h"
#include "engine/scenario/asset_path.h"
#include "engine/scenario/path_reader.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {

std::optional<Diagnostic> MainWindow::openScenario(const QString& file, bool quiet) {
  if (!quiet && !mayDiscard()) return std::nullopt;
  return takeScenario(loadScenario(file.toStdString()), file, quiet);
}

void MainWindow::openInBackground(const QString& file) {
  work_->run(tr("Opening the scenario"), [this, file](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const auto loaded = std::make_shared<const Result<LoadedScenario>>(loadScenario(file.toStdString(), watch.stop));
    // Asked now, because there may have been edits meanwhile.
    return [this, loaded, file] {
      if (!*loaded || mayDiscard()) (void)takeScenario(*loaded, file, false);
    };
  });
}

std::optional<Diagnostic> MainWindow::takeScenario(Result<LoadedScenario> loaded, const QString& file, bool quiet) {
  if (!loaded) {
    if (!quiet) showError(tr("The scenario cannot be opened"), loaded.error());
    return loaded.error();
  }
  openLoaded(std::make_shared<const LoadedScenario>(std::move(*loaded)));
  if (memory_) memory_->noteFile(file);
  if (!quiet && !scenario_->warnings.empty()) {
    showError(tr("The scenario was opened, with a warning"), scenario_->warnings.front());
  }
  return std::nullopt;
}

std::optional<Diagnostic> MainWindow::saveScenarioAs(const QString& file) {
  const std::string name = file.toStdString();
  Scenario scenario = movedTo(name, scenario_->scenario, scenario_->file);
  setSemanticEdits(environment_->document().edits(), scenario);
  scenario.environment = environment_->options();
  const SnapshotPtr live = bridge_->snapshot();  // not what a replay shows
  scenario.planner = live->plannerId;
  scenario.seed = live->seed;
  for (const ParameterSpec& spec : parameterTable()) {
    if (live->parameters[spec.id] != scenario_->parameters[spec.id]) {
      scenario.parameters[spec.id] = live->parameters[spec.id];
    }
  }
  const Outcome saved = saveScenario(scenario, name);
  if (!saved) return saved.error();
  auto now = std::make_shared<LoadedScenario>(*scenario_);
  now->scenario = std::move(scenario);
  now->file = name;
  now->parameters = live->parameters;
  scenario_ = std::move(now);
  assembly_->show(scenario_);
  if (memory_) memory_->noteFile(file);
  environment_->document().undoStack().setClean();
  showTitle();
  return std::nullopt;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList parts;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (isPartFile(url.toLocalFile().toStdString())) parts << url.toLocalFile();
  }
  const QString first = event->mimeData()->urls().front().toLocalFile();
  if (isPathFile(first.toStdString())) {
    if (const auto why = path_->open(first)) showError(tr("This cannot be done with the path"), *why);
  } else if (parts.isEmpty()) {
    openInBackground(first);
  } else if (scenario_) {
    parts_->ask(PartsDialog::Purpose::AddParts, parts);
  } else {
    newScenario(parts);
  }
}

}  // namespace glissade
