#include "engine/study/benchmarks/peer_planners.h"
#include "tests/engine/planning/planner_conformance.h"

namespace glissade {
namespace {

PlannerRegistry makePeerRegistry() {
  PlannerRegistry peers;
  registerPeerPlanners(peers);
  return peers;
}

/// True for planners without random numbers.
bool isDeterministic(const std::string& id) { return id == "linear" || id == "potential-field"; }

}  // namespace

/// Every planner of the product.
std::vector<PlannerUnderTest> plannersUnderTest() {
  std::vector<PlannerUnderTest> all;
  const auto addFrom = [&](PlannerRegistry (*make)(), const char* name) {
    const PlannerRegistry registry = make();
    for (const PlannerEntry& entry : registry.entries()) {
      all.push_back({make, name, entry.id, 1, isDeterministic(entry.id)});
    }
  };
  addFrom(makePlannerRegistry, "whole");
  addFrom(makeLocalPlannerRegistry, "local");
  addFrom(makePeerRegistry, "peer");
  for (const int slots : {2, 4}) {
    for (const char* id : {"auto", "interactive"}) all.push_back({makePlannerRegistry, "whole", id, slots});
  }
  return all;
}

}  // namespace glissade
