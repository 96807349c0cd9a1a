#include "engine/sequence/sequence_strategy.h"

#include <algorithm>

#include "engine/sequence/best_first_strategy.h"
#include "engine/sequence/greedy_strategy.h"

namespace glissade {

const SequenceStrategyEntry* SequenceStrategyRegistry::find(std::string_view id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

SequenceStrategyRegistry makeSequenceStrategyRegistry() {
  SequenceStrategyRegistry registry;
  registry.add({"greedy", GLISSADE_TEXT("Greedy"),
                GLISSADE_TEXT("Every part that can be removed is removed, the smallest first; the others are tried "
                              "again when a part that blocks them was removed."),
                [] { return std::make_unique<GreedyStrategy>(); }});
  registry.add({"best-first", GLISSADE_TEXT("Best first"),
                GLISSADE_TEXT("The motions of the greedy strategy in the order that costs least: length, changes of "
                              "direction and of tools, bodies that would fall."),
                [] { return std::make_unique<BestFirstStrategy>(); }});
  return registry;
}

}  // namespace glissade
