#include "widgets/sequence/work_times_store.h"

#include "widgets/document/value_command.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {

void WorkTimesStore::edit(const WorkTimes& times) {
  if (times == times_) return;
  undo_.push(new ValueCommand<WorkTimes>({}, times_, times, [this](const WorkTimes& value) { set(value); }));
}

void WorkTimesStore::set(const WorkTimes& times) {
  times_ = times;
  emit changed();
}

void WorkTimesStore::remember(WindowMemory& memory) {
  undo_.clear();
  set(memory.workTimes());
  connect(this, &WorkTimesStore::changed, this, [this, &memory] { memory.saveWorkTimes(times_); });
}

}  // namespace glissade
