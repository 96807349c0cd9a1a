#pragma once

#include "engine/planning/coarse/scene_knowledge.h"
#include "widgets/controls/background_task.h"

namespace glissade {

/// Builds the environment model in a thread of its own, or at once where time is not real. A new request or cancel()
/// asks the request under way to stop and forgets it, without waiting; the destructor waits.
class KnowledgeBuilder final : public QObject {
  Q_OBJECT

 public:
  explicit KnowledgeBuilder(QObject* parent = nullptr) : QObject(parent) {
    connect(&task_, &BackgroundTask::failed, this, &KnowledgeBuilder::failed);
  }

  /// `before`: the knowledge from before bodies were moved, or null. `atOnce`: the model is finished before this
  /// function returns.
  void build(const Problem& problem, double requiredClearance, const SceneKnowledgePtr& before, bool atOnce);
  bool isBusy() const { return task_.isBusy(); }
  void cancel() { task_.cancel(); }

 signals:
  void started();
  void finished(const glissade::SceneKnowledgePtr& knowledge);
  /// The model could not be built, or an exception has ended the work.
  void failed(const glissade::Diagnostic& why);

 private:
  BackgroundTask task_;
};

}  // namespace glissade
