#include "widgets/studies/study_controller.h"

#include <QCryptographicHash>
#include <QDesktopServices>
#include <QStandardPaths>
#include <QUrl>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/files/scenario_file.h"
#include "engine/study/study_page.h"
#include "widgets/controls/window_language.h"
#include "widgets/studies/study_batch.h"
#include "widgets/workbench/workbench.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// Adds the script commands about studies.
void addStudyCommands(const Workbench& bench, StudyController& studies) {
  ScriptCommands& scripts = bench.scripts;
  scripts.add("study", 1,
              [&studies](const Words& words) { return outcomeOf(studies.open(QString::fromStdString(words[0]))); });
  scripts.add("study-run", 2, [&studies](const Words& words) -> Outcome {
    if (studies.folder().isEmpty()) return wrongCommand("no study is open");
    const auto cell = toNumber(words[0]);
    const auto seed = toNumber(words[1]);
    if (!cell || !seed || *cell < 1.0) return wrongCommand("give the numbers of a cell and a seed");
    const QString name = QStringLiteral("/runs/cell%1-seed%2.json")
                             .arg(static_cast<qulonglong>(*cell))
                             .arg(static_cast<qulonglong>(*seed));
    return outcomeOf(studies.openRun(studies.folder() + name));
  });
  scripts.add("study-pictures", 1, [&bench, &studies](const Words& words) {
    return outcomeOf(takeStudyPictures(QString::fromStdString(words[0]), bench, studies));
  });
}

std::optional<double> nodesOf(const RunOutcome& outcome) {
  for (std::size_t i = 0; i < kResultColumnCount; ++i) {
    if (resultColumns()[i].name == "nodes") return outcome.result.numbers[i];
  }
  return std::nullopt;
}

/// The folder for the page of results that cannot be written: one of the caches of the user.
QString folderOfPage(const QString& folder) {
  if (QFileInfo(folder).isWritable()) return folder;
  const QByteArray hash = QCryptographicHash::hash(folder.toUtf8(), QCryptographicHash::Sha256).toHex().left(16);
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/studies/") +
         QString::fromLatin1(hash);
}

Result<std::string> writePage(const QString& folder, const QString& pdf, Warnings& warnings, const StopToken& stop) {
  const auto study = StudyFolder::open(folder.toStdString());
  if (!study) return study.error();
  const PageOptions options{folderOfPage(folder).toStdString(), pdf.toStdString(), windowLanguage()};
  return writeStudyPage(*study, options, warnings, stop);
}

}  // namespace

StudyController::StudyController(const Workbench& bench, FileController& files)
    : QObject(&bench.window), bench_(bench), files_(files) {
  bench.onAction("study.open", this, [this] { choose(); });
  bench.onAction("study.open-run", this, [this] { chooseRun(); });
  bench.onAction("study.report-pdf", this, [this] { choosePdf(); });
  bench.enable("study.report-pdf", false);
  connect(&files, &FileController::runOfStudyChosen, this, &StudyController::askAndOpenRun);
  connect(&bench.session, &SessionBridge::snapshotChanged, this, &StudyController::watch);
  addStudyCommands(bench, *this);
}

void StudyController::choose() {
  const QString folder = bench_.dialogs.openFolder(FilePurpose::Study, tr("Open the results of a study"));
  if (!folder.isEmpty()) writeInBackground(folder, {});
}

void StudyController::chooseRun() {
  const QString file =
      bench_.dialogs.open(FilePurpose::Study, tr("Open a run of a study"), tr("Runs of studies (cell*.json)"));
  if (!file.isEmpty()) askAndOpenRun(file);
}

void StudyController::choosePdf() {
  const QString file = bench_.dialogs.save(FilePurpose::Report, tr("Write the report"),
                                           folder_ + QStringLiteral("/report.pdf"), tr("Documents (*.pdf)"));
  if (!file.isEmpty()) writeInBackground(folder_, file);
}

