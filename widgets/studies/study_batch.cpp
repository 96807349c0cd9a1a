#include "widgets/studies/study_batch.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QImage>

#include <algorithm>
#include <iostream>

#include "engine/base/file.h"
#include "engine/documents/short_number.h"
#include "engine/study/study_page.h"
#include "widgets/controls/picture_file.h"
#include "widgets/controls/window_language.h"
#include "widgets/studies/study_controller.h"

namespace glissade {
namespace {

constexpr std::uint64_t kSlice = 200;

std::optional<double> numberOf(const RunOutcome& outcome, const char* column) {
  for (std::size_t i = 0; i < kResultColumnCount; ++i) {
    if (resultColumns()[i].name == column) return outcome.result.numbers[i];
  }
  return std::nullopt;
}

/// File name with leading zeros, so that the names sort in the order of the cells.
std::string pictureName(const StudyFolder& folder, std::size_t cell) {
  const std::string number = std::to_string(cell + 1);
  const std::string last = std::to_string(folder.plan().study.cells.size());
  return folder.file("pictures/cell" + std::string(last.size() - number.size(), '0') + number);
}

/// The solved run with the median number of nodes; of an even number of runs the smaller middle one.
std::optional<StudyRun> typicalRun(std::size_t cell, const StudyResults& results) {
  std::vector<std::pair<double, StudyRun>> solved;
  for (const auto& [run, outcome] : results) {
    const auto nodes = numberOf(outcome, "nodes");
    if (run.cell == cell && outcome.result.status == RunStatus::Solved && nodes) solved.emplace_back(*nodes, run);
  }
  if (solved.empty()) return std::nullopt;
  std::sort(solved.begin(), solved.end());
  return solved[(solved.size() - 1) / 2].second;
}

std::string captionOf(const StudyCell& cell, const StudyRun& run, const RunOutcome& outcome) {
  const auto show = [&](const char* column) { return shortNumber(numberOf(outcome, column).value_or(0.0)); };
  return cell.label + ": seed " + std::to_string(run.seed) + ", " + show("nodes") + " nodes, " + show("edges") +
         " edges, " + show("virtual_s") + " s; the median of the solved runs by nodes.";
}

std::optional<Diagnostic> takePicture(const StudyFolder& folder, const StudyRun& run, const RunOutcome& outcome,
                                      const Workbench& bench, StudyController& studies) {
  if (const auto why = studies.startRun(folder, run)) return why;
  while (isRunning(*bench.session.snapshot())) bench.session.advance(kSlice);
  if (studies.isAsInStudy(outcome) == false) {
    return Diagnostic{ErrorKind::MalformedInput,
                      folder.path(),
                      {GLISSADE_TEXT("cell %1, seed %2"), {run.cell + 1, run.seed}},
                      GLISSADE_TEXT("ends otherwise than in the study"),
                      GLISSADE_TEXT("Use the version that made it, or make the study again.")};
  }
  bench.scene.view().fit();
  QApplication::processEvents();
  const std::string name = pictureName(folder, run.cell);
  const SaveResult picture = savePicture(bench.scene.picture(), QString::fromStdString(name + ".png"));
  if (!picture) return picture.why;
  const Outcome saved =
      writeFileAtomically(name + ".txt", captionOf(folder.plan().study.cells[run.cell], run, outcome));
  return saved ? std::nullopt : std::optional<Diagnostic>(saved.error());
}

void say(const Warnings& warnings) {
  for (const Diagnostic& warning : warnings) std::cerr << "glissade: " << toString(warning) << "\n";
}

}  // namespace

std::optional<Diagnostic> takeStudyPictures(const QString& path, const Workbench& bench, StudyController& studies) {
  if (bench.session.clock() != SessionClock::Lockstep) {
    return Diagnostic{ErrorKind::Usage, "", "--study-pictures", GLISSADE_TEXT("is for runs without a display"),
                      GLISSADE_TEXT("Add --offscreen.")};
  }
  const auto folder = StudyFolder::open(path.toStdString());
  if (!folder) return folder.error();
  Warnings warnings;
  const StudyResults results = folder->results(warnings);
  say(warnings);
  QDir(path).mkpath(QStringLiteral("pictures"));
  for (std::size_t cell = 0; cell < folder->plan().study.cells.size(); ++cell) {
    const auto run = typicalRun(cell, results);
    if (!run) continue;
    if (const auto why = takePicture(*folder, *run, results.at(*run), bench, studies)) return why;
    std::cout << pictureName(*folder, cell) << ".png" << std::endl;
  }
  return std::nullopt;
}

std::optional<Diagnostic> writeFolderPdf(const QString& path) {
  Warnings warnings;
  const std::string folder = path.toStdString();
  const auto page = [&]() -> Result<std::string> {
    if (!QFile::exists(path + QStringLiteral("/plan.json"))) {
      return writeBenchmarkPage(folder, {"", folder + "/benchmarks.pdf"}, warnings);
    }
    const auto study = StudyFolder::open(folder);
    if (!study) return study.error();
    return writeStudyPage(*study, {"", folder + "/report.pdf", windowLanguage()}, warnings);
  }();
  say(warnings);
  return page ? std::nullopt : std::optional<Diagnostic>(page.error());
}

}  // namespace glissade
