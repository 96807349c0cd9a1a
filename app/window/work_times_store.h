#pragma once

#include <QObject>
#include <QUndoStack>

#include "engine/sequence/work_times.h"

namespace glissade {

class WindowMemory;

/// The table of work times, as a person has edited it. It holds for every product, so the settings of the window keep
/// it, and no scenario does. Its edits have an undo stack of their own.
class WorkTimesStore final : public QObject {
  Q_OBJECT

 public:
  const WorkTimes& times() const { return times_; }
  /// Can be undone; nothing happens where the table is this one already.
  void edit(const WorkTimes& times);
  QUndoStack& undoStack() { return undo_; }
  /// The table becomes the one that is remembered. Every edit is remembered from now on.
  void remember(WindowMemory& memory);

 signals:
  void changed();

 private:
  void set(const WorkTimes& times);

  WorkTimes times_;
  QUndoStack undo_;
};

}  // namespace glissade
