#include "engine/sequence/stated_units.h"

#include <algorithm>

#include "engine/evidence/units.h"
#include "engine/fits/fit_words.h"
#include "engine/sequence/order_rules.h"

namespace glissade {
namespace {

using Ids = std::vector<BodyId>;
using Names = std::vector<std::string>;

class StatedUnitFinder {
 public:
  StatedUnitFinder(const AssembledProduct& product, std::vector<Ids> said)
      : product_(product), said_(std::move(said)) {}

  void addSteps(const std::vector<AssemblyStep>& steps, const std::vector<SubassemblyLine>& lines) {
    for (const AssemblyStep& step : steps) {
      for (const StepMotion& motion : step.motions) {
        if (motion.unit) add(motion.bodies());
      }
    }
    for (const SubassemblyLine& line : lines) {
      add(line.staying);
      addSteps(line.steps, line.lines);
    }
  }

  bool isUnit(const Ids& ids) {
    std::vector<evidence::Body> bodies;
    for (const std::size_t body : product_.indicesOf(ids)) bodies.push_back(product_.measured(body));
    std::vector<const evidence::Body*> all;
    for (const evidence::Body& body : bodies) all.push_back(&body);
    return ids.size() < 2 || evidence::areOneUnit(all, said_, placed_);
  }

  Names namesOf(const Ids& ids) const {
    Names names;
    for (const BodyId& id : ids) names.push_back(product_.body(id).shown());
    return names;
  }

  std::vector<Names> take() { return std::move(found_); }

 private:
  void add(const Ids& ids) {
    if (!isUnit(ids)) found_.push_back(namesOf(ids));
  }

  const AssembledProduct& product_;
  std::vector<Ids> said_;
  evidence::PlacedBodies placed_;
  std::vector<Names> found_;
};

}  // namespace

StatedUnits statedUnitsOf(const AssemblyPlan& plan, const AssembledProduct& product,
                          const std::vector<JointEdit>& words, const std::vector<std::string>& stay) {
  StatedUnitFinder finder(product, unitsOf(words));
  finder.addSteps(plan.steps, plan.lines);
  BodySet isSaid(product.bodies.size(), false);
  for (const std::string& name : stay) {
    for (const std::size_t body : bodiesNamed(product, name)) isSaid[body] = true;
  }
  const bool isBaseSaid = std::all_of(plan.staying.begin(), plan.staying.end(),
                                      [&](const BodyId& id) { return isSaid[product.indexOf(id)]; });
  StatedUnits stated;
  if (!isBaseSaid && !finder.isUnit(plan.staying)) stated.base = finder.namesOf(plan.staying);
  stated.leaving = finder.take();
  return stated;
}

}  // namespace glissade
