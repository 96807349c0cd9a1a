#pragma once

#include <optional>

#include "engine/study/study_folder.h"
#include "widgets/files/file_controller.h"

namespace glissade {

/// Studies in the window: writes the page of a folder of results and opens it in the browser of the desktop, and shows
/// a run of a study again.
class StudyController final : public QObject {
  Q_OBJECT

 public:
  StudyController(const Workbench& bench, FileController& files);

  /// Writes the page of a folder. Returns the failure, or nothing.
  std::optional<Diagnostic> open(const QString& folder);
  /// Shows the run of a file runs/cellN-seedM.json again; the status bar says whether it ended in the same way. A
  /// failure is shown in a dialog unless `quiet`, and returned.
  std::optional<Diagnostic> openRun(const QString& file, bool quiet = true);
  /// Opens the run's scenario and starts the run with its settings. Returns the failure, or nothing.
  std::optional<Diagnostic> startRun(const StudyFolder& folder, const StudyRun& run);
  /// Whether the started run ended with the same number of nodes as in the study; nothing while it runs, or if the
  /// numbers cannot be compared.
  std::optional<bool> isAsInStudy(const RunOutcome& known) const;
  /// The folder of the study that was opened last; empty: none.
  const QString& folder() const { return folder_; }

 private:
  void choose();
  void chooseRun();
  void choosePdf();
  /// Opens a run after the question about unsaved edits.
  void askAndOpenRun(const QString& file);
  std::optional<Diagnostic> startRunOf(const QString& file);
  /// Writes the page in the background, then opens it.
  void writeInBackground(const QString& folder, const QString& pdf);
  void showPage(const QString& folder, const QString& page);
  void watch(const SnapshotPtr& snapshot);

  const Workbench& bench_;
  FileController& files_;
  QString folder_;
  std::optional<StudyRunFile> shown_;  ///< the run of a study that is shown
};

}  // namespace glissade