void StudyController::writeInBackground(const QString& folder, const QString& pdf) {
  bench_.work.run(tr("Writing the page of the study"),
                  [this, folder, pdf](const WorkWatch& watch) -> BackgroundTask::Delivery {
                    Warnings warnings;
                    const auto page = writePage(folder, pdf, warnings, watch.stop);
                    return [this, folder, page, warnings] {
                      if (!page) return bench_.messages.showError(tr("The page cannot be written"), page.error());
                      showPage(folder, QString::fromStdString(*page));
                      if (warnings.empty()) return;
                      bench_.messages.showError(tr("The page was written, with a warning"), warnings.front());
                    };
                  });
}

void StudyController::showPage(const QString& folder, const QString& page) {
  folder_ = folder;
  bench_.enable("study.report-pdf", true);
  bench_.messages.showSaved(tr("The page is %1").arg(page), page);
  if (!bench_.work.isAtOnce()) QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(page).absoluteFilePath()));
}

std::optional<Diagnostic> StudyController::open(const QString& folder) {
  Warnings warnings;
  const auto page = writePage(folder, {}, warnings, {});
  if (!page) return page.error();
  showPage(folder, QString::fromStdString(*page));
  return std::nullopt;
}

void StudyController::askAndOpenRun(const QString& file) {
  if (files_.mayDiscard()) openRun(file, false);
}

std::optional<Diagnostic> StudyController::openRun(const QString& file, bool quiet) {
  const auto why = startRunOf(file);
  if (why && !quiet) bench_.messages.showError(tr("The run cannot be shown"), *why);
  return why;
}

std::optional<Diagnostic> StudyController::startRunOf(const QString& file) {
  shown_.reset();
  auto opened = openStudyRun(file.toStdString());
  if (!opened) return opened.error();
  if (const auto why = startRun(opened->folder, opened->run)) return why;
  bench_.messages.showStatus(tr("Seed %1 of the study is running.").arg(opened->run.seed));
  shown_ = std::move(*opened);
  return std::nullopt;
}

std::optional<Diagnostic> StudyController::startRun(const StudyFolder& folder, const StudyRun& run) {
  const StudyCell& cell = folder.plan().study.cells[run.cell];
  if (isSequence(cell)) {
    return Diagnostic{ErrorKind::Usage, "", cell.label,
                      GLISSADE_TEXT("is a run of a sequence, which is not shown as a path"),
                      GLISSADE_TEXT("Open its scenario and plan the sequence with this seed.")};
  }
  const auto file = folder.scenarioFile(cell);
  if (!file) return file.error();
  const auto loaded = loadScenario(*file);
  if (!loaded) return loaded.error();
  if (sha256(scenarioText(loaded->scenario)) != cell.scenarioSha256) {
    return Diagnostic{ErrorKind::MalformedInput, *file, "",
                      GLISSADE_TEXT("the scenario has changed since the study was made"),
                      GLISSADE_TEXT("Put the old one back, or make the study again.")};
  }
  if (const auto why = files_.openScenario(QString::fromStdString(*file), true)) return why;
  ParameterValues parameters = loaded->parameters;
  for (const auto& [id, value] : cell.parameters) {
    const Outcome set = parameters.set(id, value);
    if (!set) return set.error();
  }
  bench_.bringToFront(Workspace::Study, "panel.run");
  bench_.session.startFixed({parameters, cell.strategy, run.seed, cell.operatorName});
  return std::nullopt;
}

std::optional<bool> StudyController::isAsInStudy(const RunOutcome& known) const {
  const SnapshotPtr snapshot = bench_.session.snapshot();
  const auto nodes = nodesOf(known);
  if (!snapshot || isRunning(*snapshot) || !nodes || dependsOnMachine(known.result.status)) return std::nullopt;
  return static_cast<double>(snapshot->counts.nodes) == *nodes;
}

void StudyController::watch(const SnapshotPtr& snapshot) {
  if (!shown_ || isRunning(*snapshot) || snapshot->run == 0) return;
  if (const auto same = isAsInStudy(shown_->outcome)) {
    const QString text = *same ? tr("Seed %1 ended as in the study: %2 nodes.")
                               : tr("Seed %1 ended differently from the study: %2 nodes. Is this another version of "
                                    "Glissade?");
    bench_.messages.showStatus(text.arg(shown_->run.seed).arg(snapshot->counts.nodes));
  }
  shown_.reset();
}

}  // namespace glissade
