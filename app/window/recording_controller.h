#pragma once

#include "app/window/file_controller.h"
#include "app/window/replay_controller.h"

namespace glissade {

/// Recordings as files: opened, saved, and those that a killed program has left.
class RecordingController final : public QObject {
  Q_OBJECT

 public:
  RecordingController(const Workbench& bench, ReplayController& replay, FileController& files);

  /// Replays what was read from a file, and opens its scenario where another is open; errors are shown in a dialog
  /// unless `quiet`, and returned.
  std::optional<Diagnostic> open(const Result<RunRecord>& record, const QString& file, bool quiet);
  /// Journals runs in the folder, and offers to save what killed programs have left there.
  void keepJournals(const QString& folder);

 private:
  void chooseFile();
  void chooseSaveFile();
  /// Asks where to save it; empty: the user does not want to.
  QString offerJournal(const QString& file);
  /// A journal, and the recording that it is to become.
  using JournalSave = std::pair<QString, QString>;
  void saveJournals(const std::vector<JournalSave>& saves);
  void showOutcome(const SaveResult& saved);

  const Workbench& bench_;
  ReplayController& replay_;
  FileController& files_;
};

}  // namespace glissade
