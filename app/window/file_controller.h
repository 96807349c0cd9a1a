#pragma once

#include <QMenu>
#include <QMimeData>

#include "app/window/part_import.h"
#include "app/window/path_controller.h"
#include "app/window/save_controller.h"
#include "app/window/window_memory.h"
#include "engine/scenario/scenario_file.h"

namespace glissade {

/// Opens and saves the document: dialogs, the files opened last, files that are dropped, the question about unsaved
/// edits, the window's title.
class FileController final : public QObject {
  Q_OBJECT

 public:
  FileController(const Workbench& bench, PartImport& parts, PathController& path);

  /// The menu of the files opened last.
  QMenu* recentMenu() const { return recent_; }
  /// Guards saves, keeps earlier versions and unsaved edits.
  SaveController& saves() { return *saves_; }
  /// From now on files are remembered there.
  void setMemory(WindowMemory* memory);
  bool remembers() const { return memory_ != nullptr; }
  /// The files opened last, the latest first; they may be gone. None where nothing is remembered.
  QStringList recentFiles() const { return memory_ != nullptr ? memory_->recentFiles() : QStringList(); }

  /// Opens a scenario; errors are shown in a dialog unless `quiet`, and returned.
  std::optional<Diagnostic> openScenario(const QString& file, bool quiet, FindFits fits = FindFits::Now);
  /// The same without waiting for it: reading STEP files takes its time. Cancelled as all background work.
  void openInBackground(const QString& file);
  /// Opens, imports or examines what was dropped on the window. Parts are added to the scenario that is open.
  void drop(const QMimeData& data);
  /// Part files are offered in the dialog of parts; a path file is examined, a scenario is opened. Not empty.
  void openAny(const QStringList& files, PartsDialog::Purpose ofParts);
  /// Of the scenario that is open, or of its parts where it was never saved; empty where nothing is open.
  QString folder() const;
  /// Saves the document into the file, which is the document's from then on. Nothing on success.
  std::optional<Diagnostic> saveAs(const QString& file);
  /// Asks what to do with edits that are not saved. False: the user wants to keep working on them.
  bool mayDiscard();

 signals:
  void recentFilesChanged();
  /// The scenario of the file was saved, or another one may take its place: the scene still shows it.
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
  /// Saves, and asks where somebody else has changed the file.
  void trySave(const QString& file);
  void showTitle();

  const Workbench& bench_;
  PartImport& parts_;
  PathController& path_;
  QMenu* recent_;
  SaveController* saves_;
  WindowMemory* memory_ = nullptr;  ///< null: nothing is remembered
};

}  // namespace glissade
