#include <algorithm>
#include <set>

#include "engine/check/plan_demands.h"
#include "engine/check/plan_verdict.h"

namespace glissade::check {
namespace {

/// Checks that the plan and the product have the same bodies, each once.
void compareBodies(const Product& product, const Plan& plan, std::vector<std::string>& wrong) {
  std::set<std::string> ofProduct;
  for (const Body& body : product.bodies) ofProduct.insert(body.id);
  std::set<std::string> listed;
  for (const std::string& id : plan.bodies) {
    if (!listed.insert(id).second) wrong.push_back("the plan lists '" + id + "' twice");
    if (ofProduct.count(id) == 0) wrong.push_back("the plan lists '" + id + "', which is not a body of the product");
  }
  for (const std::string& id : ofProduct) {
    if (listed.count(id) == 0) wrong.push_back("the product has '" + id + "', which the plan does not list");
  }
  std::set<std::string> staying;
  for (const std::string& id : plan.staying) {
    if (listed.count(id) == 0) wrong.push_back("'" + id + "' is said to stay and is none of the plan's bodies");
    if (!staying.insert(id).second) wrong.push_back("'" + id + "' is said to stay twice");
  }
}

void compareNumber(const char* what, const std::optional<std::uint64_t>& claimed, std::size_t found,
                   std::vector<std::string>& wrong) {
  if (!claimed || *claimed == found) return;
  wrong.push_back(std::string(GLISSADE_TEXT("the plan states \"")) + what + "\": " + std::to_string(*claimed) + ", and there are " +
                  std::to_string(found));
}

/// Finds demands on names that no body has: they would not be checked.
void findNamesOfNothing(const Product& product, const Demands& demands, std::vector<std::string>& wrong) {
  std::vector<std::string> names;
  const auto add = [&](const std::vector<std::string>& some) { names.insert(names.end(), some.begin(), some.end()); };
  for (const auto& together : demands.together) add(together);
  for (const auto& [first, then] : demands.before) add({first, then});
  for (const Demands::Place& place : demands.places) add(place.bodies);
  for (const Demands::Motion& motion : demands.motions) add(motion.bodies);
  for (const auto& [body, direction] : demands.forbidden) add({body});
  for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
    if (!bodiesNamed(product, name).empty()) continue;
    wrong.push_back("a demand is about '" + name + "', which no body or assembly is called: it is not judged");
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

std::vector<std::string> wrongClaims(const Product& product, const Plan& plan, std::size_t apart) {
  std::vector<std::string> wrong;
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
  if (plan.certified && !*plan.certified && proved) wrong.emplace_back(GLISSADE_TEXT("the plan states that it is not certified"));
  if (plan.certified && *plan.certified && !proved) {
    wrong.emplace_back(GLISSADE_TEXT("the plan states that it is certified, and a step says that it is not"));
  }
  if (plan.end == "complete" && parts == 0) {
    wrong.emplace_back(GLISSADE_TEXT("the plan is called complete, and all of its bodies stay: nothing is taken apart"));
  } else if (plan.end == "complete" && removed < parts) {
    wrong.push_back("the plan is called complete, and " + std::to_string(parts - removed) + " of " +
                    std::to_string(parts) + " parts have no step");
  }
  return wrong;
}

}  // namespace glissade::check
