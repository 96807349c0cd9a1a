#pragma once

#include <functional>
#include <string>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/study/study_words.h"

namespace glissade {

/// What the independent check says of a step.
enum class StepCheck { NotAsked, Agrees, Disagrees };

/// The result of the independent check of a plan.
struct PlanCheck {
  std::vector<StepCheck> steps{};         ///< of each step; empty: not asked
  std::vector<std::string> conditions{};  ///< that the plan states itself, and that the check rests on

  bool operator==(const PlanCheck&) const = default;
};

/// What people read of an assembly plan, in their language.
class PlanWords {
 public:
  /// A length as people read it: "24.0 mm".
  using LengthText = std::function<std::string(double metres)>;

  PlanWords(Language language, LengthText length) : words_(language), length_(std::move(length)) {}

  const StudyWords& words() const { return words_; }
  std::string length(double metres) const { return length_(metres); }
  /// "up (+Z)", "(0.50, 0.00, 0.87)".
  std::string direction(const Vector3& direction) const;
  /// What the others are taken off, and why: "plate (the largest part)", "foot (as a person says)".
  std::string base(const AssemblyPlan& plan, const AssembledProduct& product) const;
  /// The motion of a step: "up (+Z), 62.0 mm". The words of assembly are those of the reverse.
  std::string motion(const AssemblyStep& step, PlanOrder order) const;
  /// What is done to the joints of a step: "turn out screw ISO 4762 M3x8, 9.5 turns", an entry each.
  std::vector<std::string> joints(const AssemblyStep& step, const AssembledProduct& product, PlanOrder order) const;
  /// What a fitter does in a step, in one line: joints(), or the motion where nothing is joined.
  std::string work(const AssemblyStep& step, const AssembledProduct& product, PlanOrder order) const;
  /// "hex key 2.5"; empty where the step needs none.
  std::string toolName(const AssemblyStep& step) const;
  /// The same, with what is in its way: "socket 13, blocked by plate".
  std::string tool(const AssemblyStep& step, const AssembledProduct& product) const;
  /// "hold rod, bolt and 3 more"; empty where nothing falls.
  std::string standing(const AssemblyStep& step, const AssembledProduct& product) const;
  /// What a step that a person has put at its place does not keep: "nuts still on it: nut, nut#2", an entry each.
  std::vector<std::string> violations(const AssemblyStep& step, const AssembledProduct& product) const;
  /// "taken 0.0206 mm thinner in the hole of nut (cylindrical)", an entry each.
  std::vector<std::string> allowances(const AssemblyStep& step, const AssembledProduct& product) const;

 private:
  std::string joint(const StepJoint& joint, const AssemblyStep& step, const AssembledProduct& product,
                    PlanOrder order) const;
  std::string turnedMotion(const AssemblyStep& step, PlanOrder order) const;
  std::string someOf(const std::vector<std::string>& ids, const AssembledProduct& product) const;

  StudyWords words_;
  LengthText length_;
};

/// Short names of the bodies that leave in a step: "bolt", or "bolt, nut" of a group.
std::string nameOfStep(const AssemblyStep& step, const AssembledProduct& product);

/// What people see of the body with this id; the id where the product has none.
std::string shownNameOf(const std::string& id, const AssembledProduct& product);

/// The name without the number that tells two of one name apart: "nut" of "nut#2".
std::string kindOfPart(const std::string& name);
/// The name that the file has for the product of a body, without that number.
std::string kindOfPart(std::size_t body, const AssembledProduct& product);

}  // namespace glissade
