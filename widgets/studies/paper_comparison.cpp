#include "widgets/studies/paper_comparison.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "engine/base/file.h"
#include "engine/study/study_reader.h"

namespace glissade {
namespace {

QString numberText(double number) {
  const bool isWhole = number == std::floor(number);
  // Qt breaks lines at the narrow space that groups digits in some languages.
  return QLocale().toString(number, 'f', isWhole ? 0 : 1).replace(QChar(0x202F), QChar::Nbsp);
}

std::string canonical(const QString& file) { return QFileInfo(file).canonicalFilePath().toStdString(); }

/// The number of the run that corresponds to the column; nothing: there is none, as before the run has a path.
std::optional<double> numberOf(const PaperColumn& column, const SessionSnapshot& run) {
  if (run.run == 0 || !run.path) return std::nullopt;
  const std::string& measure = column.quantity.measure;
  if (measure == "nodes") return static_cast<double>(run.counts.nodes);
  if (measure == "edges") return static_cast<double>(run.counts.edges);
  if (measure == "virtual_s") return std::round(10.0 * run.virtualSeconds) / 10.0;
  return std::nullopt;
}

/// A text of a study file as HTML.
QString escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

QString rowOf(const QString& title, const QStringList& cells) {
  return QStringLiteral("<tr><td>%1</td><td align='right'>%2</td></tr>")
      .arg(title, cells.join(QStringLiteral("</td><td align='right'>")));
}

/// A row for each quantity, because a panel is narrow.
QString tableOf(const Study& study, const StudyCell& cell, const SessionSnapshot& run) {
  const QString none = QStringLiteral("–");
  QStringList heads{PaperComparison::tr("paper"), PaperComparison::tr("this run")};
  const bool isMeasured = !cell.measured.empty();
  if (isMeasured) heads << PaperComparison::tr("simulated, %n runs", "", static_cast<int>(cell.seeds.size()));
  QString html = QStringLiteral("<p><b>%1</b>, %2</p><table cellspacing='4'>")
                     .arg(escaped(study.heading.title), escaped(cell.row)) +
                 rowOf({}, heads);
  for (const PaperColumn& column : study.heading.paper) {
    const auto printed = cell.paper.find(column.key);
    const auto* number = printed == cell.paper.end() ? nullptr : std::get_if<double>(&printed->second);
    const auto mine = numberOf(column, run);
    QStringList cells{number != nullptr ? numberText(*number) : none, mine ? numberText(*mine) : none};
    const auto spread = cell.measured.find(column.key);
    if (spread != cell.measured.end()) {
      const std::vector<double>& range = spread->second;
      cells
          << PaperComparison::tr("%1 (%2 to %3)").arg(numberText(range[1]), numberText(range[0]), numberText(range[2]));
    } else if (isMeasured) {
      cells << none;
    }
    html += rowOf(escaped(column.title), cells);
  }
  return html + QStringLiteral("</table><p>%1</p>").arg(escaped(study.heading.citation));
}

/// Reads the studies of papers about this scenario. A file that is no study is left out.
std::vector<Study> studiesOf(const std::string& scenarioFile, const StopToken& stop) {
  std::vector<Study> studies;
  const QDir folder(QFileInfo(QString::fromStdString(scenarioFile)).dir().filePath(QStringLiteral("../studies")));
  const std::string wanted = canonical(QString::fromStdString(scenarioFile));
  for (const QString& name : folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
    if (stop.stopRequested()) break;
    const std::string file = folder.filePath(name).toStdString();
    const auto text = readFile(file, kMostStudyBytes);
    auto study = text ? parseStudy(*text, file, false) : Result<Study>(text.error());
    if (!study || study->heading.paper.empty()) continue;
    std::erase_if(study->cells, [&](const StudyCell& cell) {
      return cell.paper.empty() || canonical(folder.filePath(QString::fromStdString(cell.scenario))) != wanted;
    });
    if (!study->cells.empty()) studies.push_back(std::move(*study));
  }
  return studies;
}

}  // namespace

PaperComparison::PaperComparison(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  connect(&bench.run, &ShownRun::changed, this, &PaperComparison::followRun);
  connect(&reading_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
}

void PaperComparison::followRun() {
  if (!bench_.run.snapshot()) return;
  Compared now = present();
  // The numbers of a run stay beside the row of its settings when these are changed afterwards.
  if (now == compared_ || (now.run != 0 && now.run == compared_.run && now.scenarioFile == compared_.scenarioFile))
    return;
  const bool isOther = now.scenarioFile != compared_.scenarioFile;
  compared_ = std::move(now);
  if (isOther) readStudies();
  show();
}

PaperComparison::Compared PaperComparison::present() const {
  const SessionSnapshot& run = *bench_.run.snapshot();
  const bool isSolved = bench_.run.isLive() && run.run > 0 && run.path;
  Compared now{bench_.document.scenario()->file, isSolved ? run.run : 0,
               isSolved ? run.provenance.planner : run.plannerId};
  for (std::size_t i = 0; i < kVariedSettings.size(); ++i) now.settings[i] = run.parameters[kVariedSettings[i]];
  return now;
}

void PaperComparison::readStudies() {
  studies_.clear();
  const auto read = [this, file = compared_.scenarioFile](const WorkWatch& watch) -> BackgroundTask::Delivery {
    auto studies = std::make_shared<std::vector<Study>>(studiesOf(file, watch.stop));
    return [this, studies] {
      studies_ = std::move(*studies);
      show();
    };
  };
  reading_.start(GLISSADE_TEXT("reading the studies of the papers"), read, bench_.work.isAtOnce());
}

void PaperComparison::show() {
  const auto isRow = [this](const StudyCell& cell) {
    if (cell.strategy != compared_.strategy) return false;
    for (std::size_t i = 0; i < kVariedSettings.size(); ++i) {
      const auto setting = cell.settings.find(kVariedSettings[i]);
      if (setting != cell.settings.end() && std::abs(setting->second - compared_.settings[i]) >= 1e-6) return false;
    }
    return true;
  };
  QString html;
  for (const Study& study : studies_) {
    const auto row = std::find_if(study.cells.begin(), study.cells.end(), isRow);
    if (row != study.cells.end()) html += tableOf(study, *row, *bench_.run.snapshot());
  }
  emit compared(html);
}

}  // namespace glissade
