#pragma once

#include <optional>

#include "engine/study/study_folder.h"
#include "widgets/files/file_controller.h"

namespace glissade {

class StudyBrowser;

/// Studies in the window: opens a folder of results in the browser, and shows one of its runs again.
class StudyController final : public QObject {
  Q_OBJECT

 public:
  StudyController(const Workbench& bench, FileController& files);

  /// Opens a folder. Returns the failure, or nothing.
  std::optional<Diagnostic> open(const QString& folder);
  /// A study's folder with its results.
  struct Content {
    StudyFolder folder;
    StudyResults results;
    Warnings warnings;
  };
  /// Shows a run of the browser's study again; the browser says whether it ended in the same way.
  std::optional<Diagnostic> show(const StudyRun& run);
  /// Opens the run's scenario and starts the run with its settings. Returns the failure, or nothing.
  std::optional<Diagnostic> startRun(const StudyFolder& folder, const StudyRun& run);
  /// Whether the started run ended with the same number of nodes as in the study; nothing while it runs, or if the
  /// numbers cannot be compared.
  std::optional<bool> isAsInStudy(const RunOutcome& known) const;

  /// Null until a study was opened.
  StudyBrowser* browser() const { return browser_; }

 private:
  static Result<Content> read(const QString& folder, const WorkWatch& watch);
  void show(const Content& content);
  void choose();
  void choosePdf();
  void choosePlotFile();
  /// Shows why a file was not saved, or its warning.
  void showSaved(const SaveResult& saved, const QString& failure);
  void enablePlotActions();
  void watch(const SnapshotPtr& snapshot);

  const Workbench& bench_;
  FileController& files_;
  StudyBrowser* browser_ = nullptr;
  std::optional<StudyRun> shown_;  ///< the browser's run that is shown
};

}  // namespace glissade
