#pragma once

#include <QMenu>
#include <QMimeData>

#include "engine/files/scenario_file.h"
#include "widgets/files/save_controller.h"
#include "widgets/paths/path_controller.h"
#include "widgets/product/part_import.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {

/// Opens and saves the document: dialogs, recent files, dropped files, the question about unsaved edits, the window's
/// title.
class FileController final : public QObject {
  Q_OBJECT

 public:
  FileController(const Workbench& bench, PartImport& parts, PathController& path);

  /// The menu of recent files.
  QMenu* recentMenu() const { return recent_; }
  /// Guards saves, keeps earlier versions and unsaved edits.
  SaveController& saves() { return *saves_; }
  /// Sets the memory for recent files.
  void setMemory(WindowMemory* memory);
  bool remembers() const { return memory_ != nullptr; }
  /// The recent files, the latest first, also deleted ones; none without a memory.
  QStringList recentFiles() const { return memory_ != nullptr ? memory_->recentFiles() : QStringList(); }

  /// Opens a scenario; errors are shown in a dialog unless `quiet`, and returned.
  std::optional<Diagnostic> openScenario(const QString& file, bool quiet, FindFits fits = FindFits::Now);
  /// Opens a scenario in the background, because reading STEP files takes long. It is cancelled as all background work.
  void openInBackground(const QString& file);
  /// Opens, imports or examines the dropped files. Parts are added to the open scenario.
  void drop(const QMimeData& data);
  /// Opens files of any kind: part files in the dialog of parts, a path file in the path panel, a run of a study, or a
  /// scenario.
  /// Precondition: `files` is not empty.
  void openFiles(const QStringList& files, PartsDialog::Purpose ofParts);
  /// The folder of the open scenario, or of its parts if the scenario was never saved; empty without a scenario.
  QString folder() const;
  /// Saves the document into the file, which becomes the document's file. Returns nothing on success.
  std::optional<Diagnostic> saveAs(const QString& file);
  /// Asks what to do with unsaved edits and running work. False if the user wants to keep them.
  bool mayDiscard();

 signals:
  void recentFilesChanged();
  /// A file of a run of a study is to be opened.
  void runOfStudyChosen(const QString& file);
  /// The picture of the file's scenario has to be taken now: the scenario was saved, or another one may replace it in
  /// the scene.
  void pictureDue(const QString& file);

 private:
  void connectActions();
  std::optional<Diagnostic> take(Result<ScenarioFile> opened, const QString& file, bool quiet);
  void showWarnings(const LoadedScenario& scenario);
  void fillRecentMenu();
  void noteFile(const QString& file);
  bool asksToDiscard();
  bool asksToEndWork();
  void chooseScenario();
  void chooseSaveFile();
  void announcePicture(const QString& file);
  void save();
  SaveController* makeSaves();
  SaveResult write(const QString& file);
  /// Saves, and asks the user if another program has changed the file.
  void trySave(const QString& file);
  void showTitle();

  const Workbench& bench_;
  PartImport& parts_;
  PathController& path_;
  QMenu* recent_;
  SaveController* saves_;
  WindowMemory* memory_ = nullptr;  ///< null: files are not remembered
};

}  // namespace glissade
