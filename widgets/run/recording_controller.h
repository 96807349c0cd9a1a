#pragma once

#include "widgets/files/file_controller.h"
#include "widgets/run/replay_controller.h"

namespace glissade {

/// Recordings as files: opens and saves them, and offers those that killed programs have left.
class RecordingController final : public QObject {
  Q_OBJECT

 public:
  RecordingController(const Workbench& bench, ReplayController& replay, FileController& files);

  /// Replays a record read from a file, and opens its scenario if another is open. Errors are shown in a dialog unless
  /// `quiet`, and returned.
  std::optional<Diagnostic> open(const Result<RunRecord>& record, const QString& file, bool quiet);
  /// Journals runs in the folder, and offers to save the journals of killed programs.
  void keepJournals(const QString& folder);

 private:
  void chooseFile();
  void chooseSaveFile();
  /// Asks where to save a journal; empty if the user does not want to.
  QString offerJournal(const QString& file);
  /// A journal, and the file of the recording made of it.
  using JournalSave = std::pair<QString, QString>;
  void saveJournals(const std::vector<JournalSave>& saves);
  void showOutcome(const SaveResult& saved);

  const Workbench& bench_;
  ReplayController& replay_;
  FileController& files_;
};

}  // namespace glissade
