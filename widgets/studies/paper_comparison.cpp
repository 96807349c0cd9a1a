#include "widgets/studies/paper_comparison.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/base/file.h"
#include "engine/study/study_reader.h"

namespace glissade {
namespace {

/// The settings that the tables of the papers vary.
constexpr std::array kVaried{ParameterId::Alpha, ParameterId::ContactSamples, ParameterId::ContactDistance};

QString numberText(double number) {
  const bool isWhole = number == std::floor(number);
  return QLocale().toString(number, 'f', isWhole ? 0 : 1);
}

std::string canonical(const QString& file) { return QFileInfo(file).canonicalFilePath().toStdString(); }

bool hasSettings(const StudyCell& cell, const SessionSnapshot& run) {
  return cell.strategy == run.provenance.planner && std::all_of(kVaried.begin(), kVaried.end(), [&](ParameterId id) {
           const auto setting = cell.settings.find(id);
           return setting == cell.settings.end() || std::abs(setting->second - run.parameters[id]) < 1e-6;
         });
}

/// The number of the run that corresponds to the column; nothing: there is none.
std::optional<double> numberOf(const PaperColumn& column, const SessionSnapshot& run) {
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

QString tableOf(const Study& study, const StudyCell& cell, const SessionSnapshot& run) {
  QStringList titles;
  QStringList paper;
  QStringList own;
  QStringList measured;
  for (const PaperColumn& column : study.heading.paper) {
    const auto printed = cell.paper.find(column.key);
    const auto* number = printed == cell.paper.end() ? nullptr : std::get_if<double>(&printed->second);
    const auto mine = numberOf(column, run);
    const auto spread = cell.measured.find(column.key);
    titles << escaped(column.title);
    paper << (number != nullptr ? numberText(*number) : QStringLiteral("–"));
    own << (mine ? numberText(*mine) : QStringLiteral("–"));
    measured << (spread == cell.measured.end() ? QStringLiteral("–")
                                               : PaperComparison::tr("%1 (%2 to %3)")
                                                     .arg(numberText(spread->second[1]), numberText(spread->second[0]),
                                                          numberText(spread->second[2])));
  }
  QString html = QStringLiteral("<p><b>%1</b>, %2</p><table cellspacing='4'>")
                     .arg(escaped(study.heading.title), escaped(cell.row));
  html += rowOf({}, titles) + rowOf(PaperComparison::tr("paper"), paper) + rowOf(PaperComparison::tr("this run"), own);
  if (!cell.measured.empty()) {
    html += rowOf(PaperComparison::tr("simulated, %n run(s)", "", static_cast<int>(cell.seeds.size())), measured);
  }
  return html + QStringLiteral("</table><p>%1</p>").arg(escaped(study.heading.citation));
}

}  // namespace

PaperComparison::PaperComparison(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  connect(&bench.run, &ShownRun::changed, this, &PaperComparison::followRun);
}

void PaperComparison::followRun(const SnapshotPtr& snapshot) {
  const bool isSolved = snapshot && bench_.run.isLive() && snapshot->run > 0 && snapshot->path;
  const std::uint64_t run = isSolved ? snapshot->run : 0;
  if (run == comparedRun_) return;
  comparedRun_ = run;
  QString html;
  for (const Study& study : run == 0 ? std::vector<Study>() : studiesOf(bench_.document.scenario()->file)) {
    const auto cell = std::find_if(study.cells.begin(), study.cells.end(),
                                   [&](const StudyCell& each) { return hasSettings(each, *snapshot); });
    if (cell != study.cells.end()) html += tableOf(study, *cell, *snapshot);
  }
  emit compared(html);
}

/// Reads the studies of papers about this scenario. A file that is no study is left out.
const std::vector<Study>& PaperComparison::studiesOf(const std::string& scenarioFile) {
  if (scenarioFile == scenarioFile_) return studies_;
  scenarioFile_ = scenarioFile;
  studies_.clear();
  const QDir folder(QFileInfo(QString::fromStdString(scenarioFile)).dir().filePath(QStringLiteral("../studies")));
  const std::string wanted = canonical(QString::fromStdString(scenarioFile));
  for (const QString& name : folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
    const std::string file = folder.filePath(name).toStdString();
    const auto text = readFile(file, kMostStudyBytes);
    auto study = text ? parseStudy(*text, file, false) : Result<Study>(text.error());
    if (!study || study->heading.paper.empty()) continue;
    std::erase_if(study->cells, [&](const StudyCell& cell) {
      return cell.paper.empty() || canonical(folder.filePath(QString::fromStdString(cell.scenario))) != wanted;
    });
    if (!study->cells.empty()) studies_.push_back(std::move(*study));
  }
  return studies_;
}

}  // namespace glissade
