#include "widgets/document/knowledge_builder.h"

namespace glissade {

void KnowledgeBuilder::build(const Problem& problem, double requiredClearance, const SceneKnowledgePtr& before,
                             bool atOnce) {
  cancel();
  emit started();
  const auto work = [this, problem, requiredClearance, before](const WorkWatch& watch) -> BackgroundTask::Delivery {
    return [this, result = buildSceneKnowledge(problem, requiredClearance, watch.stop, before)] {
      if (result) {
        emit finished(*result);
      } else {
        emit failed(result.error());
      }
    };
  };
  task_.start(GLISSADE_TEXT("building the environment model"), work, atOnce);
}

}  // namespace glissade
