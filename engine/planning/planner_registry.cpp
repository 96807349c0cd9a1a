#include <algorithm>

#include "engine/collision/thread_rule.h"
#include "engine/planning/automatic/automatic_planner.h"
#include "engine/planning/contact/interactive_contact_birrt.h"
#include "engine/planning/direct_planner.h"
#include "engine/planning/fine/multi_layer_planner.h"
#include "engine/planning/interactive/hand_partner.h"
#include "engine/planning/interactive/hand_planner.h"
#include "engine/planning/ompl/ompl_planner.h"
#include "engine/planning/planner.h"
#include "engine/planning/rrt.h"
#include "engine/planning/threaded_planner.h"

namespace glissade {
namespace {

PlannerEntry interactive(std::string id, CatalogueText label, CatalogueText description, OperatorUse use) {
  return {std::move(id),
          label,
          description,
          use != OperatorUse::None,
          true,
          [use](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
            return std::make_unique<InteractiveContactBirrt>(problem, seed, use);
          }};
}

PlannerEntry multiLayer(const std::string& id, CatalogueText label, CatalogueText description) {
  const bool loops = id == "gts" || id == "own";
  return {id,
          label,
          description,
          loops,
          loops,
          [id](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
            return std::make_unique<MultiLayerPlanner>(problem, seed, rulesOf(problem, id));
          },
          true};
}

void addFirstPapersPlanners(PlannerRegistry& registry) {
  registry.add(interactive(
      "contact-birrt", GLISSADE_TEXT("Interactive with contact"),
      GLISSADE_TEXT("Algorithm 1 as printed (Blin et al. 2016): you steer the object and the computer searches with "
                    "you; near an obstacle the object slides on it."),
      OperatorUse::GuideAndContact));
  registry.add(interactive("birrt", GLISSADE_TEXT("RRT-Connect"),
                           GLISSADE_TEXT("The computer alone: two trees that grow towards each other, with contact "
                                         "sampling. The same planner with a computer share of 1."),
                           OperatorUse::None));
}

void addOmplPlanners(PlannerRegistry& registry) {
  const auto add = [&](std::string id, CatalogueText label, CatalogueText description, OmplAlgorithm algorithm) {
    registry.add({std::move(id), label, description, false, true,
                  [algorithm](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                    return std::make_unique<OmplPlanner>(problem, seed, algorithm);
                  }});
  };
  add("ompl-rrtconnect", GLISSADE_TEXT("RRT-Connect (OMPL)"),
      GLISSADE_TEXT("Two trees that grow towards each other (Kuffner and LaValle 2000)."), OmplAlgorithm::RrtConnect);
  add("ompl-bkpiece", GLISSADE_TEXT("BKPIECE"),
      GLISSADE_TEXT("Two trees that grow from the border of the cells explored (Sucan and Kavraki 2009), of OMPL."),
      OmplAlgorithm::Bkpiece);
  add("ompl-prm", GLISSADE_TEXT("PRM"), GLISSADE_TEXT("A roadmap of the whole space (Kavraki et al. 1996), of OMPL."),
      OmplAlgorithm::Prm);
  add("ompl-est", GLISSADE_TEXT("EST"),
      GLISSADE_TEXT("One tree that grows where it is sparse (Hsu et al. 1999), of OMPL."), OmplAlgorithm::Est);
}

}  // namespace

void PlannerRegistry::add(PlannerEntry entry) { entries_.push_back(std::move(entry)); }

const PlannerEntry* PlannerRegistry::find(std::string_view id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::string> idsOf(const PlannerRegistry& registry) {
  std::vector<std::string> ids;
  for (const PlannerEntry& entry : registry.entries()) ids.push_back(entry.id);
  return ids;
}

PlannerEntry withScrewMotions(PlannerEntry entry) {
  entry.make = [make = std::move(entry.make)](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
    if (problem.world->threads().empty()) return make(problem, seed);
    return std::make_unique<ThreadedPlanner>(
        problem, [make, seed](const Problem& rest) { return make(rest, seed); },
        std::make_unique<MarkedThreadWays>(problem.world));
  };
  return entry;
}

Diagnostic unknownPlanner(const std::string& id, const Message& advice) {
  if (id.starts_with(kPeerPrefix)) {
    return {ErrorKind::Usage,
            "",
            "",
            {GLISSADE_TEXT("'%1' is a planner for comparison, which only glissade-cli has"), {id}},
            GLISSADE_TEXT("Run it with 'glissade-cli plan', 'replay' or 'study', or choose another strategy.")};
  }
  return {ErrorKind::Usage, "", "", {GLISSADE_TEXT("there is no planner '%1'"), {id}}, advice};
}

namespace {

PlannerRegistry allWholePlanners() {
  PlannerRegistry registry;
  registry.add(
      {"auto", GLISSADE_TEXT("Automatic"),
       GLISSADE_TEXT(
           "Several planners work side by side; those that make progress get more time. No settings are needed."),
       false, true, [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
         return std::make_unique<AutomaticPlanner>(problem, seed);
       }});
  registry.add(
      {"by-hand", GLISSADE_TEXT("With my hand"),
       GLISSADE_TEXT("You steer the object. The way of your hand is kept and certified, and the computer searches "
                     "from it; at α = 1 the automatic planners finish the path."),
       true, true,
       [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
         return std::make_unique<HandPlanner>(problem, seed);
       },
       false, true});
  registry.add(
      {"interactive", GLISSADE_TEXT("Interactive"),
       GLISSADE_TEXT(
           "You steer the object, and the automatic planners search along the way that you show. Without your hand "
           "it is the automatic strategy."),
       true, true, [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
         return std::make_unique<AutomaticPlanner>(problem, seed, std::thread::hardware_concurrency(),
                                                   std::make_unique<HandPartner>(problem, seed));
       }});
  addFirstPapersPlanners(registry);
  registry.add(interactive(
      "interactive-birrt", GLISSADE_TEXT("Interactive without contact"),
      GLISSADE_TEXT("Operator and computer share the iterations, no contact sampling (Blin et al. 2016, table I)."),
      OperatorUse::Guide));
  registry.add(interactive(
      "contact-following-birrt", GLISSADE_TEXT("Interactive, contact that follows"),
      GLISSADE_TEXT("Near an obstacle the object follows its surfaces from one contact to the next, and turns "
                    "as they make it turn."),
      OperatorUse::GuideAndFollow));
  registry.add(interactive("contact-first-birrt", GLISSADE_TEXT("Interactive, contact first"),
                           GLISSADE_TEXT("As the papers' software of 2016: near an obstacle contact sampling comes "
                                         "before the draw by computer share."),
                           OperatorUse::ContactFirst));
  registry.add({"g", GLISSADE_TEXT("G"),
                GLISSADE_TEXT("One RRT in the whole workspace (Cailhol et al. 2019, section 6.1)."), false, false,
                [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                  return std::make_unique<Rrt>(problem, seed, Rrt::Limit::GlobalSamples);
                }});
  registry.add(multiLayer(
      "gt", GLISSADE_TEXT("GT"),
      GLISSADE_TEXT("The shortest path through the places, RRT in each of them (Cailhol et al. 2019, section 6.1).")));
  registry.add(multiLayer("gts1", GLISSADE_TEXT("GTS1"),
                          GLISSADE_TEXT("Holes of the object's shape and easy places "
                                        "first (Cailhol et al. 2019, section 6.2).")));
  registry.add(multiLayer("gts2", GLISSADE_TEXT("GTS2"),
                          GLISSADE_TEXT("Holes that the object fits and easy places "
                                        "first (Cailhol et al. 2019, section 6.2, table 1).")));
  registry.add(multiLayer("gts", GLISSADE_TEXT("Layers"),
                          GLISSADE_TEXT("Geometry, places and semantics (GTS): the object goes through the passages "
                                        "that it fits best, and takes the next best path where one fails.")));
  registry.add(multiLayer("own", GLISSADE_TEXT("Own rules"), GLISSADE_TEXT("The rules of the scenario.")));
  addOmplPlanners(registry);
  return registry;
}

}  // namespace

PlannerRegistry makePlannerRegistry() {
  PlannerRegistry registry;
  const PlannerRegistry plain = allWholePlanners();
  for (const PlannerEntry& entry : plain.entries()) registry.add(withScrewMotions(entry));
  return registry;
}

PlannerRegistry makeLocalPlannerRegistry() {
  PlannerRegistry registry;
  registry.add({"linear", GLISSADE_TEXT("Linear interpolation"),
                GLISSADE_TEXT("The straight motion, where it is free."), false, false,
                [](const Problem& problem, std::uint64_t) -> std::unique_ptr<Planner> {
                  return std::make_unique<LinearPlanner>(problem);
                }});
  registry.add({"rrt", GLISSADE_TEXT("RRT"), GLISSADE_TEXT("One tree (LaValle 1998)."), false, true,
                [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                  return std::make_unique<Rrt>(problem, seed);
                }});
  registry.add({"potential-field", GLISSADE_TEXT("Potential field"),
                GLISSADE_TEXT("Down the slope to the goal (Khatib 1985)."), false, false,
                [](const Problem& problem, std::uint64_t) -> std::unique_ptr<Planner> {
                  return std::make_unique<PotentialFieldPlanner>(problem);
                }});
  addFirstPapersPlanners(registry);
  addOmplPlanners(registry);
  return registry;
}

}  // namespace glissade
