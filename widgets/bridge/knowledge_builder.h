#pragma once

#include "engine/planning/coarse/scene_knowledge.h"
#include "widgets/bridge/background_task.h"

namespace glissade {

/// Builds the environment model in a thread of its own, or at once where time is not real. A new
/// request or cancel() asks the one under way to stop and forgets it, without waiting; the end of
/// this object waits.
class KnowledgeBuilder final : public QObject {
  Q_OBJECT

 public:
  explicit KnowledgeBuilder(QObject* parent = nullptr) : QObject(parent) {
    connect(&task_, &BackgroundTask::failed, this, &KnowledgeBuilder::failed);
  }

  /// `before`: what was known before bodies were moved, or null. `atOnce`: finished before this returns.
  void build(const Problem& problem, double requiredClearance, const SceneKnowledgePtr& before, bool atOnce);
  bool isBusy() const { return task_.isBusy(); }
  void cancel() { task_.cancel(); }

 signals:
  void started();
  void finished(const glissade::SceneKnowledgePtr& knowledge);
  /// Also where an exception has ended the work.
  void failed(const glissade::Diagnostic& why);

 private:
  BackgroundTask task_;
};

}  // namespace glissade
