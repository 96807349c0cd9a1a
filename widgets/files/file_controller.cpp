#include "widgets/files/file_controller.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QTimer>
#include <QUrl>

#include "engine/files/part_files.h"
#include "engine/files/path_reader.h"
#include "engine/files/product_name.h"
#include "engine/study/study_folder.h"
#include "widgets/controls/plain_message_box.h"
#include "widgets/files/sample_scenarios.h"
#include "widgets/files/save_conflict.h"
#include "widgets/workbench/proposed_file.h"

namespace glissade {

namespace {

/// Whether the file comes with the program.
bool isSample(const QString& file) {
  const QString samples = QDir(samplesFolder(QCoreApplication::applicationDirPath())).canonicalPath();
  return !samples.isEmpty() && QFileInfo(file).canonicalFilePath().startsWith(samples + QLatin1Char('/'));
}

}  // namespace

FileController::FileController(const Workbench& bench, PartImport& parts, PathController& path)
    : QObject(&bench.window),
      bench_(bench),
      parts_(parts),
      path_(path),
      recent_(new QMenu(tr("Open re&cent"), &bench.window)),
      saves_(makeSaves()) {
  recent_->setObjectName(QStringLiteral("menu.recent"));
  connect(recent_, &QMenu::aboutToShow, this, &FileController::fillRecentMenu);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this] { showTitle(); });
  connect(&parts_, &PartImport::scenarioMade, this, [this](const ScenarioPtr& scenario) {
    if (mayDiscard()) bench_.document.open(scenario);
  });
  connectActions();
  fillRecentMenu();
  bench.scripts.add("open", 1, [this](const ScriptCommands::Words& words) {
    return outcomeOf(openScenario(QString::fromStdString(words[0]), true));
  });
  bench.scripts.add("drop", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(words[0]))});
    drop(data);
    return Done{};
  });
  bench.scripts.add("expect-title", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const std::string title = bench_.window.windowTitle().toStdString();
    if (title.find(words[0]) != std::string::npos) return Done{};
    return unmetExpectation("the title is '" + title + "'");
  });
  bench.scripts.add("expect-modified", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const std::string modified = bench_.window.isWindowModified() ? "yes" : "no";
    if (modified == words[0]) return Done{};
    return unmetExpectation("modified: " + modified);
  });
  bench.scripts.add("save", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    if (!bench_.document.scenario()) return wrongCommand("no scenario is open");
    return outcomeOf(saveAs(QString::fromStdString(words[0])));
  });
}

void FileController::connectActions() {
  bench_.onAction("file.new", this, [this] { parts_.ask(PartsDialog::Purpose::NewScenario); });
  bench_.onAction("file.open", this, [this] { chooseScenario(); });
  bench_.onAction("file.save", this, [this] { save(); });
  bench_.onAction("file.save-as", this, [this] { chooseSaveFile(); });
  bench_.onAction("recent.forget", this, [this] {
    memory_->forgetFiles();
    emit recentFilesChanged();
  });
  bench_.onAction("file.new-window", this,
                  [] { QProcess::startDetached(QCoreApplication::applicationFilePath(), {}); });
  for (const char* id : {"file.save", "file.save-as", "file.close", "recent.forget"}) bench_.enable(id, false);
}

std::optional<Diagnostic> FileController::openScenario(const QString& file, bool quiet, FindFits fits) {
  if (!quiet && !mayDiscard()) return std::nullopt;
  return take(openScenarioFile(file.toStdString(), {}, fits), file, quiet);
}

void FileController::openInBackground(const QString& file) {
  bench_.work.run(tr("Opening the scenario"), [this, file](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const auto opened = std::make_shared<const Result<ScenarioFile>>(
        openScenarioFile(file.toStdString(), watch.stop, FindFits::LaterIfLarge));
    // The question comes at the delivery, because edits may have been made during the reading.
    return [this, opened, file] {
      if (!*opened || mayDiscard()) (void)take(*opened, file, false);
    };
  });
}

std::optional<Diagnostic> FileController::take(Result<ScenarioFile> opened, const QString& file, bool quiet) {
  if (!opened) {
    if (!quiet) bench_.messages.showError(tr("The scenario cannot be opened"), opened.error());
    return opened.error();
  }
  saves_->noteContent(file.toStdString(), opened->sha256);
  const auto scenario = std::make_shared<const LoadedScenario>(std::move(opened->scenario));
  bench_.document.open(scenario);
  noteFile(file);
  if (quiet) return std::nullopt;
  if (scenario->fitsPending) {
    bench_.document.whenArranged([this] { showWarnings(*bench_.document.scenario()); });
  } else {
    showWarnings(*scenario);
  }
  return std::nullopt;
}

