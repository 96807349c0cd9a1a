#include "engine/check/plan_units.h"

#include <algorithm>
#include <set>

#include "engine/check/evidence_names.h"
#include "engine/check/plan_demands.h"
#include "engine/evidence/units.h"

namespace glissade::check {
namespace {

using Ids = std::set<BodyId>;

Ids idsOf(const std::vector<BodyId>& ids) { return {ids.begin(), ids.end()}; }

std::vector<std::string> namesOf(const Ids& ids, const Product& product) {
  std::vector<std::string> names;
  for (const Body& body : product.bodies) {
    if (ids.count(body.id) != 0) names.push_back(body.name);
  }
  return names;
}

/// True if evidence or a person says that the bodies are one unit.
bool isUnit(const Ids& ids, const Product& product, PlacedBodies& placed) {
  std::vector<const Body*> bodies;
  for (const Body& body : product.bodies) {
    if (ids.count(body.id) != 0) bodies.push_back(&body);
  }
  return bodies.size() == ids.size() && areOneUnit(bodies, product.joints.units, placed);
}

class LeavingCount {
 public:
  LeavingCount(const Product& product, PlacedBodies& placed) : product_(product), placed_(placed) {}

  Leaving of(const Plan& plan) {
    addSteps(plan.steps, plan.lines);
    return std::move(leaving_);
  }

 private:
  void addSteps(const std::vector<Step>& steps, const std::vector<Line>& lines) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto line =
          std::find_if(lines.begin(), lines.end(), [&](const Line& each) { return each.step == steps[i].number; });
      if (line == lines.end()) {
        addCluster(idsOf(steps[i].bodies), steps[i].unit);
      } else {
        addLine(*line);
      }
    }
  }

  void addLine(const Line& line) {
    addSteps(line.steps, line.lines);
    Ids remaining = idsOf(line.bodies);
    for (const Step& step : line.steps) {
      for (const BodyId& id : step.bodies) remaining.erase(id);
    }
    addCluster(remaining, remaining == idsOf(line.staying));
  }

  /// Counts a group of bodies that are never taken apart.
  void addCluster(const Ids& ids, bool isSaidToBeUnit) {
    if (ids.size() <= 1 || isSaidToBeUnit) leaving_.apart += ids.size();
    if (ids.size() <= 1) {
      leaving_.alone += ids.size();
    } else if (isUnit(ids, product_, placed_)) {
      leaving_.asUnits += ids.size();
    } else if (isSaidToBeUnit) {
      leaving_.asUnits += ids.size();
      leaving_.conditions.push_back(areOneUnit(namesOf(ids, product_)));
    } else {
      leaving_.inGroups += ids.size();
    }
  }

  const Product& product_;
  PlacedBodies& placed_;
  Leaving leaving_;
};

}  // namespace

Leaving leavingOf(const Plan& plan, const Product& product, PlacedBodies& placed) {
  return LeavingCount(product, placed).of(plan);
}

std::vector<Condition> baseOf(const Plan& plan, const Product& product, PlacedBodies& placed) {
  Ids staying = idsOf(plan.staying);
  if (staying.size() < 2 || isUnit(staying, product, placed)) return {};
  Ids said;
  for (const std::string& name : product.demands.stay) {
    for (const std::size_t body : bodiesNamed(product, name)) said.insert(product.bodies[body].id);
  }
  if (std::includes(said.begin(), said.end(), staying.begin(), staying.end())) return {};
  return {areFixedAsBase(namesOf(staying, product))};
}

}  // namespace glissade::check
