#pragma once

#include "widgets/document/session_bridge.h"
#include "widgets/document/workbench_document.h"

namespace glissade {

/// The run that the window shows: the session's, or the replayed one while a replay is open. Panels that show a run
/// observe this object instead of the session. Another scenario or arrangement removes the shown run, so snapshots
/// always belong to the document's scenario.
class ShownRun final : public QObject {
  Q_OBJECT

 public:
  ShownRun(const WorkbenchDocument& document, SessionBridge& session, QObject* parent);

  /// Null until a scenario was opened.
  const SnapshotPtr& snapshot() const { return snapshot_; }
  /// False while a replay is open.
  bool isLive() const { return live_; }
  /// Text of the status line about the replay.
  const QString& replayText() const { return replayText_; }

  /// Stops showing the session's snapshots.
  void beginReplay();
  void showReplay(const SnapshotPtr& snapshot, const QString& text);
  /// Shows the session's last snapshot again.
  void endReplay();

 signals:
  void changed(const glissade::SnapshotPtr& snapshot);
  void liveChanged(bool live);

 private:
  void show(const SnapshotPtr& snapshot);
  void setLive(bool live);

  SessionBridge& session_;
  SnapshotPtr snapshot_;
  QString replayText_;
  bool live_ = true;
};

}  // namespace glissade
