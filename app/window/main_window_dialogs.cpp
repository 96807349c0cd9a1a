// The questions that the main window asks, and the pages it shows.
#include <glissade/version.h>

#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/window/assembly_controller.h"
#include "app/window/environment_controller.h"
#include "app/window/keyboard_steering.h"
#include "app/window/main_window.h"
#include "app/window/part_import.h"
#include "app/window/replay_controller.h"
#include "app/window/window_memory.h"
#include "app/window/work_controller.h"
#include "widgets/editors/rules_dialog.h"

namespace glissade {

void MainWindow::chooseScenario() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a scenario"), QString(),
                                                    tr("Scenarios (*.json *.cfg);;All files (*)"));
  if (!file.isEmpty()) openInBackground(file);
}

void MainWindow::newScenario(const QStringList& partFiles) {
  parts_->ask(PartsDialog::Purpose::NewScenario, partFiles);
}

void MainWindow::editRules() {
  Scenario after = assembly_->document().current();
  const std::string& strategy = bridge_->snapshot()->plannerId;
  const bool preset = strategy == "gt" || strategy == "gts1" || strategy == "gts2";
  RulesDialog dialog(preset        ? presetRules(strategy)
                     : after.rules ? *after.rules
                                   : presetRules("gts"),
                     environment_->document().table(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  after.rules = dialog.rules();
  const Outcome changed = assembly_->document().edit(tr("Change the rules"), std::move(after));
  if (!changed) showError(tr("The rules cannot be changed"), changed.error());
  bridge_->post(command::SetPlanner{"own"});
}

/// Files that are not there stay in the list: a drive may only be away for a while.
void MainWindow::fillRecent() {
  recent_->clear();
  const QStringList files = memory_ ? memory_->recentFiles() : QStringList();
  for (int i = 0; i < files.size(); ++i) {
    const QFileInfo file(files[i]);
    const QString number = i < 9 ? QStringLiteral("&%1  ").arg(i + 1) : QStringLiteral("1&0  ");
    QString shown = QDir::toNativeSeparators(file.filePath()).replace(QLatin1Char('&'), QStringLiteral("&&"));
    if (!file.exists()) shown = tr("%1 (not there)").arg(shown);
    QAction* action = recent_->addAction(number + shown);
    action->setEnabled(file.exists());
    connect(action, &QAction::triggered, this, [this, path = files[i]] { openInBackground(path); });
  }
  if (files.isEmpty()) recent_->addAction(tr("No file yet"))->setEnabled(false);
  recent_->addSeparator();
  recent_->addAction((*actions_)["recent.forget"]);
  (*actions_)["recent.forget"]->setEnabled(!files.isEmpty());
}

void MainWindow::remember(std::unique_ptr<WindowMemory> memory, bool sizeToo) {
  memory_ = std::move(memory);
  memory_->restoreLayout(*this, sizeToo);
  replay_->bar()->setVisible(replay_->isActive());
}

void MainWindow::save() {
  const QString file = QString::fromStdString(scenario_->file);
  if (!file.endsWith(QLatin1String(".json"))) {
    chooseSave();
    return;
  }
  if (const auto why = saveScenarioAs(file)) showError(tr("The scenario cannot be saved"), *why);
}

void MainWindow::chooseSave() {
  const std::string usual = scenario_->file.empty() ? scenario_->scenario.name + ".json" : scenario_->file;
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the scenario"), QString::fromStdString(usual),
                                                    tr("Scenarios (*.json)"));
  if (file.isEmpty()) return;
  if (const auto why = saveScenarioAs(file)) showError(tr("The scenario cannot be saved"), *why);
}

bool MainWindow::mayDiscard() {
  if (batch_ || !scenario_ || !isModified()) return true;
  const auto answer =
      QMessageBox::question(this, tr("Unsaved edits"), tr("The scenario has edits that are not saved."),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) save();
  return answer == QMessageBox::Discard || !isModified();
}

std::optional<Diagnostic> MainWindow::openRecording(const Result<RunRecord>& record, const QString& file, bool quiet) {
  const auto openOther = [this, quiet](const QString& scenario) { return openScenario(scenario, quiet); };
  const auto why = record ? replay_->open(*record, file, openOther) : std::optional<Diagnostic>(record.error());
  if (why && !quiet) showError(tr("The recording cannot be opened"), *why);
  return why;
}

void MainWindow::chooseRecording() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a recording"), QString(),
                                                    tr("Recordings (*.json *.journal);;All files (*)"));
  if (file.isEmpty()) return;
  work_->run(tr("Reading the recording"), [this, file](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const auto record = std::make_shared<const Result<RunRecord>>(readRunRecord(file.toStdString(), watch));
    return [this, record, file] {
      const SnapshotPtr live = bridge_->snapshot();
      if (live && isRunning(*live)) {
        statusBar()->showMessage(tr("A run has begun meanwhile: open the recording after it."), 10000);
      } else {
        openRecording(*record, file);
      }
    };
  });
}

