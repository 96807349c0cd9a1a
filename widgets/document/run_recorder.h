#pragma once

#include <memory>
#include <optional>
#include <string>

#include "widgets/document/journal_writer.h"
#include "widgets/document/session_bridge.h"

namespace glissade {

/// Keeps the recording of the last run, which consists of data that the session publishes. While journals are kept, the
/// recording of a killed program is left on disk; a separate thread writes there. Used on the GUI thread only.
class RunRecorder {
 public:
  /// Runs from now on are journalled in this folder.
  void keepJournals(const std::string& folder) { folder_ = folder; }
  void open(const ScenarioPtr& scenario);
  /// Sets the scenario of the next run; the recording of the last one stays until then. Where the problem is the same,
  /// the recording is about this scenario, too.
  void rearrange(const ScenarioPtr& scenario);
  /// Lets the recording name this scenario and its file, if it is about the same problem. False: it is not.
  bool renew(const ScenarioPtr& scenario);
  /// Takes the snapshot into the recording. True if another run has begun.
  bool follow(const SessionSnapshot& snapshot);

  /// False until a run has begun.
  bool hasRecording() const { return !parts_.empty(); }
  /// The recording so far. Precondition: hasRecording(). Errors: an asset can no longer be read.
  Result<RunRecord> record();
  /// The reason why the disk holds no complete journal; nothing if it is complete or none is needed.
  std::optional<Diagnostic> trouble() const;
  /// Returns trouble() once for each run.
  std::optional<Diagnostic> takeTrouble();
  /// Waits until the disk holds everything that was followed so far.
  void waitUntilJournalled();

 private:
  void beginJournal();
  void journal();
  void closeJournal();

  std::string folder_;
  ScenarioPtr scenario_;           ///< the scenario of the recording
  ScenarioPtr next_;               ///< the scenario of the next run, if it is another one
  std::optional<RunRecord> head_;  ///< the head of this scenario's records; hashing the assets takes time
  RunLogParts parts_;
  std::unique_ptr<JournalWriter> journal_;
  std::size_t journalled_ = 0;
  bool troubleTaken_ = false;
  std::optional<Diagnostic> headTrouble_;  ///< the reason why no journal was begun
};

}  // namespace glissade
