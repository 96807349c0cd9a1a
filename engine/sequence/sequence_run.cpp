#include "engine/sequence/sequence_run.h"

#include "engine/sequence/fasteners.h"
#include "engine/sequence/motion_trial.h"
#include "engine/sequence/standing.h"

namespace glissade {

Result<AssemblyPlan> planSequence(const AssembledProduct& product, const ProductFits& fits,
                                  const SequenceRequest& request, SequenceHost& host) {
  const SequenceStrategyRegistry registry = makeSequenceStrategyRegistry();
  const SequenceStrategyEntry* strategy = registry.find(request.strategy);
  if (strategy == nullptr) {
    return Diagnostic{ErrorKind::Usage, "", "strategy", "is unknown: " + request.strategy,
                      "Choose greedy or best-first."};
  }
  auto rules = resolved(request.demands, product);
  if (!rules) return rules.error();
  const std::vector<FastenerKind> fasteners = fastenersOf(product, fits.contacts());
  for (const OrderRule& rule : fastenerRules(fasteners, fits.contacts())) rules->before.push_back(rule);
  const std::vector<double> densities = densitiesOf(request.demands, product);
  Standing standing(product, {fits.contacts(), fasteners, request.staying, densities, request.demands.gravity},
                    host.team());
  MotionTrial trial(product, fits, request.seed);
  return strategy->make()->plan(
      {product, request.staying, request.seed, trial, request.resumed, *rules, fasteners, &standing}, host);
}

}  // namespace glissade