void FileController::showWarnings(const LoadedScenario& scenario) {
  const Warnings& warnings = scenario.warnings.empty() ? scenario.fits.warnings : scenario.warnings;
  if (warnings.empty()) return;
  bench_.messages.showError(tr("The scenario was opened, with a warning"), warnings.front());
}

std::optional<Diagnostic> FileController::saveAs(const QString& file) {
  const SaveResult saved = write(file);
  return saved ? std::nullopt : std::make_optional(saved.why);
}

SaveController* FileController::makeSaves() {
  SaveHost host;
  host.scenario = [this] { return bench_.document.scenario(); };
  host.isModified = [this] { return bench_.document.isModified() || bench_.document.hasUnkeptPath(); };
  host.contentFor = [this](const std::string& file) { return bench_.document.contentFor(file); };
  host.openModified = [this](const ScenarioPtr& scenario) {
    bench_.document.open(scenario);
    bench_.document.undoStack().resetClean();
  };
  host.mayDiscard = [this] { return mayDiscard(); };
  host.showError = [this](const QString& title, const Diagnostic& why) { bench_.messages.showError(title, why); };
  return new SaveController(std::move(host), &bench_.window);
}

SaveResult FileController::write(const QString& file) {
  const std::string name = file.toStdString();
  if (bench_.document.hasUnkeptPath()) bench_.document.keepResult();
  const Scenario content = bench_.document.savedContentFor(name);
  SaveResult saved = saves_->save(content, name);
  if (!saved) return saved;
  bench_.document.noteSaved(name, content);
  noteFile(file);
  announcePicture(file);
  return saved;
}

/// Announces that the picture is due, except for a temporary scenario, whose scene is not the file's.
void FileController::announcePicture(const QString& file) {
  if (!file.isEmpty() && !bench_.document.isTemporary()) emit pictureDue(file);
}

QString FileController::folder() const {
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (!scenario) return {};
  const std::vector<Asset>& assets = scenario->scenario.assets;
  const std::string& ofParts = assets.empty() ? scenario->file : assets.front().path;
  const std::string& file = scenario->file.empty() ? ofParts : scenario->file;
  return file.empty() ? QString() : QFileInfo(QString::fromStdString(file)).absolutePath();
}

void FileController::chooseScenario() {
  const QString file = bench_.dialogs.open(FilePurpose::Scenario, tr("Open a scenario or a product"),
                                           tr("Scenarios and parts (%1 %2);;Scenarios (%1);;Parts (%2);;All files (*)")
                                               .arg(QStringLiteral("*.json *.cfg"), partFilePatterns()));
  if (!file.isEmpty()) openFiles({file}, PartsDialog::Purpose::NewScenario);
}

void FileController::save() {
  const QString file = QString::fromStdString(bench_.document.scenario()->file);
  if (file.endsWith(QLatin1String(".json")) && !isSample(file)) {
    trySave(file);
  } else {
    chooseSaveFile();
  }
}

void FileController::chooseSaveFile() {
  const LoadedScenario& scenario = *bench_.document.scenario();
  const QString own = QString::fromStdString(scenario.file);
  QString title = tr("Save the scenario");
  QString proposed = own;
  if (isSample(own)) {
    title = tr("Save a copy of the sample");
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    proposed = documents.filePath(QFileInfo(own).dir().dirName() + QStringLiteral(".json"));
  } else if (!own.endsWith(QLatin1String(".json"))) {
    proposed = QDir(folder()).filePath(proposedFile(scenario, QStringLiteral(".json")));
  }
  const QString file = bench_.dialogs.save(FilePurpose::Scenario, title, proposed, tr("Scenarios (*.json)"));
  if (!file.isEmpty()) trySave(file);
}

void FileController::trySave(const QString& file) {
  const SaveResult saved = write(file);
  if (saved) {
    bench_.messages.showUntilAction(tr("Saved: %1").arg(QDir::toNativeSeparators(file)));
    if (saved.warnings.empty()) return;
    bench_.messages.showError(tr("The scenario was saved, with a warning"), saved.warnings.front());
    return;
  }
  if (saved.status == SaveStatus::Failed || bench_.messages.isQuiet()) {
    bench_.messages.showError(tr("The scenario cannot be saved"), saved.why);
    return;
  }
  switch (askAboutConflict(saved, &bench_.window)) {
    case ConflictAnswer::KeepMine:
      saves_->allowReplacing();
      trySave(file);
      return;
    case ConflictAnswer::TakeTheirs: (void)take(openScenarioFile(file.toStdString()), file, false); return;
    case ConflictAnswer::SaveAs: chooseSaveFile(); return;
    case ConflictAnswer::Cancel: return;
  }
}

