#include "widgets/help/log_controller.h"

#include <glissade/version.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLocale>
#include <QSysInfo>

#include "engine/base/version_text.h"
#include "engine/files/product_name.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/paths/kept_paths_panel.h"
#include "widgets/workbench/status_text.h"

namespace glissade {
namespace {

QString scenarioLines(const WorkbenchDocument& document) {
  if (!document.scenario()) return QStringLiteral("Scenario: none\n");
  const LoadedScenario& scenario = *document.scenario();
  const RunSettings& settings = document.settings();
  std::size_t triangles = scenario.object.mesh->triangles.size();
  for (const RigidBody& body : scenario.obstacles) triangles += body.mesh->triangles.size();
  QString text = QStringLiteral("Scenario: %1 (%2)\nBodies: %3 obstacles, %4 triangles with the object\n")
                     .arg(QString::fromStdString(nameOfProduct(scenario)), QString::fromStdString(scenario.file))
                     .arg(scenario.obstacles.size())
                     .arg(triangles);
  text += QStringLiteral("Strategy: %1, seed %2\n").arg(QString::fromStdString(settings.strategy)).arg(settings.seed);
  const ParameterValues usual(settings.parameters.objectRadius());
  for (const ParameterSpec& spec : parameterTable()) {
    if (settings.parameters[spec.id] == usual[spec.id]) continue;
    const QString key = QString::fromUtf8(spec.key.data(), static_cast<int>(spec.key.size()));
    text += QStringLiteral("  %1 = %2\n").arg(key).arg(settings.parameters[spec.id], 0, 'g', 17);
  }
  return text;
}

/// Text for a location, with %1 in place of the reason.
QString placeText(const std::string& location) {
  if (location.empty()) return QStringLiteral("%1");
  if (location == "start") return LogController::tr("Start: %1");
  if (location == "goal") return LogController::tr("Goal: %1");
  return QString::fromStdString(location).replace(QLatin1Char('%'), QLatin1Char(' ')) + QStringLiteral(": %1");
}

}  // namespace

LogController::LogController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), panel_(new LogPanel(bench.messages.log(), bench.actions, &bench.window)) {
  connect(&bench.run, &ShownRun::changed, this, &LogController::followRun);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (!(what & Change::Scenario)) return;
    run_ = 0;
    const LoadedScenario& scenario = *bench_.document.scenario();
    const QString name = QString::fromStdString(nameOfProduct(scenario));
    bench_.messages.log().add(LogLevel::Information,
                              tr("Opened '%1', obstacles: %2").arg(name).arg(scenario.obstacles.size()));
    for (const Diagnostic& warning : scenario.warnings) {
      bench_.messages.log().add(LogLevel::Warning, diagnosticText(warning));
    }
  });
  connect(&bench.work, &WorkController::failed, this,
          [this](const Diagnostic& why) { bench_.messages.log().add(LogLevel::Error, diagnosticText(why)); });
  bench.onAction("log.copy", this, [this] {
    QGuiApplication::clipboard()->setText(bugReport());
    bench_.messages.showStatus(tr("The report is in the clipboard. Read it before you send it: it names files."));
  });
  addCommands();
}

/// Logs the beginning and the end of a run, and its failure.
void LogController::followRun(const SnapshotPtr& snapshot) {
  if (!bench_.run.isLive()) return;
  MessageLog& log = bench_.messages.log();
  if (snapshot->run != run_ && snapshot->run > 0) {
    log.add(LogLevel::Information,
            tr("Run %1: %2, seed %3").arg(snapshot->run).arg(strategyName(snapshot->plannerId)).arg(snapshot->seed));
  }
  const std::string problem = snapshot->problem ? toString(*snapshot->problem) : std::string();
  if (!problem.empty() && problem != problem_) {
    const bool expected =
        snapshot->problem->kind == ErrorKind::LimitReached || snapshot->problem->kind == ErrorKind::NoPath;
    log.add(expected ? LogLevel::Warning : LogLevel::Error,
            placeText(toString(snapshot->problem->location)).arg(diagnosticText(*snapshot->problem)));
  }
  const bool ended = !isRunning(*snapshot) && (snapshot->run != run_ || snapshot->state != state_);
  if (ended && snapshot->run > 0 && !snapshot->problem) {
    log.add(LogLevel::Information,
            tr("%1 (%2 s, %3 nodes)")
                .arg(statusText(*snapshot), QLocale().toString(snapshot->planningSeconds, 'f', 2),
                     countText(snapshot->counts.nodes)));
  }
  run_ = snapshot->run;
  state_ = snapshot->state;
  problem_ = problem;
}

QString LogController::bugReport() const {
  QString text = QStringLiteral("Glissade %1\nBuild: %2\nQt %3, %4, %5\nLanguage: %6\n")
                     .arg(QString::fromStdString(versionText()), QLatin1String(kBuild), QLatin1String(qVersion()),
                          QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(), QLocale().name());
  text += scenarioLines(bench_.document);
  text += QStringLiteral("Log:\n");
  for (const LogEntry& entry : bench_.messages.log().entries()) {
    text += QStringLiteral("  %1 %2: %3\n").arg(entry.time.toString(Qt::ISODate), levelText(entry.level), entry.text);
  }
  return text;
}

void LogController::addCommands() {
  bench_.scripts.add("expect-log", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const QString wanted = QString::fromStdString(words[0]);
    for (const LogEntry& entry : bench_.messages.log().entries()) {
      if (entry.text.contains(wanted)) return Done{};
    }
    return unmetExpectation("no message has '" + words[0] + "'");
  });
}

}  // namespace glissade
