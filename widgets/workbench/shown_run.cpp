#include "widgets/workbench/shown_run.h"

namespace glissade {

ShownRun::ShownRun(const WorkbenchDocument& document, SessionBridge& session, QObject* parent)
    : QObject(parent), session_(session) {
  // This happens in the first phase of a change, because the new session publishes its first snapshot in the second
  // phase.
  connect(&document, &WorkbenchDocument::changedForView, this, [this](Changes what) {
    if (!(what & (Change::Scenario | Change::Arrangement))) return;
    snapshot_.reset();
    setLive(true);
  });
  connect(&session, &SessionBridge::snapshotChanged, this, [this](const SnapshotPtr& snapshot) {
    if (live_) show(snapshot);
  });
}

void ShownRun::show(const SnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  emit changed(snapshot);
}

void ShownRun::setLive(bool live) {
  if (live == live_) return;
  live_ = live;
  emit liveChanged(live);
}

void ShownRun::beginReplay() { setLive(false); }

void ShownRun::showReplay(const SnapshotPtr& snapshot, const QString& text) {
  replayText_ = text;
  show(snapshot);
}

void ShownRun::endReplay() {
  if (live_) return;
  setLive(true);
  if (session_.snapshot()) show(session_.snapshot());
}

}  // namespace glissade
