#include "engine/study/benchmarks/peer_planners.h"

#include "engine/planning/ompl/ompl_planner.h"

namespace glissade {

void registerPeerPlanners(PlannerRegistry& registry) {
  const auto add = [&](const std::string& id, const std::string& algorithm, OmplAlgorithm which) {
    registry.add(withScrewMotions({std::string(kPeerPrefix) + id,
                                   {GLISSADE_TEXT("For comparison: unmodified %1"), {algorithm}},
                                   {GLISSADE_TEXT("%1 as OMPL's users run it: collisions by FCL, edges sampled at "
                                                  "intervals; the first path is checked by our certificate."),
                                    {algorithm}},
                                   false,
                                   false,
                                   [which](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                                     return std::make_unique<OmplPlanner>(problem, seed, which, OmplManner::AsItIs);
                                   }}));
  };
  add("rrtconnect", "RRT-Connect", OmplAlgorithm::RrtConnect);
  add("rrt", "RRT", OmplAlgorithm::Rrt);
  add("trrt", "TRRT", OmplAlgorithm::Trrt);
  add("bitrrt", "BiTRRT", OmplAlgorithm::BiTrrt);
  add("bkpiece", "BKPIECE", OmplAlgorithm::Bkpiece);
}

PlannerRegistry makePlannerRegistryWithPeers() {
  PlannerRegistry registry = makePlannerRegistry();
  registerPeerPlanners(registry);
  return registry;
}

}  // namespace glissade
