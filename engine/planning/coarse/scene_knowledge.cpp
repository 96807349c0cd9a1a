#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {

std::vector<double> SceneKnowledge::compatibility() const {
  std::vector<double> scores;
  for (const PassageFit& fit : fits) scores.push_back(fit.score);
  return scores;
}

std::uint64_t SceneKnowledge::randomConfigurations() const {
  std::uint64_t sum = 0;
  for (const PassageFit& fit : fits) sum += fit.randomConfigurations;
  return sum;
}

namespace {

/// The obstacles with the mobility that the user has set.
std::vector<RigidBody> bodiesOf(const Problem& problem) {
  std::vector<RigidBody> bodies = problem.world->obstacles();
  if (!problem.scene.edits) return bodies;
  for (RigidBody& body : bodies) {
    const auto edited = problem.scene.edits->bodies.find(bodyIdOf(body.id).text());
    if (edited == problem.scene.edits->bodies.end()) continue;
    const auto mobility = edited->second.find("mobility");
    if (mobility == edited->second.end()) continue;
    body.mobility = mobility->second == AttributeValue(std::string("mobile")) ? Mobility::Mobile : Mobility::Static;
  }
  return bodies;
}

}  // namespace

StrategyRules rulesOf(const Problem& problem, std::string_view strategy) {
  return strategy == "own" && problem.scene.rules ? *problem.scene.rules : presetRules(strategy);
}

Result<EnvironmentModelPtr> buildEnvironmentOf(const Problem& problem, const StopToken& stop) {
  return buildEnvironment(bodiesOf(problem), problem.bounds, problem.scene.environment, stop);
}

Result<SceneKnowledgePtr> buildSceneKnowledge(const Problem& problem, double requiredClearance, const StopToken& stop,
                                              const SceneKnowledgePtr& before) {
  auto knowledge = std::make_shared<SceneKnowledge>();
  const EnvironmentOptions& options = problem.scene.environment;
  auto environment = before ? updateEnvironment(*before->environment, bodiesOf(problem), problem.bounds, options, stop)
                            : buildEnvironmentOf(problem, stop);
  if (!environment) return environment.error();
  knowledge->environment = std::move(*environment);
  knowledge->source = {options, problem.scene.edits, requiredClearance};
  // The former position of a mobile body is not known if memory limited the octree's depth.
  const Octree& octree = *knowledge->environment->octree;
  if (before) knowledge->source.options.cellSize = octree.frame().cellSize(octree.depth());
  const auto& places = knowledge->environment->map.places;
  const double slimmest = slimmestExtent(problem.world->object());
  const CollisionWorldPtr world = problem.world->withForbidden(nullptr);  // edits do not change how the object fits
  for (std::size_t place = 0; place < places.size(); ++place) {
    if (stop.stopRequested()) break;
    knowledge->fits.push_back(places[place].passage ? fitThroughPassage(*knowledge->environment, place, world,
                                                                        problem.bounds, requiredClearance, stop)
                                                    : fitInRoom(places[place], slimmest));
  }
  if (stop.stopRequested()) return environmentInterrupted();
  return SceneKnowledgePtr(std::move(knowledge));
}

SemanticModel semanticsOf(const Problem& problem, const SceneKnowledge& knowledge, const SemanticEditsPtr& edits) {
  return SemanticModel(knowledge.environment, problem.world->obstacles(), problem.scene.objectId,
                       edits ? *edits : SemanticEdits{}, knowledge.compatibility());
}

}  // namespace glissade
