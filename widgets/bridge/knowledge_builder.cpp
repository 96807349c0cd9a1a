#include "widgets/bridge/knowledge_builder.h"

namespace glissade {

KnowledgeBuilder::~KnowledgeBuilder() {
  cancel();
  for (Worker& worker : workers_) worker.thread.join();
}

void KnowledgeBuilder::cancel() {
  ++request_;
  stop_.requestStop();
}

void KnowledgeBuilder::joinFinished() {
  for (auto worker = workers_.begin(); worker != workers_.end();) {
    if (!worker->done) {
      ++worker;
      continue;
    }
    worker->thread.join();
    worker = workers_.erase(worker);
  }
}

void KnowledgeBuilder::build(const Problem& problem, double requiredClearance, bool atOnce) {
  cancel();
  joinFinished();
  emit started();
  const std::uint64_t request = request_;
  if (atOnce) {
    deliver(request, buildSceneKnowledge(problem, requiredClearance));
    return;
  }
  stop_ = StopSource();
  Worker& worker = workers_.emplace_back();
  worker.thread = std::thread([this, problem, requiredClearance, request, stop = stop_.token(), done = &worker.done] {
    auto result = buildSceneKnowledge(problem, requiredClearance, stop);
    QMetaObject::invokeMethod(
        this, [this, request, result] { deliver(request, result); }, Qt::QueuedConnection);
    *done = true;
  });
}

void KnowledgeBuilder::deliver(std::uint64_t request, const Result<SceneKnowledgePtr>& result) {
  if (request != request_) return;
  if (result) {
    emit finished(*result);
  } else {
    emit failed(result.error());
  }
}

}  // namespace glissade
