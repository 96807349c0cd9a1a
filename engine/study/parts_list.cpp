#include "engine/study/parts_list.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "engine/study/plan_words.h"

namespace glissade {
namespace {

using TextsById = std::map<std::string, std::string>;

void addDesignations(const std::vector<AssemblyStep>& steps, TextsById& designations) {
  for (const AssemblyStep& step : steps) {
    for (const StepJoint& joint : step.joints) {
      if (!joint.designation.empty()) designations[joint.body] = joint.designation;
    }
  }
}

void addDesignations(const std::vector<SubassemblyLine>& lines, TextsById& designations) {
  for (const SubassemblyLine& line : lines) {
    addDesignations(line.steps, designations);
    addDesignations(line.lines, designations);
  }
}

/// Numbers of steps in the order of assembly.
std::map<std::string, std::size_t> stepsByBody(const AssemblyPlan& plan) {
  std::map<std::string, std::size_t> steps;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    for (const std::string& id : plan.steps[i].bodies()) steps[id] = plan.steps.size() - i;
  }
  return steps;
}

}  // namespace

std::vector<PartsListRow> partsList(const AssemblyPlan& plan, const AssembledProduct& product) {
  TextsById designations;
  addDesignations(plan.steps, designations);
  addDesignations(plan.lines, designations);
  const std::map<std::string, std::size_t> stepOf = stepsByBody(plan);
  const std::set<std::string> base(plan.staying.begin(), plan.staying.end());
  std::vector<PartsListRow> rows;
  std::map<std::tuple<std::string, MeshPtr, std::string>, std::size_t> known;
  for (const RigidBody& body : product.bodies) {
    const auto said = designations.find(body.id);
    const std::string designation = said == designations.end() ? std::string() : said->second;
    const std::string name = kindOfPart(body.name);
    const bool isDesignated = !designation.empty();
    const auto [at, isNew] = known.emplace(
        std::tuple(designation, isDesignated ? nullptr : body.mesh, isDesignated ? std::string() : name), rows.size());
    if (isNew) rows.push_back({name, designation});
    PartsListRow& row = rows[at->second];
    ++row.count;
    const auto step = stepOf.find(body.id);
    if (base.count(body.id) != 0) {
      row.hasBase = true;
    } else if (step == stepOf.end()) {
      ++row.withoutStep;
    } else {
      row.steps.push_back(step->second);
    }
  }
  for (PartsListRow& row : rows) {
    std::sort(row.steps.begin(), row.steps.end());
    row.steps.erase(std::unique(row.steps.begin(), row.steps.end()), row.steps.end());
  }
  std::stable_sort(rows.begin(), rows.end(), [](const PartsListRow& a, const PartsListRow& b) {
    return a.designation < b.designation;  // empty ones first
  });
  return rows;
}

}  // namespace glissade
