#include "engine/documents/plan_table.h"

#include <algorithm>
#include <cmath>

#include "engine/base/csv_table.h"
#include "engine/base/quantity_text.h"
#include "engine/documents/plan_words.h"
#include "engine/sequence/accepted_clashes.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

double largestAllowance(const std::vector<Allowance>& allowances) {
  double largest = 0.0;
  for (const Allowance& allowance : allowances) largest = std::max(largest, allowance.allowance);
  return largest;
}

/// The names of the bodies in the file, with those of their assemblies.
class FullNames {
 public:
  explicit FullNames(const AssembledProduct& product) : product_(product), paths_(product.tree.shownPaths()) {}

  std::string operator()(const BodyId& id) const {
    const auto node = product_.tree.find(id.text());
    return node ? paths_[*node] : product_.body(id).name;
  }

 private:
  const AssembledProduct& product_;
  std::vector<std::string> paths_;
};

/// Adds a row for each motion of the step.
void addStep(CsvTable& table, const std::vector<AssemblyStep>& steps, std::size_t at, const AssembledProduct& product,
             const FullNames& nameOf, PlanOrder order) {
  const AssemblyStep& step = steps[at];
  const PlanWords words(Language::English, inMillimetres);
  std::string forced;
  for (const std::string& text : words.violations(step, product)) forced += (forced.empty() ? "" : "; ") + text;
  for (const StepMotion* motion : motionsOf(step, order)) {
    double length = 0.0;
    double turn = 0.0;
    for (const MotionLeg& leg : legsOf(motion->path)) {
      length += leg.length;
      turn += leg.turn;
    }
    table.row();
    table.number(static_cast<double>(steps.size() - at));
    std::string parts;
    for (const BodyId& id : motion->bodies()) parts += (parts.empty() ? "" : "; ") + nameOf(id);
    table.text(parts);
    table.text(motion->method);
    table.text(words.path(*motion, order));
    table.number(length);
    table.number(turn);
    table.number(finite(motion->proof.provedClearance));
    table.number(finite(motion->proof.minClearance));
    table.text(motion->proof.nearest.empty() ? "" : nameOf(motion->proof.nearest));
    table.number(largestAllowance(allowancesInOrder(steps, at, *motion)));
    table.number(static_cast<double>(step.wave));
    table.text("");
    table.text(words.tool(*motion, product));
    table.text(words.standing(step, product));
    table.text(forced);
    std::string clashes;
    for (const AcceptedClash& clash : acceptedClashesOf(*motion)) {
      clashes += (clashes.empty() ? "" : "; ") + toString(inWords(clash, product));
    }
    table.text(clashes);
  }
}

void addStuck(CsvTable& table, const StuckBody& stuck, const FullNames& nameOf) {
  std::string blockers;
  for (const BodyId& other : stuck.blockedBy) blockers += (blockers.empty() ? "" : "; ") + nameOf(other);
  table.row();
  table.number(std::nullopt);
  table.text(nameOf(stuck.body));
  for (int column = 0; column < 2; ++column) table.text("");
  for (int column = 0; column < 4; ++column) table.number(std::nullopt);
  table.text("");
  for (int column = 0; column < 2; ++column) table.number(std::nullopt);
  table.text(blockers);
  for (int column = 0; column < 4; ++column) table.text("");
}

}  // namespace

std::string planAsCsv(const AssemblyPlan& plan, const AssembledProduct& product, PlanOrder order) {
  CsvTable table;
  table.header({"step", "part", "method", "motion", "length_m", "turn_rad", "proved_clearance_m", "min_clearance_m",
                "nearest", "allowance_m", "wave", "blocked_by", "tool", "standing", "forced_although",
                "accepted_clashes"});
  const FullNames nameOf(product);
  const std::size_t steps = plan.steps.size();
  for (std::size_t i = 0; i < steps; ++i) {
    const std::size_t step = order == PlanOrder::Assembly ? steps - 1 - i : i;
    addStep(table, plan.steps, step, product, nameOf, order);
  }
  for (const StuckBody& stuck : plan.stuck) addStuck(table, stuck, nameOf);
  return table.content();
}

}  // namespace glissade
