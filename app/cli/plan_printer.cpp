#include "app/cli/plan_printer.h"

#include <algorithm>
#include <iostream>

#include "app/cli/text_cells.h"
#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"
#include "engine/documents/plan_tasks.h"
#include "engine/documents/plan_words.h"
#include "engine/sequence/accepted_clashes.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/subassembly_lines.h"

namespace glissade::cli {
namespace {

/// Prints the texts about a plan in a language.
class PlanPrinter {
 public:
  PlanPrinter(const AssembledProduct& product, const Console& console)
      : product_(product), console_(console), words_(console.language, inMillimetres) {}

  void print(const AssemblyPlan& plan, double seconds) const;

 private:
  void printSteps(const std::vector<AssemblyStep>& steps, const std::string& group, const std::string& before) const;
  void printNotes(const StepMotion& motion, const std::vector<Allowance>& allowances, const std::string& before) const;
  void printStuck(const std::vector<StuckBody>& all, const std::string& before) const;
  void printLines(const std::vector<SubassemblyLine>& lines, std::size_t steps, const std::string& group,
                  const std::string& before) const;
  Message motionOf(const StepMotion& motion) const;
  const std::string& nameOf(const BodyId& id) const { return product_.body(id).shown(); }
  void printIndented(const std::string& before, const Message& line) const;

