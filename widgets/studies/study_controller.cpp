#include "widgets/studies/study_controller.h"

#include <QTabWidget>

#include <array>

#include "engine/base/file.h"
#include "engine/base/number_text.h"
#include "engine/files/scenario_file.h"
#include "widgets/controls/picture_file.h"
#include "widgets/controls/window_language.h"
#include "widgets/instruction/report_pdf.h"
#include "widgets/plots/plot_view.h"
#include "widgets/studies/study_batch.h"
#include "widgets/studies/study_browser.h"
#include "widgets/workbench/workbench.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// The index of the word, from 0; -1 if the word is no number from 1.
int indexOf(const std::string& word) {
  const auto number = toNumber(word);
  return number ? static_cast<int>(*number) - 1 : -1;
}

Outcome selectCell(StudyBrowser& browser, const std::string& word) {
  if (browser.selectCell(indexOf(word))) return Done{};
  return wrongCommand("there is no cell " + word);
}

Outcome selectPlot(StudyBrowser& browser, const std::string& word) {
  auto* plots = browser.findChild<QTabWidget*>();
  const int index = indexOf(word);
  if (index < 0 || index >= plots->count()) return wrongCommand("there is no plot " + word);
  plots->setCurrentIndex(index);
  return Done{};
}

Outcome savePlot(StudyBrowser& browser, const std::string& file) {
  const PlotView* plot = browser.plot();
  if (plot == nullptr) return wrongCommand("no plot is shown", "Open a study.");
  return outcomeOf(plot->save(QString::fromStdString(file)));
}

Outcome saveBrowser(StudyBrowser& browser, const std::string& file) {
  return outcomeOf(savePicture(browser.grab().toImage(), QString::fromStdString(file)));
}

Outcome zoom(StudyBrowser& browser, const Words& words) {
  std::array<double, 4> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto number = toNumber(words[i]);
    if (!number) return wrongCommand("'" + words[i] + "' is not a number");
    corners[i] = *number;
  }
  PlotView* plot = browser.plot();
  if (plot == nullptr) return wrongCommand("no plot is in front");
  plot->zoom(QRectF(QPointF(corners[0], corners[1]), QPointF(corners[2], corners[3])));
  return Done{};
}

Outcome start(StudyController& studies, const std::string& cell, const std::string& seed) {
  const StudyBrowser& browser = *studies.browser();
  const auto cellNumber = toNumber(cell);
  const auto seedNumber = toNumber(seed);
  if (!cellNumber || !seedNumber || *cellNumber < 1.0) return wrongCommand("give the numbers of a cell and a seed");
  const StudyRun run{static_cast<std::size_t>(*cellNumber) - 1, static_cast<std::uint64_t>(*seedNumber)};
  if (browser.results().count(run) == 0)
    return wrongCommand("the study has no run of cell " + cell + " with seed " + seed);
  return outcomeOf(studies.show(run));
}

/// Adds the script commands about studies.
void addStudyCommands(const Workbench& bench, StudyController& studies) {
  ScriptCommands& scripts = bench.scripts;
  scripts.add("study", 1,
              [&studies](const Words& words) { return outcomeOf(studies.open(QString::fromStdString(words[0]))); });
  const auto add = [&](const char* name, std::size_t count, auto handler) {
    scripts.add(name, count, [&studies, handler](const Words& words) -> Outcome {
      if (studies.browser() == nullptr) return wrongCommand("no study is open");
      return handler(words);
    });
  };
  add("study-cell", 1, [&studies](const Words& words) { return selectCell(*studies.browser(), words[0]); });
  add("study-plot", 1, [&studies](const Words& words) { return selectPlot(*studies.browser(), words[0]); });
  add("study-zoom", 4, [&studies](const Words& words) { return zoom(*studies.browser(), words); });
  add("study-save-plot", 1, [&studies](const Words& words) { return savePlot(*studies.browser(), words[0]); });
  add("study-screenshot", 1, [&studies](const Words& words) { return saveBrowser(*studies.browser(), words[0]); });
  add("study-run", 2, [&studies](const Words& words) { return start(studies, words[0], words[1]); });
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

}  // namespace

StudyController::StudyController(const Workbench& bench, FileController& files)
    : QObject(&bench.window), bench_(bench), files_(files) {
  bench.onAction("study.open", this, [this] { choose(); });
  bench.onAction("study.report-pdf", this, [this] { choosePdf(); });
  bench.enable("study.report-pdf", false);
  bench.onAction("study.zoom-out", this, [this] { browser_->plot()->zoomOut(); });
  bench.onAction("study.copy-plot", this, [this] { browser_->plot()->copy(); });
  bench.onAction("study.save-plot", this, [this] { choosePlotFile(); });
  enablePlotActions();
  connect(&bench.session, &SessionBridge::snapshotChanged, this, &StudyController::watch);
  addStudyCommands(bench, *this);
}

