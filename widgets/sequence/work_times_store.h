#pragma once

#include <QObject>
#include <QUndoStack>

#include "engine/sequence/work_times.h"

namespace glissade {

class WindowMemory;

/// The table of work times, as a person has edited it. The window's settings keep it, because it holds for every
/// product. Its edits have their own undo stack.
class WorkTimesStore final : public QObject {
  Q_OBJECT

 public:
  const WorkTimes& times() const { return times_; }
  /// Changes the table by an undoable edit; does nothing if the table is equal.
  void edit(const WorkTimes& times);
  QUndoStack& undoStack() { return undo_; }
  /// Restores the remembered table, and remembers every later edit.
  void remember(WindowMemory& memory);

 signals:
  void changed();

 private:
  void set(const WorkTimes& times);

  WorkTimes times_;
  QUndoStack undo_;
};

}  // namespace glissade