  const AssembledProduct& product_;
  const Console& console_;
  PlanWords words_;
};

void PlanPrinter::printIndented(const std::string& before, const Message& line) const {
  std::cout << before;
  console_.print(line);
}

/// "straight, clearance 0.5 mm to 'plate'"
Message PlanPrinter::motionOf(const StepMotion& motion) const {
  Message text = methodInWords(motion.method);
  if (!motion.certified) text = {GLISSADE_TEXT("%1, not certified"), {text}};
  if (motion.proof.nearest.empty()) return text;
  return {GLISSADE_TEXT("%1, clearance %2 to '%3'"),
          {text, Length{motion.proof.minClearance}, nameOf(motion.proof.nearest)}};
}

/// Prints the steps with the numbers of the order of assembly, as in documents; the motions of a step of several are
/// below it. `group`: number of the step that adds the group of these steps.
void PlanPrinter::printSteps(const std::vector<AssemblyStep>& steps, const std::string& group,
                             const std::string& before) const {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const AssemblyStep& step = steps[i];
    const std::string number = toRight(stepNumber(steps.size() - 1 - i, group), 4) + "  ";
    const bool isOne = step.motions.size() == 1;
    if (!isOne) std::cout << before << number << nameOfStep(step, product_) << "\n";
    for (const StepMotion& motion : step.motions) {
      std::string names = (isOne ? number : std::string(6, ' ')) + namesOf(motion.bodies(), product_, " + ");
      if (motion.fastener != FastenerKind::None) {
        names += " (" + console_.text(CatalogueText{kFastenerNames.of(motion.fastener)}) + ")";
      }
      printIndented(before, {GLISSADE_TEXT("%1: %2"), {names, motionOf(motion)}});
      printNotes(motion, allowancesInOrder(steps, i, motion), before + (isOne ? "      " : "        "));
    }
    for (const std::string& text : words_.violations(step, product_)) {
      printIndented(before + "      ", {GLISSADE_TEXT("forced, although: %1"), {text}});
    }
  }
}

/// Prints what is to be said of a motion beside its path.
void PlanPrinter::printNotes(const StepMotion& motion, const std::vector<Allowance>& allowances,
                             const std::string& before) const {
  for (const std::string& text : words_.joints(motion, product_, PlanOrder::Removal)) {
    std::cout << before << text << "\n";
  }
  if (motion.tool.kind != ToolKind::None) {
    printIndented(before, {GLISSADE_TEXT("tool: %1"), {words_.tool(motion, product_)}});
  }
  for (const BodyId& id : motion.falling) {
    printIndented(before, {GLISSADE_TEXT("support: %1"), {nameOf(id)}});
  }
  for (const Allowance& allowance : allowances) {
    printIndented(before, {GLISSADE_TEXT("allowance: %1"), {allowance.text}});
  }
}

void PlanPrinter::printStuck(const std::vector<StuckBody>& all, const std::string& before) const {
  for (const StuckBody& stuck : all) {
    Message line{GLISSADE_TEXT("stuck: %1"), {nameOf(stuck.body)}};
    if (!stuck.blockedBy.empty()) {
      line = {GLISSADE_TEXT("%1, blocked by %2"), {line, namesOf(stuck.blockedBy, product_, ", ")}};
    }
    if (!stuck.reason.empty()) line = {GLISSADE_TEXT("%1: %2"), {line, stuck.reason}};
    printIndented(before, line);
  }
}

/// Prints the lines of groups. `before` indents them: "  " at first, more for groups in groups.
void PlanPrinter::printLines(const std::vector<SubassemblyLine>& lines, std::size_t steps, const std::string& group,
                             const std::string& before) const {
  for (const SubassemblyLine& line : lines) {
    const std::string number = stepNumber(steps - line.step, group);
    printIndented(before, {GLISSADE_TEXT("the group of step %1 is disassembled off %2:"),
                           {number, namesOf(line.staying, product_, " ")}});
    printSteps(line.steps, number, before);
    printStuck(line.stuck, before);
    printLines(line.lines, line.steps.size(), number, before + "  ");
  }
}

/// "+y", or "0.5 0 0.866".
std::string axisInWords(const Vector3& direction) {
  constexpr const char* kAxes = "xyz";
  int axis = 0;
  const double most = direction.cwiseAbs().maxCoeff(&axis);
  if (most > 1.0 - 1e-6) return std::string(1, direction[axis] > 0.0 ? '+' : '-') + kAxes[axis];
  // Adding zero makes 0 of -0.
  const Vector3 digits = (1000.0 * direction).array().round() / 1000.0 + 0.0;
  return rounded(digits.x()) + " " + rounded(digits.y()) + " " + rounded(digits.z());
}

/// The number of screws in bodies that have no hole for them in the file.
std::size_t screwHoles(const AssemblyPlan& plan) {
  std::size_t holes = 0;
  for (const StepMotion* motion : allMotionsOf(plan)) {
    holes += static_cast<std::size_t>(
        std::count_if(motion->allowances.begin(), motion->allowances.end(),
                      [](const Allowance& each) { return each.hollow && each.kind == ContactKind::Thread; }));
  }
  return holes;
}

/// "12 of 13 parts leave in 10 steps, every motion certified", with the number of flexible parts without a proof.
Message stepsInWords(const AssemblyPlan& plan) {
  const Message steps{GLISSADE_TEXT("%1 of %2 {2|part|parts} removed in %3 {3|step|steps}"),
                      {plan.removed(), plan.parts(), plan.steps.size()}};
  if (plan.removed() == 0) return steps;
  const std::size_t open = plan.removedWithoutProof();
  if (open == 0) return {GLISSADE_TEXT("%1, every motion certified"), {steps}};
  return {GLISSADE_TEXT("%1, every motion certified but those of %2 flexible {2|part|parts}"), {steps, open}};
}

void PlanPrinter::print(const AssemblyPlan& plan, double seconds) const {
  for (const AcceptedClash& clash : acceptedClashesOf(plan)) {
    console_.print({GLISSADE_TEXT("accepted clash: %1"), {inWords(clash, product_)}});
  }
  if (!plan.staying.empty()) console_.print({GLISSADE_TEXT("base: %1"), {words_.base(plan, product_)}});
  if (!plan.up.isApprox(Vector3::UnitZ()))
    console_.print({GLISSADE_TEXT("up, in the file: %1"), {axisInWords(plan.up)}});
  printSteps(plan.steps, "", "");
  printLines(plan.lines, plan.steps.size(), "", "  ");
  printStuck(plan.stuck, "");
  if (const std::string isolated = words_.isolated(plan, product_); !isolated.empty()) {
    console_.print(Message(isolated));
  }
  if (plan.parts() == 0) {
    console_.print(
        GLISSADE_TEXT("nothing can be removed: every body is fixed as base, or a joint holds it to the base. See "
                      "'glissade-cli joints', and dissolve a joint in a scenario."));
  }
  const std::size_t apart = bodiesApart(plan);
  if (apart < plan.removed()) {
    console_.print(
        {GLISSADE_TEXT("%1 of the removed parts are in groups that are not disassembled"), {plan.removed() - apart}});
  }
  console_.print({GLISSADE_TEXT("%1, computed in %2 s"), {stepsInWords(plan), rounded(seconds)}});
  if (const std::size_t holes = screwHoles(plan); holes > 0) {
    console_.print(
        {GLISSADE_TEXT("screws in bodies without a tapped hole in the file, each of which makes its own: %1"),
         {holes}});
  }
}

}  // namespace

std::string namesOf(const std::vector<BodyId>& ids, const AssembledProduct& product, const char* separator) {
  std::string names;
  for (const BodyId& id : ids) names += (names.empty() ? "" : separator) + product.body(id).shown();
  return names;
}

void printPlan(const AssemblyPlan& plan, const AssembledProduct& product, double seconds, const Console& console) {
  PlanPrinter(product, console).print(plan, seconds);
}

}  // namespace glissade::cli
