#include <algorithm>

#include "engine/planning/contact/interactive_contact_birrt.h"
#include "engine/planning/planner.h"

namespace glissade {
namespace {

PlannerEntry interactive(std::string id, std::string label, std::string description, OperatorUse use) {
  return {std::move(id), std::move(label), std::move(description), use != OperatorUse::None,
          [use](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
            return std::make_unique<InteractiveContactBirrt>(problem, seed, use);
          }};
}

}  // namespace

void PlannerRegistry::add(PlannerEntry entry) { entries_.push_back(std::move(entry)); }

const PlannerEntry* PlannerRegistry::find(std::string_view id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

PlannerRegistry makePlannerRegistry() {
  PlannerRegistry registry;
  registry.add(interactive("contact-birrt", "Interactive BiRRT with contact",
                           "Operator and computer share authority; near an obstacle the object slides on it "
                           "(Blin et al. 2016, Algorithm 1).",
                           OperatorUse::GuideAndContact));
  registry.add(interactive("interactive-birrt", "Interactive BiRRT",
                           "Operator and computer share authority, no contact sampling (Blin et al. 2016, table I).",
                           OperatorUse::Guide));
  registry.add(
      interactive("birrt", "BiRRT", "The computer alone: the same planner with an authority of 1.", OperatorUse::None));
  registry.add(interactive("contact-first-birrt", "Interactive BiRRT, contact first",
                           "As the papers' software of 2016: near an obstacle contact sampling pre-empts the "
                           "authority draw.",
                           OperatorUse::ContactFirst));
  return registry;
}

}  // namespace glissade
