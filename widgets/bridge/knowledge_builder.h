#pragma once

#include <QObject>
#include <atomic>
#include <list>
#include <thread>

#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {

/// Builds the environment model in a thread of its own, or at once where time is not real. A new
/// request or cancel() asks the one under way to stop and forgets it, without waiting; the end of
/// this object waits.
class KnowledgeBuilder final : public QObject {
  Q_OBJECT

 public:
  explicit KnowledgeBuilder(QObject* parent = nullptr) : QObject(parent) {}
  ~KnowledgeBuilder() override;

  /// `atOnce`: finished before this returns.
  void build(const Problem& problem, double requiredClearance, bool atOnce);
  void cancel();

 signals:
  void started();
  void finished(const glissade::SceneKnowledgePtr& knowledge);
  void failed(const glissade::Diagnostic& why);

 private:
  void deliver(std::uint64_t request, const Result<SceneKnowledgePtr>& result);

  struct Worker {
    std::thread thread;
    std::atomic<bool> done{false};
  };
  void joinFinished();

  std::list<Worker> workers_;
  StopSource stop_;
  std::uint64_t request_ = 0;
};

}  // namespace glissade
