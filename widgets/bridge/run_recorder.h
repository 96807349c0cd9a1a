#pragma once

#include <memory>
#include <optional>
#include <string>

#include "widgets/bridge/journal_writer.h"
#include "widgets/bridge/session_bridge.h"

namespace glissade {

/// Keeps the recording of the last run: what the session publishes of it anyway. While journals are
/// kept, a killed program leaves it on disk; a thread of its own writes there. Used on the GUI thread only.
class RunRecorder {
 public:
  /// From now on runs are journalled in this folder.
  void keepJournals(const std::string& folder) { folder_ = folder; }
  void open(const ScenarioPtr& scenario);
  /// The next run is of this scenario; the recording of the last one stays until then.
  void rearrange(const ScenarioPtr& scenario) { next_ = scenario; }
  /// True where another run has begun.
  bool follow(const SessionSnapshot& snapshot);

  /// Nothing until a run has begun.
  bool hasRecording() const { return !parts_.empty(); }
  /// The recording so far. Precondition: hasRecording(). Errors: an asset can no longer be read.
  Result<RunRecord> record();
  /// Why the disk holds no complete journal, where one is needed.
  std::optional<Diagnostic> trouble() const;
  /// The same, once for each run.
  std::optional<Diagnostic> takeTrouble();
  /// Waits until the disk holds what was followed so far.
  void waitUntilJournalled();

 private:
  void beginJournal();
  void journal();
  void closeJournal();

  std::string folder_;
  ScenarioPtr scenario_;           ///< of the recording
  ScenarioPtr next_;               ///< of the next one, where it is another
  std::optional<RunRecord> head_;  ///< of this scenario's records; hashing its assets takes time
  RunLogParts parts_;
  std::unique_ptr<JournalWriter> journal_;
  std::size_t journalled_ = 0;
  bool troubleTaken_ = false;
  std::optional<Diagnostic> headTrouble_;  ///< why no journal was begun
};

}  // namespace glissade
