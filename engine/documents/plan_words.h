#pragma once

#include <functional>
#include <string>

#include "engine/base/message.h"
#include "engine/documents/document_words.h"
#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade {

/// Result of the independent check for a step.
enum class StepCheck { NotAsked, Agrees, Disagrees };

/// The result of the independent check of a plan.
struct PlanCheck {
  std::vector<StepCheck> steps{};     ///< check of each step; empty: not checked
  std::vector<Message> conditions{};  ///< conditions that only the plan states and on which the check rests

  bool operator==(const PlanCheck&) const = default;
};

/// The texts about an assembly plan, in the language of the user.
class PlanWords {
 public:
  /// Formats a length for people: "24.0 mm".
  using LengthText = std::function<std::string(double metres)>;

  PlanWords(Language language, LengthText length) : words_(language), length_(std::move(length)) {}

  const DocumentWords& words() const { return words_; }
  std::string length(double metres) const { return length_(metres); }
  /// A number of turns, with one decimal.
  std::string turns(double turns) const;
  /// A direction: "up (+Z)", "(0.50, 0.00, 0.87)".
  std::string direction(const Vector3& direction) const;
  /// The bodies that stay.
  std::string base(const AssemblyPlan& plan, const AssembledProduct& product) const;
  /// A warning of the bodies that touch nothing; empty: there are none.
  std::string isolated(const AssemblyPlan& plan, const AssembledProduct& product) const;
  /// The path of a motion: "up (+Z), 62.0 mm". In the order of assembly the reversed path is described.
  std::string path(const StepMotion& motion, PlanOrder order) const;
  /// The paths of the motions of a step.
  std::string motion(const AssemblyStep& step, PlanOrder order) const;
  /// The work on the joints of a motion, one entry for each: "turn out screw ISO 4762 M3x8, 9.5 turns".
  std::vector<std::string> joints(const StepMotion& motion, const AssembledProduct& product, PlanOrder order) const;
  /// The work of a step in one line: for each motion joints(), or its path where it has no joint.
  std::string work(const AssemblyStep& step, const AssembledProduct& product, PlanOrder order) const;
  /// The tool that holds the other side of the joint: "hex key"; empty where none is known.
  std::string heldWith(const StepMotion& motion) const { return nameOf(motion.tool.heldWith); }
  /// The tool: "hex key 2.5"; empty where the motion needs none.
  std::string toolName(const StepMotion& motion) const;
  /// The tool, with the bodies that block it: "socket 13, blocked by plate"; and with what is held: "socket 13, bolt
  /// is held (hex key)".
  std::string tool(const StepMotion& motion, const AssembledProduct& product) const;
  /// The parts that must be held: "hold rod, bolt and 3 more"; empty where no part falls.
  std::string standing(const AssemblyStep& step, const AssembledProduct& product) const;
  /// All these parts with the reason, as a sentence.
  std::string support(const AssemblyStep& step, const AssembledProduct& product, PlanOrder order) const;
  /// The rules that a step violates at the place that a person has given it, one entry for each: "nuts still on it:
  /// nut, nut#2".
  std::vector<std::string> violations(const AssemblyStep& step, const AssembledProduct& product) const;
  /// The allowances, one entry for each: "taken 0.0206 mm thinner in the hole of nut (cylindrical)".
  std::vector<std::string> allowances(const std::vector<Allowance>& allowances, const AssembledProduct& product) const;

 private:
  std::string joint(const StepJoint& joint, const StepMotion& motion, const AssembledProduct& product,
                    PlanOrder order) const;
  std::string turnedPath(const StepMotion& motion, PlanOrder order) const;
  std::string nameOf(ToolKind kind) const;
  std::string allOf(const std::vector<BodyId>& ids, const AssembledProduct& product) const;
  std::string someOf(const std::vector<BodyId>& ids, const AssembledProduct& product) const;

  DocumentWords words_;
  LengthText length_;
};

/// Short names of the bodies of a step, in the order of assembly: "bolt", or "bolt, washer, nut".
std::string nameOfStep(const AssemblyStep& step, const AssembledProduct& product);

/// The displayed name of the body with this id; the id where the product has no such body.
std::string shownNameOf(const BodyId& id, const AssembledProduct& product);

/// The name without the number that distinguishes equal names: "nut" of "nut#2".
std::string kindOfPart(const std::string& name);
/// The file's name for the product of a body, without that number.
std::string kindOfPart(std::size_t body, const AssembledProduct& product);

/// A name with its count, "4 × nut", or only "nut" for one.
std::string countedName(const std::string& name, std::size_t count);

}  // namespace glissade
