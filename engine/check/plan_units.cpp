#include "engine/check/plan_units.h"

#include <algorithm>
#include <set>

#include "engine/check/evidence_names.h"
#include "engine/check/plan_demands.h"
#include "engine/check/verdict_words.h"
#include "engine/evidence/pulled_thread.h"

namespace glissade::check {
namespace {

using Ids = std::set<std::string>;

Ids idsOf(const std::vector<std::string>& ids) { return {ids.begin(), ids.end()}; }

/// "'a', 'b', 'c'" or, for many, "'a', 'b', 'c', … (17)".
Message shortListOf(const Ids& ids, const Product& product) {
  constexpr std::size_t kMostNames = 3;
  std::vector<std::string> names;
  std::size_t count = 0;
  for (const Body& body : product.bodies) {
    if (ids.count(body.id) != 0 && ++count <= kMostNames) names.push_back(body.name);
  }
  const Message words = namesInWords(names);
  return count <= kMostNames ? words : Message{GLISSADE_TEXT("%1, … (%2)"), {words, count}};
}

const Body* bodyOf(const std::string& id, const Product& product) {
  for (const Body& body : product.bodies) {
    if (body.id == id) return &body;
  }
  return nullptr;
}

/// True if a person says that both belong to one unit, or if one is pressed into the other.
bool areJoined(const std::string& one, const std::string& other, const Product& product, PlacedBodies& placed) {
  const auto isIn = [](const std::vector<std::string>& unit, const std::string& id) {
    return std::find(unit.begin(), unit.end(), id) != unit.end();
  };
  const auto& units = product.joints.units;
  if (std::any_of(units.begin(), units.end(), [&](const auto& unit) { return isIn(unit, one) && isIn(unit, other); })) {
    return true;
  }
  const Body* a = bodyOf(one, product);
  const Body* b = bodyOf(other, product);
  return a != nullptr && b != nullptr && isPressedIn(placed.at({*a, a->X_WB}), placed.at({*b, b->X_WB}));
}

/// True if the bodies are connected by such joints.
bool isUnit(const Ids& ids, const Product& product, PlacedBodies& placed) {
  Ids reached{*ids.begin()};
  std::vector<std::string> open{*ids.begin()};
  while (!open.empty()) {
    const std::string one = open.back();
    open.pop_back();
    for (const std::string& other : ids) {
      if (reached.count(other) != 0 || !areJoined(one, other, product, placed)) continue;
      reached.insert(other);
      open.push_back(other);
    }
  }
  return reached.size() == ids.size();
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
      const auto line = std::find_if(lines.begin(), lines.end(), [&](const Line& each) { return each.step == i + 1; });
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
      for (const std::string& id : step.bodies) remaining.erase(id);
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
      leaving_.conditions.push_back(areOneUnit(shortListOf(ids, product_)));
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
  return {areFixedAsBase(shortListOf(staying, product))};
}

}  // namespace glissade::check
