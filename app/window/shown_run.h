#pragma once

#include "widgets/bridge/session_bridge.h"
#include "widgets/document/workbench_document.h"

namespace glissade {

/// The run that the window shows: the session's, or a replayed one while a replay is open. Panels observe it instead
/// of the session where they show a run. Another scenario or arrangement ends what was shown: snapshots are always of
/// the document's scenario.
class ShownRun final : public QObject {
  Q_OBJECT

 public:
  ShownRun(const WorkbenchDocument& document, SessionBridge& session, QObject* parent);

  /// Null until a scenario was opened.
  const SnapshotPtr& snapshot() const { return snapshot_; }
  /// False while a replay is open.
  bool isLive() const { return live_; }
  /// What the status line says of the replay.
  const QString& replayText() const { return replayText_; }

  /// From now on the session's snapshots are not shown.
  void beginReplay();
  void showReplay(const SnapshotPtr& snapshot, const QString& text);
  /// The session's last snapshot is shown again.
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