void StudyController::choose() {
  const QString folder = bench_.dialogs.openFolder(FilePurpose::Study, tr("Open the results of a study"));
  if (folder.isEmpty()) return;
  bench_.work.run(tr("Reading the study"), [this, folder](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const auto content = std::make_shared<const Result<Content>>(read(folder, watch));
    return [this, content] {
      if (*content) {
        show(**content);
      } else {
        bench_.messages.showError(tr("The study cannot be opened"), content->error());
      }
    };
  });
}

void StudyController::choosePdf() {
  const StudyFolder& folder = *browser_->folder();
  const QString proposed = QString::fromStdString(folder.file("report.pdf"));
  const QString file =
      bench_.dialogs.save(FilePurpose::Report, tr("Write the report"), proposed, tr("Documents (*.pdf)"));
  if (file.isEmpty()) return;
  Warnings warnings;
  showSaved(writeReportPdf(reportOf(folder, warnings, windowLanguage()), file), tr("The report cannot be written"));
}

void StudyController::choosePlotFile() {
  const QString file = bench_.dialogs.save(FilePurpose::Export, tr("Save the plot"), QStringLiteral("plot.svg"),
                                           tr("Drawings (*.svg);;Pictures (*.png)"), browser_);
  if (!file.isEmpty()) showSaved(browser_->plot()->save(file), tr("The plot cannot be saved"));
}

void StudyController::showSaved(const SaveResult& saved, const QString& failure) {
  if (!saved) return bench_.messages.showError(failure, saved.why);
  if (saved.warnings.empty()) return;
  bench_.messages.showError(tr("The file was saved, with a warning"), saved.warnings.front());
}

void StudyController::enablePlotActions() {
  const PlotView* plot = browser_ != nullptr ? browser_->plot() : nullptr;
  bench_.enable("study.zoom-out", plot != nullptr && plot->isZoomed());
  bench_.enable("study.copy-plot", plot != nullptr);
  bench_.enable("study.save-plot", plot != nullptr);
}

std::optional<Diagnostic> StudyController::open(const QString& path) {
  const auto content = read(path, {});
  if (!content) return content.error();
  show(*content);
  return std::nullopt;
}

Result<StudyController::Content> StudyController::read(const QString& path, const WorkWatch& watch) {
  auto folder = StudyFolder::open(path.toStdString());
  if (!folder) return folder.error();
  Content content{std::move(*folder), {}, {}};
  content.results = content.folder.results(content.warnings, watch);
  return content;
}

void StudyController::show(const Content& content) {
  if (browser_ == nullptr) {
    browser_ = new StudyBrowser(&bench_.window);
    browser_->resize(bench_.window.size());
    browser_->addPlotActions(bench_.actions);
    connect(browser_, &StudyBrowser::plotChanged, this, &StudyController::enablePlotActions);
    connect(browser_, &StudyBrowser::runRequested, this, [this](const StudyRun& run) {
      if (const auto why = show(run)) bench_.messages.showError(tr("The run cannot be shown"), *why);
    });
  }
  browser_->show(content.folder, content.results);
  shown_.reset();
  enablePlotActions();
  bench_.enable("study.report-pdf", true);
  const auto unread = static_cast<int>(content.warnings.size());
  if (unread > 0) browser_->setMessage(tr("%n file(s) of runs could not be read and are left out.", nullptr, unread));
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
  bench_.session.startFixed({parameters, cell.strategy, run.seed, cell.operatorName});
  return std::nullopt;
}

std::optional<bool> StudyController::isAsInStudy(const RunOutcome& known) const {
  const SnapshotPtr snapshot = bench_.session.snapshot();
  const auto nodes = nodesOf(known);
  if (!snapshot || isRunning(*snapshot) || !nodes || dependsOnMachine(known.result.status)) return std::nullopt;
  return static_cast<double>(snapshot->counts.nodes) == *nodes;
}

std::optional<Diagnostic> StudyController::show(const StudyRun& run) {
  shown_.reset();
  if (const auto why = startRun(*browser_->folder(), run)) return why;
  shown_ = run;
  browser_->selectCell(static_cast<int>(run.cell));
  browser_->setMessage(tr("Seed %1 is running in the main window.").arg(run.seed));
  bench_.window.activateWindow();
  bench_.window.raise();
  return std::nullopt;
}

void StudyController::watch(const SnapshotPtr& snapshot) {
  if (!shown_ || isRunning(*snapshot) || snapshot->run == 0) return;
  const auto same = isAsInStudy(browser_->results().at(*shown_));
  if (same) {
    browser_->setMessage(
        *same ? tr("Seed %1 ended as in the study: %2 nodes.").arg(shown_->seed).arg(snapshot->counts.nodes)
              : tr("Seed %1 ended differently from the study: %2 nodes. Is this another version of Glissade?")
                    .arg(shown_->seed)
                    .arg(snapshot->counts.nodes));
  }
  shown_.reset();
}

}  // namespace glissade
