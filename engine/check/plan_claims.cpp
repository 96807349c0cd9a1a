#include <algorithm>
#include <set>

#include "engine/check/plan_demands.h"
#include "engine/check/plan_verdict.h"

namespace glissade::check {
namespace {

/// Checks that the plan and the product have the same bodies, each once.
void compareBodies(const Product& product, const Plan& plan, std::vector<Message>& wrong) {
  std::set<BodyId> ofProduct;
  for (const Body& body : product.bodies) ofProduct.insert(body.id);
  std::set<BodyId> listed;
  for (const BodyId& id : plan.bodies) {
    if (!listed.insert(id).second) wrong.push_back({GLISSADE_TEXT("the plan lists '%1' twice"), {id.text()}});
    if (ofProduct.count(id) == 0)
      wrong.push_back({GLISSADE_TEXT("the plan lists '%1', which is not a body of the product"), {id.text()}});
  }
  for (const BodyId& id : ofProduct) {
    if (listed.count(id) == 0)
      wrong.push_back({GLISSADE_TEXT("the product has '%1', which the plan does not list"), {id.text()}});
  }
  std::set<BodyId> staying;
  for (const BodyId& id : plan.staying) {
    if (listed.count(id) == 0)
      wrong.push_back({GLISSADE_TEXT("'%1' is fixed as base and is none of the plan's bodies"), {id.text()}});
    if (!staying.insert(id).second) wrong.push_back({GLISSADE_TEXT("'%1' is fixed as base twice"), {id.text()}});
  }
}

void compareNumber(const char* what, const std::optional<std::uint64_t>& claimed, std::size_t found,
                   std::vector<Message>& wrong) {
  if (!claimed || *claimed == found) return;
  wrong.push_back({GLISSADE_TEXT("the plan states \"%1\": %2, and there are %3"), {what, *claimed, found}});
}

/// Finds demands on names that no body has: they would not be checked.
void findNamesOfNothing(const Product& product, const Demands& demands, std::vector<Message>& wrong) {
  std::vector<std::string> names;
  const auto add = [&](const std::vector<std::string>& some) { names.insert(names.end(), some.begin(), some.end()); };
  for (const auto& together : demands.together) add(together);
  for (const auto& [first, then] : demands.before) add({first, then});
  for (const Demands::Place& place : demands.places) add(place.bodies);
  for (const Demands::Motion& motion : demands.motions) add(motion.bodies);
  for (const auto& [body, direction] : demands.forbidden) add({body});
  for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
    if (!bodiesNamed(product, name).empty()) continue;
    wrong.push_back(
        {GLISSADE_TEXT("a constraint is about '%1', which is no body or assembly: it is not checked"), {name}});
  }
}

bool areCertified(const std::vector<Step>& steps) {
  return std::all_of(steps.begin(), steps.end(), [](const Step& step) { return step.certified; });
}

bool areCertified(const std::vector<Line>& lines) {
  return std::all_of(lines.begin(), lines.end(),
                     [](const Line& line) { return areCertified(line.steps) && areCertified(line.lines); });
}

}  // namespace

std::vector<Message> wrongClaims(const Product& product, const Plan& plan, std::size_t apart) {
  std::vector<Message> wrong;
  compareBodies(product, plan, wrong);
  findNamesOfNothing(product, plan.demands, wrong);
  findNamesOfNothing(product, product.demands, wrong);
  const std::size_t parts = plan.bodies.size() - std::min(plan.bodies.size(), plan.staying.size());
  std::size_t removed = 0;
  for (const Step& step : plan.steps) removed += step.bodies.size();
  compareNumber("parts", plan.parts, parts, wrong);
  compareNumber("removed", plan.removed, removed, wrong);
  compareNumber("apart", plan.apart, apart, wrong);
  const bool proved = areCertified(plan.steps) && areCertified(plan.lines);
  if (plan.certified && !*plan.certified && proved)
    wrong.emplace_back(GLISSADE_TEXT("the plan states that it is not certified"));
  if (plan.certified && *plan.certified && !proved) {
    wrong.emplace_back(GLISSADE_TEXT("the plan states that it is certified, and a step says that it is not"));
  }
  if (plan.end == "complete" && parts == 0) {
    wrong.emplace_back(
        GLISSADE_TEXT("the plan is called complete, and all of its bodies are fixed as base: nothing is disassembled"));
  } else if (plan.end == "complete" && removed < parts) {
    wrong.push_back({GLISSADE_TEXT("the plan is called complete, and %1 of %2 {2|part|parts} {1|has|have} no step"),
                     {parts - removed, parts}});
  }
  return wrong;
}

}  // namespace glissade::check