void FileController::setMemory(WindowMemory* memory) {
  memory_ = memory;
  emit recentFilesChanged();
}

void FileController::noteFile(const QString& file) {
  if (memory_ == nullptr) return;
  memory_->noteFile(file);
  emit recentFilesChanged();
}

bool FileController::mayDiscard() {
  if (!asksToEndWork() || !asksToDiscard()) return false;
  const ScenarioPtr& scenario = bench_.document.scenario();
  if (scenario) announcePicture(QString::fromStdString(scenario->file));
  return true;
}

/// Asks whether running work, such as a film, may be lost. The work needs the scenario that is open.
bool FileController::asksToEndWork() {
  const QString work = bench_.work.endangered();
  if (bench_.messages.isQuiet() || work.isEmpty()) return true;
  PlainMessageBox box(QMessageBox::Question, tr("End what is under way?"), tr("Under way: %1.").arg(work),
                      tr("It goes on while this question is open. It is lost where it is ended now."), &bench_.window);
  const QAbstractButton* end = box.addButton(tr("&End it"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == end || bench_.work.endangered().isEmpty();
}

bool FileController::asksToDiscard() {
  const auto isAllKept = [&document = bench_.document] { return !document.isModified() && !document.hasUnkeptPath(); };
  if (bench_.messages.isQuiet() || isAllKept()) return true;
  QStringList unsaved;
  if (bench_.document.hasUnsavedEdits()) unsaved << tr("edits");
  if (bench_.document.hasUnkeptPath()) unsaved << tr("the path found");
  if (bench_.document.hasUnsavedPlan()) unsaved << tr("the assembly plan");
  const LoadedScenario& scenario = *bench_.document.scenario();
  const QString product = QString::fromStdString(nameOfProduct(scenario));
  const QString name = product.isEmpty() ? QFileInfo(QString::fromStdString(scenario.file)).fileName() : product;
  const bool isEdited = bench_.document.isModified();
  PlainMessageBox box(QMessageBox::Question, isEdited ? tr("Save changes?") : tr("Keep the path?"),
                      isEdited ? tr("Save changes to \"%1\"?").arg(name) : tr("Keep the path of \"%1\"?").arg(name),
                      tr("Not saved: %1.").arg(unsaved.join(QStringLiteral(", "))), &bench_.window);
  box.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (!isEdited) box.button(QMessageBox::Save)->setText(tr("&Keep path"));
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Save) save();
  return answer == QMessageBox::Discard || isAllKept();
}

/// Fills the menu of recent files. Missing files stay in the list, because a drive may be away for a while.
void FileController::fillRecentMenu() {
  recent_->clear();
  const QStringList files = recentFiles();
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
  recent_->addAction(bench_.actions["recent.forget"]);
  bench_.enable("recent.forget", !files.isEmpty());
}

void FileController::drop(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls()) files << url.toLocalFile();
  const bool more = bench_.document.scenario() != nullptr;
  // The dialog opens later, because it would block the program that the files were dragged from.
  QTimer::singleShot(0, this, [this, files, more] {
    openFiles(files, more ? PartsDialog::Purpose::AddParts : PartsDialog::Purpose::NewScenario);
  });
}

void FileController::openFiles(const QStringList& files, PartsDialog::Purpose ofParts) {
  QStringList partFiles;
  for (const QString& file : files) {
    if (isPartFile(file.toStdString())) partFiles << file;
  }
  if (!partFiles.isEmpty()) {
    parts_.ask(ofParts, partFiles);
  } else if (isPathFile(files.front().toStdString())) {
    path_.openOrShowError(files.front());
  } else if (isStudyRunFile(files.front().toStdString())) {
    emit runOfStudyChosen(files.front());
  } else {
    openInBackground(files.front());
  }
}

/// Shows the file name, and the product's name if it differs.
void FileController::showTitle() {
  const LoadedScenario& scenario = *bench_.document.scenario();
  const QFileInfo file(QString::fromStdString(scenario.file));
  const QString name = QString::fromStdString(nameOfProduct(scenario));
  QString title = (scenario.file.empty() ? name : file.fileName()) + QStringLiteral("[*]");
  if (!scenario.file.empty() && !name.isEmpty() && name != file.completeBaseName()) {
    title += QStringLiteral(" — ") + name;
  }
  bench_.window.setWindowTitle(title + QStringLiteral(" — Glissade"));
  bench_.window.setWindowModified(bench_.document.isModified());
  bench_.enable("file.save", true);
  bench_.enable("file.save-as", true);
  bench_.enable("file.close", bench_.session.clock() == SessionClock::RealTime);
}

}  // namespace glissade
