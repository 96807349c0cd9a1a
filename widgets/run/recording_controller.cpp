#include "widgets/run/recording_controller.h"

#include <QFile>
#include <QMessageBox>
#include <QPushButton>

#include "engine/files/run_journal.h"
#include "engine/files/run_record.h"
#include "widgets/workbench/proposed_file.h"

namespace glissade {

RecordingController::RecordingController(const Workbench& bench, ReplayController& replay, FileController& files)
    : QObject(&bench.window), bench_(bench), replay_(replay), files_(files) {
  bench.onAction("file.open-recording", this, [this] { chooseFile(); });
  bench.onAction("file.save-recording", this, [this] { chooseSaveFile(); });
  bench.scripts.add("replay", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const SnapshotPtr live = bench_.session.snapshot();
    if (live && isRunning(*live)) return wrongCommand("a run is under way");
    return outcomeOf(open(readRunRecord(words[0]), QString::fromStdString(words[0]), true));
  });
}

std::optional<Diagnostic> RecordingController::open(const Result<RunRecord>& record, const QString& file, bool quiet) {
  const auto openOther = [this, quiet](const QString& scenario) { return files_.openScenario(scenario, quiet); };
  const auto why = record ? replay_.open(*record, file, openOther) : std::optional<Diagnostic>(record.error());
  if (why && !quiet) bench_.messages.showError(tr("The recording cannot be opened"), *why);
  const auto loss = why ? std::nullopt : lossWarning(*record, file.toStdString());
  if (loss && !quiet) bench_.messages.showError(tr("The recording is damaged"), *loss);
  return why;
}

void RecordingController::chooseFile() {
  const QString file = bench_.dialogs.open(FilePurpose::Recording, tr("Open a recording"),
                                           tr("Recordings (*.json *.journal);;All files (*)"));
  if (file.isEmpty()) return;
  bench_.work.run(tr("Reading the recording"), [this, file](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const auto record = std::make_shared<const Result<RunRecord>>(readRunRecord(file.toStdString(), watch));
    return [this, record, file] {
      const SnapshotPtr live = bench_.session.snapshot();
      if (live && isRunning(*live)) {
        bench_.messages.showStatus(tr("A run has begun meanwhile: open the recording after it."));
      } else {
        open(*record, file, false);
      }
    };
  });
}

void RecordingController::chooseSaveFile() {
  const QString file = bench_.dialogs.save(FilePurpose::Recording, tr("Save the recording"),
                                           proposedFile(*bench_.document.scenario(), QStringLiteral("run.json")),
                                           tr("Recordings (*.json)"));
  if (file.isEmpty()) return;
  const SaveResult saved = replay_.save(file);
  showOutcome(saved);
  if (saved) bench_.messages.showStatus(tr("The recording was saved as %1").arg(file));
  if (saved && !bench_.document.isProblemSaved()) {
    QMessageBox::information(&bench_.window, tr("The recording was saved"),
                             tr("It names the scenario's file, which does not have the bodies as they are here. Save "
                                "the scenario, too: only then can the recording be replayed."));
  }
}

/// Shows errors and warnings of a save.
void RecordingController::showOutcome(const SaveResult& saved) {
  if (!saved) bench_.messages.showError(tr("The recording cannot be saved"), saved.why);
  if (saved.warnings.empty()) return;
  bench_.messages.showError(tr("The recording was saved, with a warning"), saved.warnings.front());
}

void RecordingController::keepJournals(const QString& folder) {
  std::vector<JournalSave> saves;
  for (const std::string& file : abandonedJournals(folder.toStdString())) {
    const QString journal = QString::fromStdString(file);
    const QString target = offerJournal(journal);
    if (!target.isEmpty()) saves.emplace_back(journal, target);
  }
  if (!saves.empty()) saveJournals(saves);
  replay_.recorder().keepJournals(folder.toStdString());
}

QString RecordingController::offerJournal(const QString& file) {
  QMessageBox box(QMessageBox::Question, tr("A recording was not saved"),
                  tr("Glissade ended unexpectedly with a recording that was not saved. It is still there."),
                  QMessageBox::NoButton, &bench_.window);
  const auto* saved = box.addButton(tr("&Save..."), QMessageBox::AcceptRole);
  const auto* discarded = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("&Later"), QMessageBox::RejectRole);
  box.exec();
  if (box.clickedButton() == discarded) QFile::remove(file);
  if (box.clickedButton() != saved) return {};
  return bench_.dialogs.save(FilePurpose::Recording, tr("Save the recording"), QStringLiteral("run.json"),
                             tr("Recordings (*.json)"));
}

/// Saves journals as recordings. If this is cancelled, the journal stays and is offered again at the next start.
void RecordingController::saveJournals(const std::vector<JournalSave>& saves) {
  bench_.work.runToEnd(tr("Saving the recording"), [this, saves](const WorkWatch& watch) -> BackgroundTask::Delivery {
    std::vector<SaveResult> results;
    results.reserve(saves.size());
    for (const auto& [journal, target] : saves) {
      results.push_back(saveJournal(journal.toStdString(), target.toStdString(), watch));
    }
    return [this, results] {
      for (const SaveResult& saved : results) showOutcome(saved);
    };
  });
}

}  // namespace glissade