void MainWindow::chooseSaveRecording() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the recording"), QStringLiteral("run.json"),
                                                    tr("Recordings (*.json)"));
  if (file.isEmpty()) return;
  if (const auto why = replay_->save(file)) {
    showError(tr("The recording cannot be saved"), *why);
  } else if (!assembly_->document().isSaved()) {
    QMessageBox::information(this, tr("The recording was saved"),
                             tr("It names the scenario's file, which does not have the bodies as they are here. Save "
                                "the scenario, too: only then can the recording be replayed."));
  }
}

void MainWindow::keepJournals(const QString& folder) {
  std::vector<JournalSave> saves;
  for (const std::string& file : abandonedJournals(folder.toStdString())) {
    const QString journal = QString::fromStdString(file);
    const QString target = offerJournal(journal);
    if (!target.isEmpty()) saves.emplace_back(journal, target);
  }
  if (!saves.empty()) saveJournals(saves);
  replay_->recorder().keepJournals(folder.toStdString());
}

QString MainWindow::offerJournal(const QString& file) {
  QMessageBox box(QMessageBox::Question, tr("A recording was left"),
                  tr("Glissade ended unexpectedly with a recording that was not saved. It is still there."),
                  QMessageBox::NoButton, this);
  const auto* saved = box.addButton(tr("&Save..."), QMessageBox::AcceptRole);
  const auto* discarded = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("&Later"), QMessageBox::RejectRole);
  box.exec();
  if (box.clickedButton() == discarded) QFile::remove(file);
  if (box.clickedButton() != saved) return {};
  return QFileDialog::getSaveFileName(this, tr("Save the recording"), QStringLiteral("run.json"),
                                      tr("Recordings (*.json)"));
}

/// Whoever cancels is asked again the next time.
void MainWindow::saveJournals(const std::vector<JournalSave>& saves) {
  work_->runToEnd(tr("Saving the recording"), [this, saves](const WorkWatch& watch) -> BackgroundTask::Delivery {
    std::vector<Diagnostic> trouble;
    for (const auto& [journal, target] : saves) {
      const Outcome saved = saveJournal(journal.toStdString(), target.toStdString(), watch);
      if (!saved) trouble.push_back(saved.error());
    }
    return [this, trouble] {
      for (const Diagnostic& why : trouble) showError(tr("The recording cannot be saved"), why);
    };
  });
}

void MainWindow::showError(const QString& title, const Diagnostic& why) {
  QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Ok, this);
  QString text = QString::fromStdString(why.reason);
  if (!why.advice.empty()) text += QStringLiteral("\n\n") + QString::fromStdString(why.advice);
  box.setInformativeText(QString::fromStdString(why.file + (why.place.empty() ? "" : "\n" + why.place)) +
                         QStringLiteral("\n") + text);
  box.exec();
}

void MainWindow::showShortcuts() {
  QDialog dialog(this);
  dialog.setWindowTitle(tr("Keys and shortcuts"));
  dialog.resize(640, 640);
  auto* text = new QTextBrowser(&dialog);
  text->setHtml(QStringLiteral("<h3>%1</h3><p>%2</p><table>%3</table><h3>%4</h3><table>%5</table>")
                    .arg(tr("Steering"), tr("While the 3D view has the focus; directions are those of the view."),
                         KeyboardSteering::keyTable(), tr("Shortcuts"), actions_->shortcutTable()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(text);
  layout->addWidget(buttons);
  dialog.exec();
}

void MainWindow::showAbout() {
  QMessageBox::about(
      this, tr("About Glissade"),
      tr("<h3>Glissade %1</h3><p>A workbench for virtual assembly: certified motions, found by a planner and a person "
         "together.</p><p>N. Blin, M. Taïx, P. Fillatreau, J.-Y. Fourquet, <i>Tuning Interaction in Motion Planning "
         "with Contact</i>, IEEE RO-MAN 2016.</p><p>S. Cailhol, P. Fillatreau, Y. Zhao, J.-Y. Fourquet, "
         "<i>Multi-layer path planning control for the simulation of manipulation tasks</i>, RCIM 57, 2019.</p>"
         "<p>BSD 3-Clause licence.</p>")
          .arg(QLatin1String(kVersion)));
}

}  // namespace glissade
