#include "engine/sequence/sequence_run.h"

#include "engine/sequence/fasteners.h"
#include "engine/sequence/motion_trial.h"
#include "engine/sequence/standing.h"
#include "engine/sequence/step_tools.h"

namespace glissade {
namespace {

/// By shape and contacts, but for those that are known.
std::vector<FastenerKind> fastenersKnown(const AssembledProduct& product, const std::vector<Contact>& contacts,
                                         const SequenceDemands& demands) {
  std::vector<FastenerKind> kinds = fastenersOf(product, contacts);
  for (const auto& [name, text] : demands.fasteners) {
    const auto kind = fastenerByName(text);
    for (const std::size_t body : bodiesNamed(product, name)) kinds[body] = kind.value_or(kinds[body]);
  }
  return kinds;
}

std::vector<bool> fragileBodies(const AssembledProduct& product, const SequenceDemands& demands) {
  std::vector<bool> fragile(product.bodies.size(), false);
  for (const std::string& name : demands.fragile) {
    for (const std::size_t body : bodiesNamed(product, name)) fragile[body] = true;
  }
  return fragile;
}

}  // namespace

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
  const auto cost = StepCost::of(request.demands);
  if (!cost) return cost.error();
  const std::vector<FastenerKind> fasteners = fastenersKnown(product, fits.contacts(), request.demands);
  const auto tools = chooseTools(product, fasteners, request.demands);
  if (!tools) return tools.error();
  for (const OrderRule& rule : fastenerRules(fasteners, fits.contacts())) rules->before.push_back(rule);
  Standing standing(product,
                    {fits.contacts(), fasteners, request.staying, densitiesOf(request.demands, product),
                     request.demands.gravity, massesOf(request.demands, product)},
                    host.team());
  MotionTrial trial(product, fits, request.seed);
  const SequenceQuestion question{product,   request.staying, request.seed,
                                  trial,     request.resumed, *rules,
                                  fasteners, &standing,       fragileBodies(product, request.demands),
                                  *tools,    &*cost};
  AssemblyPlan plan = strategy->make()->plan(question, host);
  addTools(plan, question, host);
  plan.demands = request.demands;
  return plan;
}

}  // namespace glissade
