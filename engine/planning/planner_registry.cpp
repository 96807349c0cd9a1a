#include <algorithm>

#include "engine/collision/thread_rule.h"
#include "engine/planning/automatic/automatic_planner.h"
#include "engine/planning/contact/interactive_contact_birrt.h"
#include "engine/planning/direct_planner.h"
#include "engine/planning/fine/multi_layer_planner.h"
#include "engine/planning/interactive/hand_partner.h"
#include "engine/planning/ompl/ompl_planner.h"
#include "engine/planning/planner.h"
#include "engine/planning/rrt.h"
#include "engine/planning/threaded_planner.h"

namespace glissade {
namespace {

PlannerEntry interactive(std::string id, std::string label, std::string description, OperatorUse use) {
  return {std::move(id),
          std::move(label),
          std::move(description),
          use != OperatorUse::None,
          true,
          [use](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
            return std::make_unique<InteractiveContactBirrt>(problem, seed, use);
          }};
}

PlannerEntry multiLayer(const std::string& id, std::string label, std::string description) {
  const bool loops = id == "gts" || id == "own";
  return {id,
          std::move(label),
          std::move(description),
          loops,
          loops,
          [id](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
            return std::make_unique<MultiLayerPlanner>(problem, seed, rulesOf(problem, id));
          },
          true};
}

void addFirstPapersPlanners(PlannerRegistry& registry) {
  registry.add(
      interactive("contact-birrt", "Interactive with contact (paper)",
                  "You steer the object and the computer searches with you; near an obstacle the object slides "
                  "on it (Blin et al. 2016, Algorithm 1).",
                  OperatorUse::GuideAndContact));
  registry.add(interactive("birrt", "Two trees, without you",
                           "The computer alone: the same planner with an authority of 1.", OperatorUse::None));
}

void addOmplPlanners(PlannerRegistry& registry) {
  const auto add = [&](std::string id, std::string label, std::string description, OmplAlgorithm algorithm) {
    registry.add({std::move(id), std::move(label), std::move(description), false, true,
                  [algorithm](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                    return std::make_unique<OmplPlanner>(problem, seed, algorithm);
                  }});
  };
  add("ompl-rrtconnect", "Two trees of OMPL (RRT-Connect)",
      "Two trees that grow towards each other (Kuffner and LaValle 2000).", OmplAlgorithm::RrtConnect);
  add("ompl-bkpiece", "Cells explored, of OMPL (BKPIECE)",
      "Two trees that grow from the border of the cells explored (Sucan and Kavraki 2009).", OmplAlgorithm::Bkpiece);
  add("ompl-prm", "Roadmap of OMPL (PRM)", "A roadmap of the whole space (Kavraki et al. 1996).", OmplAlgorithm::Prm);
  add("ompl-est", "One tree of OMPL (EST)", "One tree that grows where it is sparse (Hsu et al. 1999).",
      OmplAlgorithm::Est);
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

Diagnostic unknownPlanner(const std::string& id, std::string advice) {
  if (id.starts_with(kPeerPrefix)) {
    return {ErrorKind::Usage, "", "", "'" + id + "' is a planner for comparison, which only glissade-cli has",
            "Run it with 'glissade-cli plan', 'replay' or 'study', or choose another strategy."};
  }
  return {ErrorKind::Usage, "", "", "there is no planner '" + id + "'", std::move(advice)};
}

namespace {

PlannerRegistry allWholePlanners() {
  PlannerRegistry registry;
  registry.add({"auto", "Automatic",
                "Several planners work side by side; those that make progress get more time. No settings are needed.",
                false, true, [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                  return std::make_unique<AutomaticPlanner>(problem, seed);
                }});
  registry.add(
      {"interactive", "Interactive",
       "You steer the object, and the automatic planners search along the way that you show. Without your hand "
       "it is the automatic strategy.",
       true, true, [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
         return std::make_unique<AutomaticPlanner>(problem, seed, std::thread::hardware_concurrency(),
                                                   std::make_unique<HandPartner>(problem, seed));
       }});
  addFirstPapersPlanners(registry);
  registry.add(interactive("interactive-birrt", "Interactive without contact",
                           "Operator and computer share authority, no contact sampling (Blin et al. 2016, table I).",
                           OperatorUse::Guide));
  registry.add(interactive("contact-following-birrt", "Interactive, contact that follows",
                           "Near an obstacle the object follows its surfaces from one contact to the next, and turns "
                           "as they make it turn.",
                           OperatorUse::GuideAndFollow));
  registry.add(interactive("contact-first-birrt", "Interactive, contact first",
                           "As the papers' software of 2016: near an obstacle contact sampling pre-empts the "
                           "authority draw.",
                           OperatorUse::ContactFirst));
  registry.add({"g", "One tree (G)", "One RRT in the whole workspace (Cailhol et al. 2019, section 6.1).", false, false,
                [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                  return std::make_unique<Rrt>(problem, seed, Rrt::Limit::GlobalSamples);
                }});
  registry.add(multiLayer("gt", "Shortest way through places (GT)",
                          "The shortest way through the places, RRT in each of them "
                          "(Cailhol et al. 2019, section 6.1)."));
  registry.add(multiLayer("gts1", "Places: holes of the same shape (GTS1)",
                          "Holes of the object's shape and easy places "
                          "first (Cailhol et al. 2019, section 6.2)."));
  registry.add(multiLayer("gts2", "Places: holes that fit (GTS2)",
                          "Holes that the object fits and easy places "
                          "first (Cailhol et al. 2019, section 6.2, table 1)."));
  registry.add(multiLayer("gts", "Layers",
                          "Geometry, places and semantics (GTS): the object goes through the passages that "
                          "it fits best, and takes the next best way where one fails."));
  registry.add(multiLayer("own", "Places: own rules", "The rules of the scenario."));
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
  registry.add({"linear", "Linear interpolation", "The straight motion, where it is free.", false, false,
                [](const Problem& problem, std::uint64_t) -> std::unique_ptr<Planner> {
                  return std::make_unique<LinearPlanner>(problem);
                }});
  registry.add({"rrt", "RRT", "One tree (LaValle 1998).", false, true,
                [](const Problem& problem, std::uint64_t seed) -> std::unique_ptr<Planner> {
                  return std::make_unique<Rrt>(problem, seed);
                }});
  registry.add({"potential-field", "Potential field", "Down the slope to the goal (Khatib 1985).", false, false,
                [](const Problem& problem, std::uint64_t) -> std::unique_ptr<Planner> {
                  return std::make_unique<PotentialFieldPlanner>(problem);
                }});
  addFirstPapersPlanners(registry);
  addOmplPlanners(registry);
  return registry;
}

}  // namespace glissade
